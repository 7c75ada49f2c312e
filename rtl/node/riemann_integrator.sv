// SPDX-License-Identifier: Apache-2.0
// Riemann integrator: the node  x = x(0) + integral of u ds, or of -u ds,  of a Shannon network,
// one order after the other, all orders from 1 scaled by theta:
//
//     x[0] = state     x[1] = +-u[0]     x[i] = +-w[i] u[i-1],  w[i] = theta / i,   i = 2 .. Order
//     state' = x[0] + theta (x[1] + x[2] + ... + x[Order])
//
// Driven by taylor_sequencer, whose header has the cycles.  Everything happens one clock after its
// control, which is copied here:
//
//   load_i      state <- initial_i (at once)
//   take_i      u, with close_i the sum of the orders, is what will be multiplied
//   advance_i   state <- state + product
//   zeroth_i    coef_o = x[0]
//   first_i     coef_o = x[1]
//   collect_i   coef_o = x[i] joins the sum; the first one starts it
//
// Formats: Bits, Bits - 2 fraction bits; weights Bits - 1 fraction bits.  Rounding: one per order,
// one per step.  No saturation: the planner sees to |x| < 2.
`default_nettype none
module riemann_integrator #(
    parameter int Bits     = 36,  // [18, 36]
    parameter int Negative = 0    // 1: integral of -u
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
    output logic signed      [Bits-1:0] sum_o    // +-(x[1] + ... + x[i]), a clock later
);

  logic       take;
  logic       close;
  logic       triple;
  logic       step;
  logic       last;
  logic [1:0] digit;
  logic       advance;
  logic       zeroth;
  logic       collect;
  logic       first;
  local_copy #(
      .Bits(11)
  ) u_control (
      .clk_i,
      .data_i({
        take_i, close_i, triple_i, step_i, last_i, digit_i, advance_i, zeroth_i, collect_i, first_i
      }),
      .data_o({take, close, triple, step, last, digit, advance, zeroth, collect, first})
  );

  logic signed [Bits-1:0] operand;
  logic signed [Bits-1:0] base;
  logic signed [Bits-1:0] product;
  assign operand = close ? sum_o : u_i;

  digit_multiplier #(
      .Bits(Bits),
      .Negative(Negative)
  ) u_multiplier (
      .clk_i,
      .take_i(take),
      .triple_i(triple),
      .step_i(step),
      .last_i(last),
      .digit_i(digit),
      .a_i(operand),
      .base_o(base),
      .product_o(product)
  );

  logic signed [Bits-1:0] state_q;
  logic                   collect_q;
  logic                   first_q;

  // A negative node negates what it multiplies: it keeps its sum negative, so that theta times the
  // sum comes out right.
  logic signed [Bits-1:0] sum;
  logic signed [Bits-1:0] term;
  assign sum  = first_q ? '0 : sum_o;
  assign term = first_q ? base : product;

  always_comb begin
    coef_o = product;
    if (zeroth) coef_o = state_q;
    if (first) coef_o = base;
  end
  always_ff @(posedge clk_i) begin
    collect_q <= collect;
    first_q   <= first;
    if (load_i) state_q <= initial_i;
    else if (advance) state_q <= state_q + product;
    if (collect_q) sum_o <= (Negative != 0) ? sum - term : sum + term;
  end

endmodule
`default_nettype wire
