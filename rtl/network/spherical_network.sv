// SPDX-License-Identifier: Apache-2.0
// Spherical interpolator, [Chikurov] Fig. 8 and equation (19): six Riemann integrators.
//
//     x y z   the unit vector n from the circle's centre      dn/ds =  phi t
//     F G H   the unit tangent t = B x n                      dt/ds = -phi n
//
// both times cos(pitch).  Twin: hls/curves/arc.hpp.  Words: CoefBits, CoefBits - 2 fraction
// bits.  The sequencer's cycles apply to all: on the outputs are the coefficients of one order.
`default_nettype none
module spherical_network #(
    parameter int CoefBits = 36  // [18, 36]
) (
    input wire logic clk_i,

    // From taylor_sequencer
    input wire logic [riemann_pkg::ExpansionBits-1:0] control_i,

    // Initial conditions, one axis at a time: bit 0 for x and F, 1 for y and G, 2 for z and H
    input wire logic        [         2:0] load_i,
    input wire logic signed [CoefBits-1:0] normal_i,
    input wire logic signed [CoefBits-1:0] tangent_i,

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

  logic signed [CoefBits-1:0] unused_f, unused_g, unused_h;

  // One integrator per state equation, the equation in its last line.
  // verilog_format: off
  riemann_integrator #(.Bits(CoefBits)) u_x (
      .clk_i, .control_i({load_i[0], control_i}), .initial_i(normal_i), .sum_o(sum_x_o),
      .x_o(x_o), .u_i(f_o));  // dx = phi F ds

  riemann_integrator #(.Bits(CoefBits)) u_y (
      .clk_i, .control_i({load_i[1], control_i}), .initial_i(normal_i), .sum_o(sum_y_o),
      .x_o(y_o), .u_i(g_o));  // dy = phi G ds

  riemann_integrator #(.Bits(CoefBits)) u_z (
      .clk_i, .control_i({load_i[2], control_i}), .initial_i(normal_i), .sum_o(sum_z_o),
      .x_o(z_o), .u_i(h_o));  // dz = phi H ds

  riemann_integrator #(.Bits(CoefBits), .Negative(1)) u_f (
      .clk_i, .control_i({load_i[0], control_i}), .initial_i(tangent_i), .sum_o(unused_f),
      .x_o(f_o), .u_i(x_o));  // dF = -phi x ds

  riemann_integrator #(.Bits(CoefBits), .Negative(1)) u_g (
      .clk_i, .control_i({load_i[1], control_i}), .initial_i(tangent_i), .sum_o(unused_g),
      .x_o(g_o), .u_i(y_o));  // dG = -phi y ds

  riemann_integrator #(.Bits(CoefBits), .Negative(1)) u_h (
      .clk_i, .control_i({load_i[2], control_i}), .initial_i(tangent_i), .sum_o(unused_h),
      .x_o(h_o), .u_i(z_o));  // dH = -phi z ds
  // verilog_format: on

endmodule
`default_nettype wire
