// SPDX-License-Identifier: Apache-2.0
// One integration step of a network of Riemann integrators: order after order, the weights
// w[i] = floor(theta reciprocal[i] / 2^(Bits-1) + 1/2) made on the way, each while the order before
// it is multiplied.  Slots of Digits + 3 cycles (rtl/multiplier/digit_multiplier.sv):
//
//   cycle            control_o
//   0                start_i and ready_o; fresh_i: the state will be loaded, not advanced
//   1                slot 0: Take, Close: theta times the sums of the step before; w[2]
//   Digits + 4       Advance (unless fresh): state <- state + product
//   Digits + 5       Zeroth, Take: coefficients of order 0, whose product is order 1
//   Digits + 6       Triple
//   Digits + 7       slot 1: Collect, First, Take: order 1 is there; order 2; w[3]
//   ...              slot i: Collect, Take: order i is there; order i + 1; w[i+2]
//   Latency - 1      Collect: order Order; next cycle ready_o again
//
//   Latency = Order (Digits + 3) + 5: clocks from one start to the next
//
// Integrators follow a clock later.  So do zeroth_there_o, collect_there_o, order_there_o and
// done_o, which name the integrators' outputs.
`default_nettype none
module taylor_sequencer #(
    parameter int Order = 6,  // [2, 12]
    parameter int Bits  = 36  // [18, 36]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic            start_i,
    input  wire logic            fresh_i,
    input  wire logic [Bits-1:0] theta_i,  // Bits - 1 fraction bits, steady from cycle 1
    output logic                 ready_o,

    // To the integrators
    output logic [riemann_pkg::ExpansionBits-1:0] control_o,

    // The integrators' outputs
    output logic       zeroth_there_o,
    output logic       collect_there_o,
    output logic [3:0] order_there_o,
    output logic       done_o
);

  initial if (Order < 2 || Order > 12) $fatal(1, "Order must be in [2, 12]");
  initial if (Bits < 18 || Bits > 36) $fatal(1, "Bits must be in [18, 36]");

  localparam int Digits = curvecore_pkg::weight_digits(Bits);

  typedef enum logic [2:0] {
    Idle,
    Take,
    Triple,
    Digit,
    Settle,
    Advance,
    Zeroth,
    Done
  } state_t;

  state_t state_q, state_d;
  logic [3:0] order_q, order_d;  // order of the present coefficient; 0: the step before closes
  logic [4:0] digit_q, digit_d;
  logic fresh_q;
  logic copy_q, copy_d;  // order 1 is a copy, without a multiplication
  logic order_zero_q;
  logic order_last_q;  // order_q is Order - 1
  logic digit_last_q;  // digit_q is Digits

  always_comb begin
    state_d = state_q;
    order_d = order_q;
    digit_d = digit_q;
    copy_d  = copy_q;
    case (state_q)
      Idle: begin
        order_d = 4'd0;
        copy_d  = 1'b0;
        if (start_i) state_d = Take;
      end
      Take: state_d = Triple;
      Triple: begin
        digit_d = 5'd1;
        copy_d  = 1'b0;
        state_d = Digit;
        if (copy_q) begin
          order_d = 4'd1;
          state_d = Take;
        end
      end
      Digit: begin
        digit_d = digit_q + 5'd1;
        if (digit_last_q) state_d = Settle;
      end
      Settle: begin
        order_d = order_q + 4'd1;
        state_d = Take;
        if (order_last_q) state_d = Done;
        if (order_zero_q) begin
          order_d = 4'd0;
          state_d = Advance;
        end
      end
      Advance: begin
        copy_d  = 1'b1;
        state_d = Zeroth;
      end
      Zeroth: state_d = Triple;
      default: state_d = Idle;
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q      <= Idle;
      order_q      <= 4'd0;
      order_zero_q <= 1'b1;
      order_last_q <= 1'b0;
      digit_q      <= 5'd0;
      digit_last_q <= 1'b0;
      fresh_q      <= 1'b0;
      copy_q       <= 1'b0;
    end else begin
      state_q      <= state_d;
      order_q      <= order_d;
      order_zero_q <= order_d == 4'd0;
      order_last_q <= order_d == 4'(Order - 1);
      digit_q      <= digit_d;
      digit_last_q <= digit_d == 5'(Digits);
      copy_q       <= copy_d;
      if (start_i && ready_o) fresh_q <= fresh_i;
    end
  end

  // Controls are registers, for they reach far, in terms of the present state, which is ready
  // early.
  logic order_done;
  logic digit_more;
  logic copy;
  assign order_done = state_q == Settle && !order_zero_q;
  assign digit_more = state_q == Digit && !digit_last_q;
  assign copy       = state_q == Triple && copy_q;

  logic take_q;
  logic close_q;
  logic triple_q;
  logic step_q;
  logic last_q;
  logic advance_q;
  logic zeroth_q;
  logic collect_q;
  logic first_q;
  always_ff @(posedge clk_i) begin
    take_q <= (state_q == Idle && start_i) || (order_done && !order_last_q) || copy
        || state_q == Advance;
    close_q <= state_q == Idle && start_i;
    triple_q <= state_q == Take || state_q == Zeroth;
    step_q <= digit_more || (state_q == Triple && !copy_q);
    last_q <= digit_more && digit_q == 5'(Digits - 1);
    advance_q <= state_q == Settle && order_zero_q && !fresh_q;
    zeroth_q <= state_q == Advance;
    collect_q <= order_done || copy;
    first_q <= copy;
  end
  assign ready_o = state_q == Idle;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      zeroth_there_o  <= 1'b0;
      collect_there_o <= 1'b0;
      done_o          <= 1'b0;
    end else begin
      zeroth_there_o  <= zeroth_q;
      collect_there_o <= collect_q;
      done_o          <= state_q == Done;
    end
    order_there_o <= order_q;
  end

  // Weights: theta in slot 0, then w[2], w[3], ...
  logic [35:0] reciprocal[16];
  for (genvar i = 0; i < 16; i++) begin : g_reciprocal
    if (i >= 2 && i <= Order) begin : g_used
      assign reciprocal[i] = curvecore_pkg::reciprocal(Bits - 1, i);
    end else begin : g_unused
      assign reciprocal[i] = '0;
    end
  end
  logic [ 3:0] next_order;
  logic [35:0] next_reciprocal;
  assign next_order      = order_q + 4'd2;
  assign next_reciprocal = reciprocal[next_order];

  // Digits of both; for odd Bits the doubled word.
  localparam int Shifted = 2 * Digits;
  logic        [Shifted-1:0] theta_q;

  // Order 1 needs no weight: its copy keeps the weight of order 2.
  logic                      take_weight;
  logic                      triple_weight;
  logic signed [   Bits-1:0] unused_base;
  logic signed [   Bits-1:0] next_weight;
  assign take_weight   = take_q && !zeroth_q;
  assign triple_weight = triple_q && !copy_q;
  digit_multiplier #(
      .Bits(Bits)
  ) u_weight (
      .clk_i,
      .digits_i({take_weight, triple_weight, step_q, last_q, theta_q[1:0]}),
      .a_i(next_reciprocal[Bits-1:0]),
      .base_o(unused_base),
      .product_o(next_weight)
  );

  logic [Bits-1:0] weight;
  logic [Shifted-1:0] weight_q;
  assign weight = close_q ? theta_i : next_weight;
  always_ff @(posedge clk_i) begin
    if (take_weight) begin
      weight_q <= {weight, {(Shifted - Bits) {1'b0}}};
      theta_q  <= {theta_i, {(Shifted - Bits) {1'b0}}};
    end else if (step_q) begin
      weight_q <= {2'b00, weight_q[Shifted-1:2]};
      theta_q  <= {2'b00, theta_q[Shifted-1:2]};
    end
  end

  assign control_o = {
    first_q,
    collect_q,
    zeroth_q,
    advance_q,
    close_q,
    take_q,
    triple_q,
    step_q,
    last_q,
    weight_q[1:0]
  };

endmodule
`default_nettype wire
