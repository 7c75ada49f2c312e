// SPDX-License-Identifier: Apache-2.0
// Riemann integrator: the node  x = x(0) + integral of u ds  of a Shannon network, one order after
// the other, all orders from 1 scaled by theta:
//
//     x[0] = state     x[1] = u[0]     x[i] = w[i] u[i-1],  w[i] = theta / i,   i = 2 .. Order
//     state' = x[0] + theta (x[1] + x[2] + ... + x[Order])
//
// Driven by taylor_sequencer, whose header has the cycles:
//
//   load_i      state <- initial_i
//   close_i     with take_i: the sum of the orders is multiplied, not u
//   advance_i   state <- state + product
//   zeroth_i    coef_o = x[0]; the product becomes u[0], that is x[1]
//   collect_i   coef_o = x[i] joins the sum; with first_i (i = 1) it starts it
//
// Formats: Bits, Bits - 2 fraction bits; weights Bits - 1 fraction bits.  Rounding: one per order, one
// per step.  No saturation: whoever prepares the segment sees to |x| < 2.
`default_nettype none
module riemann_integrator #(
    parameter int Bits = 36  // [18, 36]
) (
    input wire logic clk_i,

    // Initial condition
    input wire logic                   load_i,
    input wire logic signed [Bits-1:0] initial_i,

    // Expansion
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

    input  wire logic signed [Bits-1:0] u_i,     // u[i-1]
    output logic signed      [Bits-1:0] coef_o,  // x[i]
    output logic signed      [Bits-1:0] sum_o    // x[1] + ... + x[i]
);

  logic signed [Bits-1:0] operand;
  logic signed [Bits-1:0] product;
  assign operand = close_i ? sum_o : u_i;

  digit_multiplier #(
      .Bits(Bits)
  ) u_multiplier (
      .clk_i,
      .copy_i(zeroth_i),
      .take_i,
      .triple_i,
      .step_i,
      .last_i,
      .digit_i,
      .a_i(operand),
      .product_o(product)
  );

  logic signed [Bits-1:0] state_q;
  logic signed [Bits-1:0] sum_before;
  assign coef_o     = zeroth_i ? state_q : product;
  assign sum_before = first_i ? '0 : sum_o;
  always_ff @(posedge clk_i) begin
    if (load_i) state_q <= initial_i;
    else if (advance_i) state_q <= state_q + product;
    if (collect_i) sum_o <= sum_before + product;
  end

endmodule
`default_nettype wire
