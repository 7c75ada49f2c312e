// SPDX-License-Identifier: Apache-2.0
// Sine and cosine, [Chikurov] Fig. 2: two Riemann integrators.
//
//     dy/ds = phi z        dz/ds = -phi y
//
// Twin: hls::Oscillator.  Words: CoefBits, CoefBits - 2 fraction bits.
`default_nettype none
module sine_cosine_network #(
    parameter int CoefBits = 36  // [18, 36]
) (
    input wire logic clk_i,

    // Initial conditions
    input wire logic                       load_i,
    input wire logic signed [CoefBits-1:0] sine_i,
    input wire logic signed [CoefBits-1:0] cosine_i,

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

    output logic signed [CoefBits-1:0] y_o,
    output logic signed [CoefBits-1:0] z_o
);

  logic signed [CoefBits-1:0] y;
  logic signed [CoefBits-1:0] z;

  logic signed [CoefBits-1:0] unused_sum_y;
  logic signed [CoefBits-1:0] unused_sum_z;

  riemann_integrator #(
      .Bits(CoefBits)
  ) u_y (
      .clk_i,
      .load_i,
      .initial_i(sine_i),
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
      .sum_o(unused_sum_y),
      .u_i(z),
      .coef_o(y)
  );

  riemann_integrator #(
      .Bits(CoefBits),
      .Negative(1)
  ) u_z (
      .clk_i,
      .load_i,
      .initial_i(cosine_i),
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
      .sum_o(unused_sum_z),
      .u_i(y),
      .coef_o(z)
  );

  assign y_o = y;
  assign z_o = z;

endmodule
`default_nettype wire
