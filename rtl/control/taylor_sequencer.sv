// SPDX-License-Identifier: Apache-2.0
// One integration step of a network of Riemann integrators: order after order, the weights
// w[i] = floor(theta reciprocal[i] / 2^(Bits-1) + 1/2) made on the way, each while the order before
// it is multiplied.  Slots of Digits + 2 cycles (rtl/arithmetic/digit_multiplier.sv):
//
//   cycle            what
//   0                start_i and ready_o; fresh_i: the state will be loaded, not advanced
//   1                slot 0: theta times the sums of the step before (take_o, close_o); w[2]
//   Digits+3         advance_o (unless fresh): state <- state + product
//   Digits+4         zeroth_o: coefficients of order 0; order 1 is copied
//   Digits+5         slot 1: collect_o, order_o = 1; take_o; order 2 is multiplied; w[3]
//   ...              slot i: collect_o, order_o = i; order i+1; w[i+2]
//   Latency - 1      collect_o, order_o = Order, done_o; next cycle ready_o again
//
//   Latency = Order (Digits + 2) + 4: clocks from one start to the next
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
    output logic       take_o,
    output logic       close_o,
    output logic       triple_o,
    output logic       step_o,
    output logic       last_o,
    output logic [1:0] digit_o,
    output logic       advance_o,
    output logic       zeroth_o,
    output logic       collect_o,
    output logic       first_o,

    output logic [3:0] order_o,
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
    Advance,
    Zeroth,
    Done
  } state_t;

  state_t state_q, state_d;
  logic   [3:0] order_q, order_d;  // of the coefficient that is there; 0: the step before closes
  logic   [4:0] digit_q, digit_d;
  logic         fresh_q;

  always_comb begin
    state_d = state_q;
    order_d = order_q;
    digit_d = digit_q;
    case (state_q)
      Idle: begin
        order_d = 4'd0;
        if (start_i) state_d = Take;
      end
      Take: state_d = Triple;
      Triple: begin
        state_d = Digit;
        digit_d = 5'd1;
      end
      Digit: begin
        digit_d = digit_q + 5'd1;
        if (digit_q == 5'(Digits)) begin
          order_d = order_q + 4'd1;
          if (order_q == 4'd0) state_d = Advance;
          else if (order_q == 4'(Order - 1)) state_d = Done;
          else state_d = Take;
        end
      end
      Advance: state_d = Zeroth;
      Zeroth:  state_d = Take;
      default: state_d = Idle;
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= Idle;
      order_q <= 4'd0;
      digit_q <= 5'd0;
      fresh_q <= 1'b0;
    end else begin
      state_q <= state_d;
      order_q <= order_d;
      digit_q <= digit_d;
      if (start_i && ready_o) fresh_q <= fresh_i;
    end
  end

  // The order closed by `advance` counts as 0 until the coefficients of order 0 have gone.
  assign ready_o   = state_q == Idle;
  assign take_o    = state_q == Take;
  assign close_o   = state_q == Take && order_q == 4'd0;
  assign triple_o  = state_q == Triple;
  assign step_o    = state_q == Digit;
  assign last_o    = state_q == Digit && digit_q == 5'(Digits);
  assign advance_o = state_q == Advance && !fresh_q;
  assign zeroth_o  = state_q == Zeroth;
  assign done_o    = state_q == Done;
  assign collect_o = done_o || (take_o && !close_o);
  assign first_o   = order_q == 4'd1;
  assign order_o   = order_q;

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

  logic signed [Bits-1:0] next_weight;
  logic        [     1:0] theta_digit;
  digit_multiplier #(
      .Bits(Bits)
  ) u_weight (
      .clk_i,
      .copy_i(1'b0),
      .take_i(take_o),
      .triple_i(triple_o),
      .step_i(step_o),
      .last_i(last_o),
      .digit_i(theta_digit),
      .a_i(next_reciprocal[Bits-1:0]),
      .product_o(next_weight)
  );

  // Digits of both; for odd Bits the doubled word.
  localparam int Shifted = 2 * Digits;
  logic [Bits-1:0] weight;
  logic [Shifted-1:0] weight_q;
  logic [Shifted-1:0] theta_q;
  assign weight      = close_o ? theta_i : next_weight;
  assign digit_o     = weight_q[1:0];
  assign theta_digit = theta_q[1:0];
  always_ff @(posedge clk_i) begin
    if (take_o) begin
      weight_q <= {weight, {(Shifted - Bits) {1'b0}}};
      theta_q  <= {theta_i, {(Shifted - Bits) {1'b0}}};
    end else if (step_o) begin
      weight_q <= {2'b00, weight_q[Shifted-1:2]};
      theta_q  <= {2'b00, theta_q[Shifted-1:2]};
    end
  end

endmodule
`default_nettype wire
