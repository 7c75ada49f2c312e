// SPDX-License-Identifier: Apache-2.0
// Sums of full products, shifted: floor(sum / 2^shift), and the bit below.
//
//   cycle        0                      1
//   product_i    product, more_i        scale_i of it
//   floor_o                             of the sum with this product; kept if more_i, else the next
//                                       sum begins
//
// scale_i: (shift - CoefBits + 6) modulo 8, for shifts up to CoefBits + 1, and CoefBits + 4.
`default_nettype none
module folded_accumulator #(
    parameter int CoefBits = 36  // [18, 36]
) (
    input  wire logic                         clk_i,
    input  wire logic signed [2*CoefBits-1:0] product_i,
    input  wire logic                         more_i,
    input  wire logic        [           2:0] scale_i,
    output logic signed      [  CoefBits-1:0] floor_o,
    output logic                              below_o
);

  // The sum has at most 13 products of words: hls/curves/curve_steps.hpp.
  localparam int SumBits = 2 * CoefBits + 4;
  localparam int Lowest = CoefBits - 7;  // the bit below the shortest shift

  logic signed [SumBits-1:0] so_far_q;
  logic signed [SumBits-1:0] sum_q;
  logic signed [SumBits-1:0] wide;
  logic signed [SumBits-1:0] sum;
  assign wide = {{4{product_i[2*CoefBits-1]}}, product_i};
  assign sum  = so_far_q + wide;
  always_ff @(posedge clk_i) begin
    sum_q    <= sum;
    so_far_q <= more_i ? sum : '0;
  end

  logic [CoefBits:0] shifted[8];
  for (genvar code = 0; code < 8; code++) begin : g_shift
    localparam int Longer = (code == 1 || code == 2) ? 10 : code;
    assign shifted[code] = sum_q[Lowest+Longer+:CoefBits+1];
  end
  assign {floor_o, below_o} = shifted[scale_i];

endmodule
`default_nettype wire
