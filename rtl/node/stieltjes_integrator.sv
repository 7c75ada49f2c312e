// SPDX-License-Identifier: Apache-2.0
// Stieltjes integrator: the node  x = x(0) + integral of u ds  of a Shannon network, [Chikurov]
// (15), one order of its series after the other, from those of u and of Ds (Ds[i] = i s[i]):
//
//     D[i] = i x[i] = sum of u[j] Ds[i-j], j = 0 .. i-1     x[i] = D[i] / i     state' = sum x
//
// With First = 0 Ds[i] comes to the node as order i-1.  A term of a series is one word, {there,
// order, coefficient}: `there` for a clock, the rest is kept.
//
//   cycle              0      4i+6    4i+15
//   Start, Order       1                      and the words that series_product asks for
//   d_o                       D[i]            kept for 5 clocks
//   x_o                               x[i]    kept
//   Load                                      a clock later x[0] = initial_i
//   Again                                     a clock later x[0] = state_o
//
// Reset acts a clock late, in registers beside the node: nothing may come in the clock after it.
// Rounding: one for D, one for x; x has Drop fraction bits less than D.  No saturation: the planner
// sees to the ranges.
`default_nettype none
module stieltjes_integrator #(
    parameter int Bits     = 36,  // [18, 36]
    parameter int Shift    = 35,  // [1, 40]  fraction bits of u and Ds less those of D
    parameter int Drop     = 0,   // [0, 4]
    parameter int First    = 1,   // 0, 1
    parameter int Quotient = 1,   // 0: no x[i], only D[i]
    parameter int Own      = 1,   // 0, 1: as folded_sum's, with factors_o and product_i
    parameter int Form     = 0    // 0 portable, 1 ECP5
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic        [series_pkg::Bits-1:0] control_i,
    input wire logic signed [            Bits-1:0] initial_i,

    // The integrand and the integrating variable, as their terms come
    input  wire logic   [Bits+4:0] u_i,
    input  wire logic   [Bits+4:0] s_i,
    output logic        [Bits+4:0] d_o,
    output logic        [Bits+4:0] x_o,
    output logic signed [Bits-1:0] state_o, // x[0] + .. + x[i], a clock after x_o

    output logic      [37:0] factors_o,
    input  wire logic [35:0] product_i
);

  logic                   d_there;
  logic                   x_there;
  logic        [     3:0] order;
  logic signed [Bits-1:0] sum;
  series_product #(
      .Bits(Bits),
      .Shift(Shift),
      .QuotientShift(Bits - 1 + Drop),
      .Quotient(Quotient),
      .First(First),
      .Own(Own),
      .Form(Form)
  ) u_product (
      .clk_i,
      .rst_ni,
      .u_write_i(u_i[Bits+4]),
      .u_index_i(u_i[Bits+3:Bits]),
      .u_i(u_i[Bits-1:0]),
      .s_write_i(s_i[Bits+4]),
      .s_index_i(s_i[Bits+3:Bits]),
      .s_i(s_i[Bits-1:0]),
      .start_i(control_i[series_pkg::Start]),
      .order_i(control_i[series_pkg::Order+:4]),
      .d_there_o(d_there),
      .x_there_o(x_there),
      .order_o(order),
      .sum_o(sum),
      .factors_o,
      .product_i
  );
  assign d_o = {d_there, order, sum};

  series_state #(
      .Bits(Bits)
  ) u_state (
      .clk_i,
      .rst_ni,
      .control_i(control_i[series_pkg::ZerothBits-1:0]),
      .initial_i,
      .x_i({x_there, order, sum}),
      .x_o,
      .state_o
  );

endmodule
`default_nettype wire
