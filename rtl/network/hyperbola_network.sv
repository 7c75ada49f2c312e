// SPDX-License-Identifier: Apache-2.0
// The hyperbola y = 1 / (k (t0 + t)), [Chikurov] Fig. 3: one Riemann and one Stieltjes integrator.
//
//     dy = z dtau        dz = -2 y dy
//
// in steps of h, tau = t / h, y as h k y, z as h^2 k z.  Twin: hls/curves/hyperbola.hpp, which has
// the words' formats.  Terms are {there, order, coefficient}.
//
//   cycle         0         1                    then
//   y Load, Again 1         y[0] there           y[i] 6 clocks after z[0], Digits + 7 after z[i-1]
//   z Again       1         z[0] there
//   z Start, Order          i, y[i] there        z[i] 4 (i + 1) + 9 clocks later
//
// Digits = ceil(CoefBits / 2).  The states of y and z are complete a clock
// after their last terms.
`default_nettype none
module hyperbola_network #(
    parameter int Order    = 6,   // [2, 12]
    parameter int CoefBits = 36,  // [18, 36]
    parameter int Form     = 0    // 0 portable, 1 ECP5
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Orders, from hyperbola_interpolator
    input wire logic [series_pkg::ZerothBits-1:0] control_y_i,
    input wire logic [      series_pkg::Bits-1:0] control_z_i,

    // Initial condition
    input wire logic signed [CoefBits-1:0] y_i,

    output logic [CoefBits+4:0] y_o,
    output logic [CoefBits+4:0] z_o
);

  // Digits of 1/i for y.
  logic [riemann_pkg::ExpansionBits-1:0] control;
  logic                                  there;
  logic [                           3:0] order;
  order_digits #(
      .Bits(CoefBits),
      .Last(Order)
  ) u_order_digits (
      .clk_i,
      .rst_ni,
      .there_i  (z_o[CoefBits+4]),
      .order_i  (z_o[CoefBits+3:CoefBits]),
      .control_o(control),
      .there_o  (there),
      .order_o  (order)
  );

  logic signed [CoefBits-1:0] y;
  logic signed [CoefBits-1:0] unused_sum, unused_state_y, unused_state_z;
  logic [37:0] unused_factors;

  // One node per state equation, the equation in its last line.
  // verilog_format: off
  riemann_integrator #(.Bits(CoefBits)) u_y (
      .clk_i, .control_i({1'b0, control}), .initial_i({CoefBits{1'b0}}), .sum_o(unused_sum),
      .x_o(y), .u_i(z_o[CoefBits-1:0]));  // dy = z dtau

  series_state #(.Bits(CoefBits)) u_state_y (
      .clk_i, .rst_ni, .control_i(control_y_i), .initial_i(y_i),
      .state_o(unused_state_y), .x_i({there, order, y}), .x_o(y_o));

  square_integrator #(.Bits(CoefBits), .Gain(1), .Form(Form)) u_z (
      .clk_i, .rst_ni, .control_i(control_z_i), .initial_i({CoefBits{1'b0}}),
      .state_o(unused_state_z), .factors_o(unused_factors), .product_i(36'd0),
      .r_o(z_o), .phi_i(y_o));  // dz = -2 y dy
  // verilog_format: on

endmodule
`default_nettype wire
