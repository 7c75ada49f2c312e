// SPDX-License-Identifier: Apache-2.0
// Product of a word and a weight that comes in digits of two bits, lowest first:
//
//     product = floor(a * weight / 2^(Bits-1) + 1/2)      0 <= weight < 2^(Bits-1)
//
// curvecore_pkg::weight_digits(Bits) digits; the last has one bit (for odd Bits the weight comes
// doubled).  No multiplier: several units share one weight.
//
//   cycle       0        1          2  ..  Digits+1      Digits+2
//   take_i      1                                        (may be 1 again)
//   a_i         a
//   triple_i             1
//   step_i                          1  ..  1
//   digit_i                         digits
//   last_i                                 1
//   product_o   before   before                          product
//
// copy_i puts a_i into the product, as a weight of one would.
`default_nettype none
module digit_multiplier #(
    parameter int Bits = 36  // [18, 36]
) (
    input  wire logic                   clk_i,
    input  wire logic                   copy_i,
    input  wire logic                   take_i,
    input  wire logic                   triple_i,
    input  wire logic                   step_i,
    input  wire logic                   last_i,
    input  wire logic        [     1:0] digit_i,
    input  wire logic signed [Bits-1:0] a_i,
    output logic signed      [Bits-1:0] product_o
);

  initial if (Bits < 18 || Bits > 36) $fatal(1, "Bits must be in [18, 36]");

  logic signed [Bits+1:0] a;
  logic signed [Bits+1:0] double;
  logic signed [Bits-1:0] a_q;
  logic signed [Bits+1:0] triple_q;
  assign a      = {{2{a_q[Bits-1]}}, a_q};
  assign double = {a_q[Bits-1], a_q, 1'b0};
  always_ff @(posedge clk_i) begin
    if (take_i) a_q <= a_i;
    if (triple_i) triple_q <= a + double;
  end

  logic signed [Bits+1:0] multiple;
  always_comb begin
    case (digit_i)
      2'd0: multiple = '0;
      2'd1: multiple = a;
      2'd2: multiple = double;
      default: multiple = triple_q;
    endcase
  end

  // One place more for the rounding: 1/2 of what the last, one-bit shift drops.
  logic signed [Bits+2:0] left;
  logic signed [Bits+2:0] right;
  logic signed [Bits+2:0] sum;
  assign left  = {{2{product_o[Bits-1]}}, product_o, 1'b1};
  assign right = {multiple, last_i};
  assign sum   = left + right;

  always_ff @(posedge clk_i) begin
    if (copy_i) product_o <= a_i;
    else if (triple_i) product_o <= '0;
    else if (step_i && last_i) product_o <= sum[Bits+1:2];
    else if (step_i) product_o <= sum[Bits+2:3];
  end

endmodule
`default_nettype wire
