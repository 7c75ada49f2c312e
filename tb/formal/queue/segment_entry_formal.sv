// SPDX-License-Identifier: Apache-2.0
// rtl/queue/segment_entry.sv, for any words: they pass as segments, word by word, of consecutive
// numbers, each from where the one before ended, the first from anywhere; a word passes exactly if
// it is valid by hls/words.hpp, and has the check of those before it in its program, begun with the
// digest; whole segments alone are counted, each with the ticks and last of its own words; a length
// is reported as it passes.
// control: AUX_AS_XYZ s/ \&\& !xyz//
// control: ANY_LAMBDA s/ \&\& {1'b0, k_q} <= lambda//
// control: WIDE_POINT s/PointField-1:FineBits-1\]/PointField-1:FineBits]/g
// control: SHORT_PHI s/assign phi_fits   = positive.*/assign phi_fits = positive;/
// control: TICKS_OF_X s/ticks_o\[31:8\]/ticks_o[31:16], 8'd0/
// control: LAST_STAYS s/last_o   <= /last_o <= last_o || /
// control: NO_RESET s/axis_q <= 4'd0;/axis_q <= axis_q;/
// control: ANY_START s/data_o\[FineBits-1:0\] == end_q ||/1'b1 ||/
// control: SHORT_START s/\[FineBits-1:0\] == end_q/[FineBits-2:0] == end_q[FineBits-2:0]/
// control: ANY_TURN s/(other_turn_q \&\& !xyz)/other_turn_q/
// control: NO_TURN s/(other_turn_q \&\& !xyz)/1'b0/
// control: FIRST_AT_0 s/any_start_q <= 1'b1;/any_start_q <= 1'b0;/
// control: ANY_AFTER_RESET s/else if (pass \&\& complete) any_start_q <= 1'b0;//
// control: NO_CHECK_OF_ADVANCE s/.checked_i(tag_q == words_pkg::TagAdvance)/.checked_i(1'b0)/
// control: ONE_PROGRAM s/.last_i(last_o)/.last_i(1'b0)/
`default_nettype none
module segment_entry_formal #(
    parameter int Splines = 1,
    parameter int AuxAxes = 1
) (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        valid_i,
    input wire logic [47:0] data_i,
    input wire logic [15:0] digest_i,
    input wire logic        cut_i,
    input wire logic        wait_i,
    input wire logic        turn_i,
    input wire logic        ready_i
);

  localparam int CoefBits = 8;  // fewer than a core has: the proof is of the logic
  localparam int FineBits = 4;
  localparam int Last = 16 + 3 * AuxAxes;

  logic ready;
  logic valid;
  logic [47:0] data;
  logic segment;
  logic length;
  logic [31:0] ticks;
  logic last;
  logic [1:0] fault;
  segment_entry #(
      .CoefBits(CoefBits),
      .FineBits(FineBits),
      .AuxAxes (AuxAxes),
      .Splines (Splines)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .valid_i,
      .ready_o(ready),
      .data_i,
      .digest_i,
      .cut_i,
      .wait_i,
      .turn_i,
      .valid_o(valid),
      .ready_i,
      .data_o(data),
      .length_o(length),
      .segment_o(segment),
      .ticks_o(ticks),
      .last_o(last),
      .fault_o(fault)
  );

  logic [4:0] place_q;  // of the word that has to come in its segment
  logic [7:0] segments_q;
  logic held_q;
  logic ends_q;
  // Bits of ticks at the ends: all bits would make this proof too costly.
  logic [1:0] ticks_q[4];
  logic last_q;
  logic spline_q;
  logic [4:0] k_q;
  logic started_q = 1'b0;
  logic pass;
  assign pass = valid && ready_i;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    ends_q    <= rst_ni && pass && place_q == 5'(Last);
    if (!rst_ni) begin
      place_q    <= '0;
      segments_q <= '0;
      held_q     <= 1'b0;
    end else begin
      if (pass) begin
        place_q <= place_q == 5'(Last) ? 5'd0 : place_q + 5'd1;
        if (place_q == 5'(Last)) segments_q <= segments_q + 8'd1;
      end
      if (ready) held_q <= valid_i && !cut_i && fault == 2'b00;
    end
    if (pass) begin
      case (place_q)
        5'd1:    {last_q, k_q, spline_q} <= {data[43:38], data[36]};
        5'd9:    ticks_q[0] <= {data[43], data[36]};
        5'd10:   ticks_q[1] <= {data[43], data[36]};
        5'd14:   ticks_q[2] <= {data[43], data[36]};
        5'd15:   ticks_q[3] <= {data[43], data[36]};
        default: ;
      endcase
    end
  end

  // hls/words.hpp: places and ranges
  logic signed [35:0] coef;
  logic signed [43:0] point;
  assign coef  = data[35:0];
  assign point = data[43:0];
  localparam logic signed [35:0] One = 36'sd1 << (CoefBits - 1);
  localparam logic signed [43:0] Edge = 44'sd1 << (FineBits - 1);
  logic [3:0] tag;
  logic can_be;
  logic coef_fits;
  logic point_fits;
  assign coef_fits  = coef >= -One && coef < One;
  assign point_fits = point >= -Edge && point < Edge;
  // Where the segment before ended, by axis
  logic signed [43:0] stood_q[3 + AuxAxes];
  logic any_q;
  logic turned_q;
  logic [1:0] axis;
  logic follows;
  assign axis = place_q >= 5'd17 ? 2'd3 : place_q >= 5'd12 ? 2'd2 : place_q >= 5'd7 ? 2'd1 : 2'd0;
  assign follows = any_q || (turned_q && axis == 2'd3) || point == stood_q[axis];
  always_ff @(posedge clk_i) begin
    if (pass && tag == 4'd4) stood_q[axis] <= point;
    if (pass && place_q == 5'd5) turned_q <= data[42];
    if (!rst_ni) any_q <= 1'b1;
    else if (pass && place_q == 5'(Last)) any_q <= 1'b0;
  end

  // hls/word_check.hpp
  logic first_q;  // a program's first word has to come
  logic [15:0] crc_q;
  logic [15:0] so_far;
  logic [15:0] crc;
  assign so_far = first_q ? digest_i : crc_q;
  logic [47:0] counted;
  always_comb begin
    counted = data;
    if (tag == 4'd7 || place_q == 5'd4) counted[43:36] = '0;
    crc = {so_far[7:0], 8'b0} ^ {5'b0, so_far[15:8], 3'b0} ^ {8'b0, so_far[15:8]} ^
        {4'b0, counted[43:32]} ^ counted[31:16] ^ counted[15:0];
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      first_q <= 1'b1;
      crc_q   <= '0;
    end else if (pass) begin
      first_q <= place_q == 5'(Last) && last_q;
      crc_q   <= crc;
    end
  end

  always_comb begin
    tag = 4'd0;
    case (place_q)
      5'd0: tag = 4'd1;
      5'd1: tag = 4'd2;
      5'd2, 5'd7, 5'd12, 5'd17: tag = 4'd3;
      5'd3, 5'd8, 5'd13, 5'd18: tag = 4'd4;
      5'd4, 5'd9, 5'd14: tag = 4'd5;
      5'd5, 5'd10, 5'd15: tag = 4'd6;
      default: tag = 4'd7;
    endcase
    can_be = 1'b1;
    case (tag)
      4'd2: begin
        can_be = 1'b0;
        if (data[37:36] == 2'd0) can_be = coef >= 0 && coef < One;
        if (data[37:36] == 2'd1 && Splines == 1) can_be = coef >= One >>> 1 && coef < One;
        if (data[42:38] > 5'd27) can_be = 1'b0;
      end
      4'd3: can_be = point_fits && follows;
      4'd4: can_be = point_fits;
      4'd5: can_be = coef_fits && (place_q != 5'd4 || data[43:36] == segments_q);
      4'd6: begin
        can_be = coef_fits;
        if (place_q == 5'd5 && data[43]) can_be = 1'b0;
        if (place_q == 5'd5 && !spline_q && data[41:36] != '0) can_be = 1'b0;
        if (place_q == 5'd5 && (data[41:36] < {1'b0, k_q} || data[41:36] > 6'd27) && spline_q)
          can_be = 1'b0;
      end
      4'd7: can_be = coef_fits && data[43:36] == (crc[15:8] ^ crc[7:0]);
      default: ;
    endcase
    if (data[47:44] != tag) can_be = 1'b0;
  end

  logic turn;
  assign turn = turn_i || place_q != 5'd0;
  logic [7:0] ends_of_ticks;
  always_comb begin
    for (int n = 0; n < 4; n = n + 1) ends_of_ticks[2*n+:2] = {ticks[8*n+7], ticks[8*n]};
  end
  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      Passes : assert (valid == (held_q && can_be && !cut_i && !wait_i && turn && fault == 2'b00));
      Counted : assert (segment == ends_q);
      Length : assert (length == (pass && place_q == 5'd0));
      if (segment)
        Ticks : assert (ends_of_ticks == {ticks_q[3], ticks_q[2], ticks_q[1], ticks_q[0]});
      if (segment) LastOne : assert (last == last_q);

      Second : cover (segment && last && segments_q == 8'd2 && ticks == 32'h01020304);
      Refused : cover (fault == 2'b10 && segments_q == 8'd1);
    end
  end

endmodule
`default_nettype wire
