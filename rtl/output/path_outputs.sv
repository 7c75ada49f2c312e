// SPDX-License-Identifier: Apache-2.0
// Outputs in step with the path: bits and a level that change at places of the path, while the
// sample at that place is drawn. Words and arithmetic: hls/path_outputs.hpp.
//
//   words -> memory -> the next one -> bits, level      samples made -> paths -> samples drawn
//                         ^ it is due                                             | way of a sample
//                         +-------------------------------------------------------+
//
//   clock      0      1      2      3      4
//   drawn_i    1
//   way_q                    of it
//   bits_o                                 due with it; of a second change 7 clocks later, ..
//   power_o    a sample's is there 55 clocks behind its last change of level or follow
//
// A sample that is taken is drawn from the next drawn_i on, and another is taken after that. Two of
// these are 64 clocks or more apart; 32 samples at most are made and not taken. next_o: the word is
// one of outputs and the next in order; it is taken with ready_o, one in 6 clocks while there is
// room. Any other word is left to the motion's entry, which refuses it. Nothing is on without
// enable_i; what was on is off then. A flush drops what waits and what is made: the next program
// begins at path 0. What is on stays on with keep_i. With Delay all is later by the samples
// of delay_i, and 2 clocks; in a period without a sample it goes on as in one without a way.
`default_nettype none
module path_outputs #(
    parameter int Words = 1024,  // [64, 4096], a power of two: words that wait
    parameter int Form  = 0,     // memory: rtl/queue/single_port_memory.sv
    parameter int Delay = 0      // 0: none; Places of rtl/output/way_delay.sv
) (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic flush_i,
    input wire logic keep_i,

    input  wire logic        valid_i,
    input  wire logic [47:0] word_i,
    output logic             next_o,
    output logic             ready_o,
    output logic      [15:0] room_o,

    input wire logic        made_i,   // a sample, with its path in 2^-8 length units
    input wire logic [31:0] path_i,
    input wire logic        taken_i,  // the next one waits to be drawn
    input wire logic        drawn_i,  // it is drawn from here
    input wire logic        enable_i,

    input wire logic       delay_write_i,  // it comes while not enabled
    input wire logic [8:0] delay_i,

    output logic        settled_o,  // no way is to come: with Delay later than the axes
    output logic [ 7:0] bits_o,
    output logic [11:0] power_o,
    output logic        pwm_o       // power_o / 4095 of the time, in periods of 4095 clocks
);

  initial
    if (Words < 64 || Words > 4096 || 2 ** $clog2(Words) != Words)
      $fatal(1, "Words must be a power of two in [64, 4096]");
  localparam int PlaceBits = $clog2(Words);

  logic work, takes_words;
  assign work = rst_ni && enable_i && (keep_i || !flush_i);
  assign takes_words = work && !flush_i;

  // Words in order: three limbs of each go into the memory, and out of it when it is the next one
  logic [3:0] number_q;
  logic [PlaceBits:0] write_q, read_q, waiting;
  logic takes, writes, begins, reads, shifts_q, next_valid_q, apply, loaded_q;
  logic [1:0] put_left_q, read_left_q;  // limbs
  logic [47:0] put_q, next_q;
  logic [15:0] limb;
  logic [PlaceBits+1:0] place;
  assign next_o = valid_i && word_i[words_pkg::TagLow+:4] == words_pkg::TagOutput &&
      word_i[words_pkg::OutputNumberLow+:4] == number_q &&
      word_i[words_pkg::OutputKindLow+:2] <= words_pkg::OutputFollow;
  assign ready_o = room_o != '0 && put_left_q == '0;
  assign takes = next_o && ready_o;
  assign waiting = write_q - read_q;
  assign room_o = 16'(Words) - 16'(waiting);
  assign begins = !next_valid_q && waiting != '0 && !takes && put_left_q == '0 &&
      read_left_q == '0 && !shifts_q;
  assign reads = read_left_q != '0;
  assign writes = put_left_q != '0 && !reads;
  assign place = reads ? {read_q[PlaceBits-1:0], read_left_q} :
      {write_q[PlaceBits-1:0], put_left_q};
  single_port_memory #(
      .Bits (16),
      .Words(4 * Words),
      .Form (Form)
  ) u_memory (
      .clk_i,
      .write_i(writes),
      .place_i(place),
      .word_i (put_q[15:0]),
      .word_o (limb)
  );
  always_ff @(posedge clk_i) begin
    if (takes) put_q <= word_i;
    else if (writes) put_q <= {16'd0, put_q[47:16]};
    if (shifts_q) next_q <= {limb, next_q[47:16]};
    if (!takes_words) begin
      number_q     <= '0;
      write_q      <= '0;
      read_q       <= '0;
      put_left_q   <= '0;
      read_left_q  <= '0;
      shifts_q     <= 1'b0;
      next_valid_q <= 1'b0;
    end else begin
      if (takes) number_q <= number_q + 1'b1;
      if (takes) put_left_q <= 2'd3;
      else if (writes) put_left_q <= put_left_q - 1'b1;
      if (writes && put_left_q == 2'd1) write_q <= write_q + 1'b1;
      if (begins) read_left_q <= 2'd3;
      else if (reads) read_left_q <= read_left_q - 1'b1;
      if (reads && read_left_q == 2'd1) read_q <= read_q + 1'b1;
      shifts_q <= reads;
      if (shifts_q && !reads) next_valid_q <= 1'b1;
      else if (apply) next_valid_q <= 1'b0;
    end
  end

  // Paths of samples that are made and not yet drawn
  logic [31:0] paths[32];
  logic [4:0] made_q, taken_q;
  logic [31:0] path_q, before_q, way_q;
  logic waits_q;
  logic [1:0] moves_q;  // path_q is drawn, and a clock later way_q is of it
  always_ff @(posedge clk_i) begin
    if (made_i) paths[made_q] <= path_i;
    if (taken_i) path_q <= paths[taken_q];
    if (!rst_ni || flush_i) begin
      made_q   <= '0;
      taken_q  <= '0;
      waits_q  <= 1'b0;
      moves_q  <= '0;
      before_q <= '0;
    end else begin
      if (made_i) made_q <= made_q + 1'b1;
      if (taken_i) taken_q <= taken_q + 1'b1;
      waits_q <= taken_i || (waits_q && !drawn_i);
      moves_q <= {moves_q[0], waits_q && drawn_i};
      if (moves_q[0]) before_q <= path_q;
    end
    if (!rst_ni) way_q <= '0;
    else if (moves_q[0]) way_q <= path_q - before_q;
  end

  logic moves;
  logic [31:0] way;
  if (Delay != 0) begin : g_delay
    way_delay #(
        .Places(Delay)
    ) u_delay (
        .clk_i,
        .rst_ni,
        .flush_i,
        .off_i  (!enable_i),
        .write_i(delay_write_i),
        .delay_i,
        .drawn_i,
        .moves_i(moves_q[1]),
        .way_i  (way_q),
        .moves_o(moves),
        .way_o  (way),
        .settled_o
    );
  end else begin : g_no_delay
    logic unused;
    assign moves  = moves_q[1];
    assign way    = way_q;
    assign settled_o = 1'b1;
    assign unused = &{1'b0, delay_write_i, delay_i};
  end

  // The way to the next change: it is due when nothing is left.
  logic signed [35:0] left_q, change;
  logic loads;
  assign loads  = next_valid_q && !loaded_q && !moves;
  assign change = moves ? {4'hf, ~way} : {2'b00, next_q[words_pkg::OutputDistanceLow+:26], 8'd0};
  assign apply  = loaded_q && !moves && left_q <= 0;
  always_ff @(posedge clk_i) begin
    if (!takes_words) begin
      left_q   <= '0;
      loaded_q <= 1'b0;
    end else begin
      if (moves || loads) left_q <= left_q + change + 36'(moves);
      if (loads) loaded_q <= 1'b1;
      else if (apply) loaded_q <= 1'b0;
    end
  end

  // What is on
  logic changes_level;
  logic [7:0] bits_q;
  logic [11:0] level_q, follow_q, value;
  logic [1:0] kind;
  assign value         = next_q[words_pkg::OutputValueLow+:12];
  assign kind          = next_q[words_pkg::OutputKindLow+:2];
  assign changes_level = apply && kind != words_pkg::OutputBits;
  always_ff @(posedge clk_i) begin
    if (!work) begin
      bits_q   <= '0;
      level_q  <= '0;
      follow_q <= '0;
    end else if (apply) begin
      case (kind)
        words_pkg::OutputBits:  bits_q <= value[7:0];
        words_pkg::OutputLevel: level_q <= value;
        default:                follow_q <= value;
      endcase
    end
  end
  assign bits_o = bits_q & {8{enable_i}};

  // The level as it follows the way: a shift, and two products bit by bit, each rounded down
  typedef enum logic [1:0] {
    Whole,
    Scale,
    Quotient,
    Power
  } state_t;
  (* fsm_encoding = "none" *)
  state_t state_q;
  logic begin_q, constant;
  logic [43:0] scaled_q;
  logic [ 4:0] count_q;
  logic [12:0] factor_q, sum_q, sum;
  logic [11:0] digits_q;
  logic [13:0] added;
  assign added = {1'b0, sum_q} + (digits_q[0] ? {1'b0, factor_q} : 14'd0);
  assign sum = added[13:1];
  assign constant = follow_q[11:1] == '0;
  always_ff @(posedge clk_i) begin
    begin_q <= moves || changes_level;
    count_q <= count_q - 1'b1;
    if (!work) begin
      state_q <= Whole;
      power_o <= '0;
    end else if (begin_q) begin
      state_q  <= constant ? Whole : Scale;
      scaled_q <= {way, 12'd0};
      count_q  <= follow_q[11:7];
      if (constant) power_o <= (follow_q[0] && way == '0) ? 12'd0 : level_q;
    end else begin
      case (state_q)
        Scale: begin
          if (count_q != '0) begin
            scaled_q <= {1'b0, scaled_q[43:1]};
          end else begin
            state_q  <= Quotient;
            factor_q <= (scaled_q[43:13] != '0) ? 13'h1fff : scaled_q[12:0];
            sum_q    <= '0;
            digits_q <= {5'd1, follow_q[6:0]};
            count_q  <= 5'd7;
          end
        end
        Quotient: begin
          sum_q    <= sum;
          digits_q <= {1'b0, digits_q[11:1]};
          if (count_q == '0) begin
            state_q  <= sum[12] ? Whole : Power;
            factor_q <= {1'b0, level_q};
            sum_q    <= '0;
            digits_q <= sum[11:0];
            count_q  <= 5'd11;
            if (sum[12]) power_o <= level_q;
          end
        end
        Power: begin
          sum_q    <= sum;
          digits_q <= {1'b0, digits_q[11:1]};
          if (count_q == '0) begin
            state_q <= Whole;
            power_o <= sum[11:0];
          end
        end
        default: ;
      endcase
    end
  end

  logic [11:0] turn_q;
  logic on_q;
  assign pwm_o = on_q && enable_i;
  always_ff @(posedge clk_i) begin
    if (!work) begin
      turn_q <= '0;
      on_q   <= 1'b0;
    end else begin
      turn_q <= (turn_q == 12'd4094) ? 12'd0 : turn_q + 1'b1;
      on_q   <= turn_q < power_o;
    end
  end

endmodule
`default_nettype wire
