// SPDX-License-Identifier: Apache-2.0
// Stieltjes integrator: the node  x = x(0) + integral of u ds  of a Shannon network, [Chikurov]
// (15), one order of its series after the other, from those of u and of Ds (Ds[i] = i s[i]):
//
//     D[i] = i x[i] = sum of u[j] Ds[i-j], j = 0 .. i-1        x[i] = D[i] / i        state' = sum x
//
// With First = 0 Ds[i] is what the node is given as order i-1.
//
//   cycle              0      4i+5    4i+14
//   start_i, order_i   1                      and the words that series_product asks for
//   d_there_o                 1               d_o = D[i] of order_o, for 5 clocks
//   x_there_o                         1       x_o = x[i] of x_order_o, kept
//   load_i                                    a clock later x_o = x[0] = initial_i, order 0
//   again_i                                   a clock later x_o = x[0] = state_o, order 0
//
// Rounding: one for D, one for x; x has Drop fraction bits less than D.  No saturation: the planner
// sees to the ranges.
`default_nettype none
module stieltjes_integrator #(
    parameter int Bits  = 36,  // [18, 36]
    parameter int Shift = 35,  // [1, 40]  fraction bits of u and Ds less those of D
    parameter int Drop  = 0,   // [0, 4]
    parameter int First = 1,   // 0, 1
    parameter int Form  = 0    // 0 portable, 1 ECP5
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Initial condition
    input wire logic                   load_i,
    input wire logic                   again_i,
    input wire logic signed [Bits-1:0] initial_i,

    // The integrand and the integrating variable, as their orders come
    input wire logic                   u_there_i,
    input wire logic        [     3:0] u_order_i,
    input wire logic signed [Bits-1:0] u_i,
    input wire logic                   s_there_i,
    input wire logic        [     3:0] s_order_i,
    input wire logic signed [Bits-1:0] s_i,

    input  wire logic              start_i,
    input  wire logic   [     3:0] order_i,
    output logic                   d_there_o,
    output logic        [     3:0] order_o,
    output logic signed [Bits-1:0] d_o,
    output logic                   x_there_o,
    output logic        [     3:0] x_order_o,
    output logic signed [Bits-1:0] x_o,
    output logic signed [Bits-1:0] state_o     // x[0] + .. + x[i], a clock after x_o
);

  logic                   quotient;
  logic                   zeroth;
  logic signed [Bits-1:0] start;
  series_product #(
      .Bits(Bits),
      .Shift(Shift),
      .QuotientShift(Bits - 1 + Drop),
      .First(First),
      .Form(Form)
  ) u_product (
      .clk_i,
      .rst_ni,
      .u_write_i(u_there_i),
      .u_index_i(u_order_i),
      .u_i,
      .s_write_i(s_there_i),
      .s_index_i(s_order_i),
      .s_i,
      .start_i,
      .order_i,
      .d_there_o,
      .x_there_o(quotient),
      .order_o,
      .sum_o(d_o)
  );

  always_ff @(posedge clk_i) begin
    if (!rst_ni) x_there_o <= 1'b0;
    else x_there_o <= quotient || zeroth;
  end
  assign zeroth = load_i || again_i;
  assign start  = again_i ? state_o : initial_i;
  always_ff @(posedge clk_i) begin
    if (quotient || zeroth) begin
      x_o       <= zeroth ? start : d_o;
      x_order_o <= zeroth ? 4'd0 : order_o;
    end
    if (x_there_o) state_o <= (x_order_o == 4'd0) ? x_o : state_o + x_o;
  end

endmodule
`default_nettype wire
