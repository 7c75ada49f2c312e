// SPDX-License-Identifier: Apache-2.0
// Spherical interpolator, [Chikurov] Fig. 8 and equation (19): six Riemann integrators.
//
//     x y z   the unit vector n from the circle's centre      dn/ds =  phi t
//     F G H   the unit tangent t = B x n                      dt/ds = -phi n
//
// both times cos(pitch).  Twin: hls/spherical_kernel.hpp.  Words: CoefBits, CoefBits - 2 fraction
// bits.  The sequencer's cycles apply to all: on the outputs are the coefficients of one order.
`default_nettype none
module spherical_network #(
    parameter int CoefBits = 36  // [18, 36]
) (
    input wire logic clk_i,

    // Initial conditions, one axis at a time: bit 0 for x and F, 1 for y and G, 2 for z and H
    input wire logic        [         2:0] load_i,
    input wire logic signed [CoefBits-1:0] normal_i,
    input wire logic signed [CoefBits-1:0] tangent_i,

    // From taylor_sequencer
    input wire logic       take_i,
    input wire logic       close_i,
    input wire logic       triple_i,
    input wire logic       step_i,
    input wire logic       last_i,
    input wire logic [1:0] digit_i,
    input wire logic       advance_i,
    input wire logic       zeroth_i,
    input wire logic       collect_i,
    input wire logic       first_i,

    output logic signed [CoefBits-1:0] x_o,
    output logic signed [CoefBits-1:0] y_o,
    output logic signed [CoefBits-1:0] z_o,
    output logic signed [CoefBits-1:0] f_o,
    output logic signed [CoefBits-1:0] g_o,
    output logic signed [CoefBits-1:0] h_o,

    // Sums of the orders from 1
    output logic signed [CoefBits-1:0] sum_x_o,
    output logic signed [CoefBits-1:0] sum_y_o,
    output logic signed [CoefBits-1:0] sum_z_o
);

  logic signed [CoefBits-1:0] x;
  logic signed [CoefBits-1:0] y;
  logic signed [CoefBits-1:0] z;
  logic signed [CoefBits-1:0] f;
  logic signed [CoefBits-1:0] g;
  logic signed [CoefBits-1:0] h;

  logic signed [CoefBits-1:0] unused_sum_f;
  logic signed [CoefBits-1:0] unused_sum_g;
  logic signed [CoefBits-1:0] unused_sum_h;

  // The network: one integrator per state equation, the equation in its last line.

  riemann_integrator #(
      .Bits(CoefBits)
  ) u_x (
      .clk_i,
      .load_i(load_i[0]),
      .initial_i(normal_i),
      .take_i,
      .close_i,
      .triple_i,
      .step_i,
      .last_i,
      .digit_i,
      .advance_i,
      .zeroth_i,
      .collect_i,
      .first_i,
      .sum_o(sum_x_o),
      .u_i(f),
      .coef_o(x)
  );

  riemann_integrator #(
      .Bits(CoefBits)
  ) u_y (
      .clk_i,
      .load_i(load_i[1]),
      .initial_i(normal_i),
      .take_i,
      .close_i,
      .triple_i,
      .step_i,
      .last_i,
      .digit_i,
      .advance_i,
      .zeroth_i,
      .collect_i,
      .first_i,
      .sum_o(sum_y_o),
      .u_i(g),
      .coef_o(y)
  );

  riemann_integrator #(
      .Bits(CoefBits)
  ) u_z (
      .clk_i,
      .load_i(load_i[2]),
      .initial_i(normal_i),
      .take_i,
      .close_i,
      .triple_i,
      .step_i,
      .last_i,
      .digit_i,
      .advance_i,
      .zeroth_i,
      .collect_i,
      .first_i,
      .sum_o(sum_z_o),
      .u_i(h),
      .coef_o(z)
  );

  riemann_integrator #(
      .Bits(CoefBits),
      .Negative(1)
  ) u_f (
      .clk_i,
      .load_i(load_i[0]),
      .initial_i(tangent_i),
      .take_i,
      .close_i,
      .triple_i,
      .step_i,
      .last_i,
      .digit_i,
      .advance_i,
      .zeroth_i,
      .collect_i,
      .first_i,
      .sum_o(unused_sum_f),
      .u_i(x),
      .coef_o(f)
  );

  riemann_integrator #(
      .Bits(CoefBits),
      .Negative(1)
  ) u_g (
      .clk_i,
      .load_i(load_i[1]),
      .initial_i(tangent_i),
      .take_i,
      .close_i,
      .triple_i,
      .step_i,
      .last_i,
      .digit_i,
      .advance_i,
      .zeroth_i,
      .collect_i,
      .first_i,
      .sum_o(unused_sum_g),
      .u_i(y),
      .coef_o(g)
  );

  riemann_integrator #(
      .Bits(CoefBits),
      .Negative(1)
  ) u_h (
      .clk_i,
      .load_i(load_i[2]),
      .initial_i(tangent_i),
      .take_i,
      .close_i,
      .triple_i,
      .step_i,
      .last_i,
      .digit_i,
      .advance_i,
      .zeroth_i,
      .collect_i,
      .first_i,
      .sum_o(unused_sum_h),
      .u_i(z),
      .coef_o(h)
  );

  assign x_o = x;
  assign y_o = y;
  assign z_o = z;
  assign f_o = f;
  assign g_o = g;
  assign h_o = h;

endmodule
`default_nettype wire
