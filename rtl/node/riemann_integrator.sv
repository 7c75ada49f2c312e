// SPDX-License-Identifier: Apache-2.0
// Riemann integrator: the node  x = x(0) + integral of u ds, or of -u ds,  of a Shannon network,
// one order after the other, all orders from 1 scaled by theta:
//
//     x[0] = state     x[1] = +-u[0]     x[i] = +-w[i] u[i-1],  w[i] = theta / i,   i = 2 .. Order
//     state' = x[0] + theta (x[1] + x[2] + ... + x[Order])
//
// Driven by taylor_sequencer, whose header has the cycles.  Everything but Load happens one clock
// after its control, which is copied here:
//
//   Load      state <- initial_i
//   Take      u, with Close the sum of the orders, is what will be multiplied
//   Advance   state <- state + product
//   Zeroth    x_o = x[0]
//   First     x_o = x[1]
//   Collect   x_o = x[i] joins the sum; the first one starts it
//
// Formats: Bits, Bits - 2 fraction bits; weights Bits - 1 fraction bits.  Rounding: one per order,
// one per step.  No saturation: the planner sees to |x| < 2.
`default_nettype none
module riemann_integrator #(
    parameter int Bits     = 36,  // [18, 36]
    parameter int Negative = 0    // 1: integral of -u
) (
    input  wire logic                                clk_i,
    input  wire logic        [riemann_pkg::Bits-1:0] control_i,
    input  wire logic signed [             Bits-1:0] initial_i,
    input  wire logic signed [             Bits-1:0] u_i,        // u[i-1]
    output logic signed      [             Bits-1:0] x_o,        // x[i]
    output logic signed      [             Bits-1:0] sum_o       // +-(x[1] + .. + x[i]), a clock on
);

  logic [riemann_pkg::ExpansionBits-1:0] control;
  local_copy #(
      .Bits(riemann_pkg::ExpansionBits)
  ) u_control (
      .clk_i,
      .data_i(control_i[riemann_pkg::ExpansionBits-1:0]),
      .data_o(control)
  );

  logic signed [Bits-1:0] operand;
  logic signed [Bits-1:0] base;
  logic signed [Bits-1:0] product;
  assign operand = control[riemann_pkg::Close] ? sum_o : u_i;

  digit_multiplier #(
      .Bits(Bits),
      .Negative(Negative)
  ) u_multiplier (
      .clk_i,
      .digits_i(control[digits_pkg::Bits-1:0]),
      .a_i(operand),
      .base_o(base),
      .product_o(product)
  );

  logic signed [Bits-1:0] state_q;
  logic                   collect_q;
  logic                   first_q;

  // A negative node negates its factors: it keeps its sum negative, so that theta times the sum has
  // the right sign.
  logic signed [Bits-1:0] sum;
  logic signed [Bits-1:0] term;
  assign sum  = first_q ? '0 : sum_o;
  assign term = first_q ? base : product;

  logic signed [Bits-1:0] higher;
  assign higher = control[riemann_pkg::Zeroth] ? state_q : product;
  assign x_o    = control[riemann_pkg::First] ? base : higher;
  always_ff @(posedge clk_i) begin
    collect_q <= control[riemann_pkg::Collect];
    first_q   <= control[riemann_pkg::First];
    if (control_i[riemann_pkg::Load]) state_q <= initial_i;
    else if (control[riemann_pkg::Advance]) state_q <= state_q + product;
    if (collect_q) sum_o <= (Negative != 0) ? sum - term : sum + term;
  end

endmodule
`default_nettype wire
