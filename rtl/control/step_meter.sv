// SPDX-License-Identifier: Apache-2.0
// Lengths of the integration steps of a segment: 2^k length units each, the last one the rest.
//
// A step ends when the path exceeds its length, or reaches it and another step of the segment
// follows.  One sign decides both, since lengths are one quantum less unless the step is the last:
//
//   offset_o    length - !last               the largest offset that lies in the step
//   stride_o    offset_o + !last of the step before: from its largest offset to this one's
//
//   cycle       0         5
//   load_i      1                 a segment starts: length_i, k_i
//   next_i      (or 1)            its next step
//   last_o, offset_o, stride_o    valid until the next load_i or next_i
`default_nettype none
module step_meter (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic        load_i,
    input wire logic [47:0] length_i,
    input wire logic [ 4:0] k_i,
    input wire logic        next_i,

    output logic                               last_o,
    output logic [curvecore_pkg::StepBits-1:0] offset_o,
    output logic [  curvecore_pkg::StepBits:0] stride_o
);

  localparam int Bits = curvecore_pkg::StepBits;
  localparam int Frac = curvecore_pkg::PathFrac;

  logic started_q;  // a step precedes the first of this segment
  logic last_before_q;  // the last step was the last of its segment
  logic [47:0] rest_q;  // rest of the segment, from this step's start
  logic [31:0] below_q;  // a full step less a quantum: ones below its exponent, and Frac more
  logic signed [48:0] beyond_q;  // rest of the segment, from a full step's end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      started_q     <= 1'b0;
      last_before_q <= 1'b0;
    end else if (load_i) begin
      started_q     <= 1'b1;
      last_before_q <= started_q;
    end else if (next_i) begin
      last_before_q <= 1'b0;
    end
  end

  // A full step has no fraction: the rest less it is, above the fraction, the rest plus the
  // complement of below_q.
  logic signed [    32:0] rest;
  logic signed [    32:0] less;
  logic signed [    32:0] beyond;
  logic        [    47:0] short_of;
  logic        [Bits-1:0] offset;
  logic        [  Bits:0] offset_wide;
  logic        [  Bits:0] bias;
  assign rest        = {1'b0, rest_q[47:Frac]};
  assign less        = {1'b1, ~below_q};
  assign beyond      = rest + less;
  assign short_of    = {below_q, {Frac{1'b1}}};
  assign offset      = last_o ? rest_q[Bits-1:0] : short_of[Bits-1:0];
  assign offset_wide = {1'b0, offset_o};
  assign bias        = {{Bits{1'b0}}, !last_before_q};

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      rest_q  <= length_i;
      below_q <= ~(32'hffff_ffff << k_i);
    end else if (next_i) begin
      rest_q <= beyond_q[47:0];
    end
    beyond_q <= {beyond, rest_q[Frac-1:0]};
    last_o   <= beyond_q[48] || beyond_q == 49'd0;
    offset_o <= offset;
    stride_o <= offset_wide + bias;
  end

endmodule
`default_nettype wire
