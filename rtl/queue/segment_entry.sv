// SPDX-License-Identifier: Apache-2.0
// Lets words into the queue of segments: whole segments, one after the other, of words that can be.
// The first other word cuts the stream: it and all that follow are taken and dropped, until reset.
// Word format: hls/words.hpp.  Twin: hls/word_entry.hpp.
//
//   clock      0      1      2
//   valid_i    1
//   data_i     word
//   valid_o           1               until ready_i
//   data_o            word
//   segment_o                1        it was a segment's last; length_o, ticks_o, last_o: of it
//   fault_o                  1        or it could not be: stays
//
// cut_i: the stream is cut for another's fault.  wait_i: no word is passed on.
`default_nettype none
module segment_entry #(
    parameter int CoefBits = 36,  // [18, 36]
    parameter int FineBits = 42,  // [18, 44]
    parameter int AuxAxes  = 0,   // [0, 6]
    parameter int Splines  = 0,   // 1: segments of splines too
    parameter int TurnBits = 0    // [0, 14]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic        valid_i,
    output logic             ready_o,
    input  wire logic [47:0] data_i,

    input  wire logic        cut_i,
    input  wire logic        wait_i,
    output logic             valid_o,
    input  wire logic        ready_i,
    output logic      [47:0] data_o,

    output logic        segment_o,
    output logic [43:0] length_o,
    output logic [31:0] ticks_o,
    output logic        last_o,
    output logic [ 1:0] fault_o     // word, sequence
);

  localparam int Axes = 3 + AuxAxes;
  localparam int LargestTurn = CoefBits - 1 - TurnBits;  // exponent of theta's largest value

  // The word at hand
  logic held_q;
  logic cut;
  logic good;
  logic pass;
  assign cut     = cut_i || fault_o != 2'b00;
  assign valid_o = held_q && good && !cut && !wait_i;
  assign pass    = valid_o && ready_i;
  assign ready_o = !held_q || pass || cut;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) held_q <= 1'b0;
    else if (ready_o) held_q <= valid_i && !cut;
  end
  always_ff @(posedge clk_i) if (ready_o) data_o <= data_i;

  // Which word it has to be
  logic [3:0] tag_q, tag_d;
  logic [3:0] axis_q, axis_d;
  logic xyz;
  logic complete;
  assign xyz      = axis_q < 4'd3;
  assign complete = tag_q == words_pkg::TagAdvance && axis_q == 4'(Axes - 1);
  always_comb begin
    tag_d  = tag_q + 4'd1;
    axis_d = axis_q;
    if (tag_q == words_pkg::TagEnd && !xyz) tag_d = words_pkg::TagAdvance;
    if (tag_q == words_pkg::TagAdvance) begin
      tag_d  = words_pkg::TagStart;
      axis_d = axis_q + 4'd1;
    end
    if (complete) begin
      tag_d  = words_pkg::TagLength;
      axis_d = 4'd0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      tag_q  <= words_pkg::TagLength;
      axis_q <= 4'd0;
    end else if (pass) begin
      tag_q  <= tag_d;
      axis_q <= axis_d;
    end
  end

  // What it may be.  A coefficient of CoefBits is sign-extended to 36, a point to 44.
  logic spline_q;
  logic [4:0] k_q;
  logic [7:0] sequence_q;
  logic [1:0] kind;
  logic [4:0] k;
  logic [5:0] lambda;
  logic coef_fits;
  logic point_fits;
  logic positive;
  logic theta_fits;
  logic phi_fits;
  logic follows;
  assign kind       = data_o[words_pkg::KindLow+:2];
  assign k          = data_o[words_pkg::StepExponentLow+:5];
  assign lambda     = data_o[words_pkg::LambdaLow+:6];
  assign positive   = data_o[35:CoefBits-1] == '0;
  assign coef_fits  = positive || (&data_o[35:CoefBits-1]);
  assign point_fits = data_o[43:FineBits-1] == '0 || (&data_o[43:FineBits-1]);
  assign phi_fits   = positive && data_o[CoefBits-2];
  assign follows    = data_o[words_pkg::SequenceLow+:8] == sequence_q;
  if (TurnBits == 0) begin : g_any_turn
    assign theta_fits = positive;
  end else begin : g_small_turns
    logic below;
    logic largest;
    assign below      = data_o[35:LargestTurn] == '0;
    assign largest    = data_o[35:0] == (36'd1 << LargestTurn);
    assign theta_fits = below || largest;
  end

  logic no_rest;  // the bits above a coefficient
  logic scale_fits;
  logic theta_word;
  assign no_rest = data_o[43:36] == 8'd0;
  assign scale_fits = data_o[43:42] == 2'b00 &&
      (spline_q ? lambda <= 6'd27 && {1'b0, k_q} <= lambda : lambda == 6'd0);
  assign theta_word = k <= 5'd27 &&
      ((kind == 2'd0 && theta_fits) || (kind == 2'd1 && Splines == 1 && phi_fits));
  logic tag_fits;
  logic can_be;
  logic in_order;
  assign tag_fits = data_o[words_pkg::TagLow+:4] == tag_q;
  assign in_order = tag_q != words_pkg::TagTangent || axis_q != 4'd0 || follows;
  always_comb begin
    case (tag_q)
      words_pkg::TagTheta: can_be = theta_word;
      words_pkg::TagStart, words_pkg::TagEnd: can_be = point_fits;
      words_pkg::TagTangent: can_be = coef_fits;
      words_pkg::TagNormal: can_be = coef_fits && (axis_q != 4'd0 || scale_fits);
      words_pkg::TagAdvance: can_be = coef_fits && no_rest;
      default: can_be = 1'b1;
    endcase
  end
  assign good = tag_fits && can_be && in_order;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fault_o    <= 2'b00;
      segment_o  <= 1'b0;
      sequence_q <= '0;
    end else begin
      if (held_q && !cut && !(tag_fits && can_be)) fault_o[0] <= 1'b1;
      if (held_q && !cut && tag_fits && !in_order) fault_o[1] <= 1'b1;
      segment_o <= pass && complete;
      if (pass && complete) sequence_q <= sequence_q + 8'd1;
    end
  end

  // What the ledgers want to know of it
  always_ff @(posedge clk_i) begin
    if (pass && tag_q == words_pkg::TagLength) length_o <= data_o[43:0];
    if (pass && tag_q == words_pkg::TagTheta) begin
      spline_q <= kind[0];
      k_q      <= k;
      last_o   <= data_o[words_pkg::LastLow];
    end
    // Two bytes of Y, two of Z, and the two of X that are none go out at the far end.
    if (pass && (tag_q == words_pkg::TagTangent || tag_q == words_pkg::TagNormal))
      ticks_o <= {data_o[words_pkg::TicksByteLow+:8], ticks_o[31:8]};
  end

endmodule
`default_nettype wire
