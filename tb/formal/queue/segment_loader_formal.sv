// SPDX-License-Identifier: Apache-2.0
// rtl/queue/segment_loader.sv: every segment's words come to their places and stay there as long as
// it is the present one, empty segments are counted and nothing else, nothing gets stuck. Words
// carry their segment's number; of the places, one is watched, any.
// control: LOSES_WORD s/assign accept   = .*/assign accept   = valid_i \&\& data_i[8:7] != 2'd3;/
// control: KEEPS_EMPTY s/if (empty_q) field_d = Length;//
// control: SAME_BANK s/bank_q  <= !bank_q/bank_q <= bank_q/
// control: TAKES_EARLY s/field_q <= Length;$/field_q <= Theta;/
// control: NO_RESET s/axis_q           <= 4'd0;//
// long: proved covered
`default_nettype none
module segment_loader_formal (
    input wire logic       clk_i,
    input wire logic       rst_ni,
    input wire logic       valid_i,
    input wire logic       empty_i,
    input wire logic       take_i,
    input wire logic [4:0] watch_i
);

  localparam int Words = 20;  // one auxiliary axis

  logic [4:0] words_q;  // of the segment that is filled
  logic [1:0] segment_q;
  logic empty_q;
  logic ready;
  logic [47:0] data;
  logic watched;
  logic [4:0] watch_q;
  assign watched = words_q == watch_q;
  always_comb begin
    data        = '0;
    data[8:7]   = segment_q;
    data[6]     = watched;
    data[39:38] = segment_q;
    data[43]    = words_q == 5'd0;
    if (words_q == 5'd0 && empty_i) data = '0;
  end

  logic segment_valid;
  logic [47:0] length;
  logic [17:0] theta;
  logic [4:0] k;
  logic [5:0] unused_lambda;
  logic unused_kind;
  logic [15:0] empty_segments;
  logic [3:0] axis;
  logic [17:0] tangent;
  logic [17:0] normal;
  logic [17:0] advance;
  logic [17:0] start;
  logic [17:0] last;
  segment_loader #(
      .CoefBits(18),
      .FineBits(18),
      .AuxAxes (1)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .valid_i,
      .ready_o(ready),
      .data_i(data),
      .segment_valid_o(segment_valid),
      .take_i,
      .length_o(length),
      .theta_o(theta),
      .k_o(k),
      .lambda_o(unused_lambda),
      .kind_o(unused_kind),
      .empty_segments_o(empty_segments),
      .rate_axis_i(axis),
      .tangent_o(tangent),
      .normal_o(normal),
      .advance_o(advance),
      .cubic_axis_i('0),
      .a_o(),
      .b_o(),
      .c_o(),
      .point_axis_i(axis),
      .start_o(start),
      .end_o(last)
  );

  // The watched word, read.
  logic [ 4:0] place;
  logic [17:0] seen;
  always_comb begin
    place = watch_q - 5'd2;
    axis  = 4'd3;
    if (place < 5'd15) axis = 4'd2;
    if (place < 5'd10) axis = 4'd1;
    if (place < 5'd5) axis = 4'd0;
    if (place >= 5'd15) place = (place == 5'd17) ? 5'd4 : place - 5'd15;
    else if (place >= 5'd10) place = place - 5'd10;
    else if (place >= 5'd5) place = place - 5'd5;
    case (place[2:0])
      3'd0: seen = start;
      3'd1: seen = last;
      3'd2: seen = tangent;
      3'd3: seen = normal;
      default: seen = advance;
    endcase
  end

  logic started_q = 1'b0;
  logic [15:0] empties_q;
  logic present_q;
  logic [1:0] present_segment_q;
  logic word;
  logic taken;
  assign word  = valid_i && ready;
  assign taken = segment_valid && take_i;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!rst_ni) begin
      words_q   <= '0;
      segment_q <= '0;
      empties_q <= '0;
      empty_q   <= 1'b0;
      present_q <= 1'b0;
      watch_q   <= watch_i;
    end else begin
      if (word) words_q <= words_q + 5'd1;
      if (word && words_q == 5'd0) empty_q <= empty_i;
      if (word && words_q == 5'(Words - 1) && empty_q) begin
        words_q <= '0;
        if (empties_q != '1) empties_q <= empties_q + 16'd1;
        segment_q <= segment_q + 2'd1;
      end
      if (taken) begin
        words_q           <= '0;
        segment_q         <= segment_q + 2'd1;
        present_q         <= 1'b1;
        present_segment_q <= segment_q;
      end
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      assume (watch_q >= 5'd2 && watch_q < 5'(Words));

      WholeSegment : assert (segment_valid == (words_q == 5'(Words)));
      NeverStuck : assert (ready == (words_q != 5'(Words)));
      CountsEmpty : assert (empty_segments == empties_q);
      if (segment_valid) begin
        Length : assert (length[43] && length[8:7] == segment_q);
        Theta : assert (theta[8:7] == segment_q && k == {3'b0, segment_q});
      end
      if (present_q) Place : assert (seen[6] && seen[8:7] == present_segment_q);

      SecondSegment : cover (present_q && segment_valid && empties_q == 16'd1);
    end
  end

endmodule
`default_nettype wire
