// SPDX-License-Identifier: Apache-2.0
// Lets words into the queue of segments: whole segments of valid words, one after the other; each
// starts where the last one ended, the first after a reset anywhere.
// Clocks: rtl/queue/frame_entry.sv; ticks_o and last_o with segment_o, a segment's last, and until
// the clock after. length_o: data_o passes, and is the length; it does so with turn_i only.
// Word format: hls/words.hpp.  Twin: SegmentEntry of hls/word_entry.hpp.
`default_nettype none
module segment_entry #(
    parameter int CoefBits = 36,  // [18, 36]
    parameter int FineBits = 42,  // [18, 44]
    parameter int AuxAxes  = 0,   // [0, 6]
    parameter int Splines  = 0    // 1: segments of splines too
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic        valid_i,
    output logic             ready_o,
    input  wire logic [47:0] data_i,

    input  wire logic [15:0] digest_i,
    input  wire logic        cut_i,
    input  wire logic        wait_i,
    input  wire logic        turn_i,
    output logic             valid_o,
    input  wire logic        ready_i,
    output logic      [47:0] data_o,

    output logic        length_o,
    output logic        segment_o,
    output logic [31:0] ticks_o,
    output logic        last_o,
    output logic [ 1:0] fault_o     // word, sequence
);

  localparam int Axes = 3 + AuxAxes;

  // The next word
  logic [3:0] tag_q, tag_d;
  logic [3:0] axis_q, axis_d;
  logic xyz;
  logic length;
  logic complete;
  logic can_be;
  logic pass;
  assign xyz      = axis_q < 4'd3;
  assign length   = tag_q == words_pkg::TagLength;
  assign length_o = pass && length;
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

  logic follows;
  frame_entry u_entry (
      .clk_i,
      .rst_ni,
      .valid_i,
      .ready_o,
      .data_i,
      .digest_i,
      .cut_i,
      .wait_i(wait_i || (length && !turn_i)),
      .valid_o,
      .ready_i,
      .data_o,
      .tag_i(tag_q),
      .can_be_i(can_be),
      .numbered_i(tag_q == words_pkg::TagTangent && axis_q == 4'd0),
      .checked_i(tag_q == words_pkg::TagAdvance),
      .follows_i(follows),
      .complete_i(complete),
      .last_i(last_o),
      .pass_o(pass),
      .frame_o(segment_o),
      .fault_o
  );

  // End of the last segment, by axis: read for the axis of the next start
  logic any_start_q;
  logic other_turn_q;
  logic [FineBits-1:0] end_q;
  (* no_rw_check *)
  logic [FineBits-1:0] ends[16];
  assign follows = tag_q != words_pkg::TagStart || data_o[FineBits-1:0] == end_q ||
      any_start_q || (other_turn_q && !xyz);
  always_ff @(posedge clk_i) begin
    if (pass && tag_q == words_pkg::TagEnd) ends[axis_q] <= data_o[FineBits-1:0];
    end_q <= ends[axis_d];
    if (!rst_ni) any_start_q <= 1'b1;
    else if (pass && complete) any_start_q <= 1'b0;
  end

  // Valid values.  A coefficient of CoefBits is sign-extended in its field, a point in its.
  localparam int CoefField = words_pkg::CoefBits;
  localparam int PointField = words_pkg::PointBits;
  logic positive;
  logic coef_fits;
  logic point_fits;
  logic phi_fits;
  assign positive   = data_o[CoefField-1:CoefBits-1] == '0;
  assign coef_fits  = positive || (&data_o[CoefField-1:CoefBits-1]);
  assign point_fits = data_o[PointField-1:FineBits-1] == '0 || (&data_o[PointField-1:FineBits-1]);
  assign phi_fits   = positive && data_o[CoefBits-2];

  localparam int FirstSpare = words_pkg::OtherTurnLow + words_pkg::OtherTurnBits;
  logic spline_q;
  logic [words_pkg::StepExponentBits-1:0] k_q;
  logic [words_pkg::StepExponentBits-1:0] k;
  logic [words_pkg::KindBits-1:0] kind;
  logic [words_pkg::LambdaBits-1:0] lambda;
  logic scale_fits;
  logic theta_word;
  assign kind = data_o[words_pkg::KindLow+:words_pkg::KindBits];
  assign k = data_o[words_pkg::StepExponentLow+:words_pkg::StepExponentBits];
  assign lambda = data_o[words_pkg::LambdaLow+:words_pkg::LambdaBits];
  assign scale_fits = data_o[words_pkg::TagLow-1:FirstSpare] == '0 &&
      (spline_q ? lambda <= words_pkg::MostLambda && {1'b0, k_q} <= lambda : lambda == '0);
  assign theta_word = k <= words_pkg::MostStepExponent &&
      ((kind == 2'd0 && positive) || (kind == 2'd1 && Splines == 1 && phi_fits));
  always_comb begin
    case (tag_q)
      words_pkg::TagTheta: can_be = theta_word;
      words_pkg::TagStart, words_pkg::TagEnd: can_be = point_fits;
      words_pkg::TagTangent, words_pkg::TagAdvance: can_be = coef_fits;
      words_pkg::TagNormal: can_be = coef_fits && (axis_q != 4'd0 || scale_fits);
      default: can_be = 1'b1;
    endcase
  end

  // Outputs to the ledgers
  always_ff @(posedge clk_i) begin
    if (pass && tag_q == words_pkg::TagTheta) begin
      spline_q <= kind[0];
      k_q      <= k;
      last_o   <= data_o[words_pkg::LastLow];
    end
    if (pass && tag_q == words_pkg::TagNormal && axis_q == 4'd0)
      other_turn_q <= data_o[words_pkg::OtherTurnLow];
    // Two bytes of Y, two of Z and two unused ones of X go out at the far end.
    if (pass && (tag_q == words_pkg::TagTangent || tag_q == words_pkg::TagNormal))
      ticks_o <= {data_o[words_pkg::TicksByteLow+:words_pkg::TicksByteBits], ticks_o[31:8]};
  end

endmodule
`default_nettype wire
