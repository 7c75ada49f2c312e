// SPDX-License-Identifier: Apache-2.0
// Sine and cosine, [Chikurov] Fig. 2: two Riemann integrators.
//
//     dy/ds = phi z        dz/ds = -phi y
//
// Twin: hls::SineCosineNetwork.  Words: CoefBits, CoefBits - 2 fraction bits.
`default_nettype none
module sine_cosine_network #(
    parameter int CoefBits = 36  // [18, 36]
) (
    input wire logic clk_i,

    // From taylor_sequencer, with Load
    input wire logic [riemann_pkg::Bits-1:0] control_i,

    // Initial conditions
    input wire logic signed [CoefBits-1:0] sine_i,
    input wire logic signed [CoefBits-1:0] cosine_i,

    output logic signed [CoefBits-1:0] y_o,
    output logic signed [CoefBits-1:0] z_o
);

  logic signed [CoefBits-1:0] unused_y, unused_z;

  // One integrator per state equation, the equation in its last line.
  // verilog_format: off
  riemann_integrator #(.Bits(CoefBits)) u_y (
      .clk_i, .control_i, .initial_i(sine_i), .sum_o(unused_y),
      .x_o(y_o), .u_i(z_o));  // dy = phi z ds

  riemann_integrator #(.Bits(CoefBits), .Negative(1)) u_z (
      .clk_i, .control_i, .initial_i(cosine_i), .sum_o(unused_z),
      .x_o(z_o), .u_i(y_o));  // dz = -phi y ds
  // verilog_format: on

endmodule
`default_nettype wire
