// SPDX-License-Identifier: Apache-2.0
// The orders of the spline network, one chain of integrators after the other:
//
//     DV[i] -> DP[i] -> adder -> Dphi[i] -> phi[i] -> DV[i+1] ...       i = 1 .. Top
//
//   cycle          0   1   3i + 7      6i + 14        9i + 28 + Pause (i+1's cycle 1)
//   start_i        1
//   StartV             1                              1        of control_o
//   StartX             1                              1        of order Order too: nothing follows
//   StartP                 1
//   StartPhi                           1
//   Order              i                              i + 1
//
// Each start comes as early as the newest word permits, which a node reads i + 1 clocks later.
// Everything else follows by itself, q[i] W[i] V[i] x[i] R[i] Q[i] beside the chain.  Pause, before
// order 3: W[2] has two products by digits before it and comes max(0, 2 weight_digits - 31) clocks
// late.
//
// done_o comes with the last word of the step, q[Order] or with Mode 0 perhaps x[Order]; from
// start_i to it are
//
//     Anchor 1   9 Top (Top + 1) / 2 + 27 Top + Pause + Rest + 1 clocks     Top = Order - 1
//     Anchor 0   3 Order + 14 less: when every node has its state           Top = Order
//
// with Order 2 and Anchor 0 14 more: when spline_anchor has the step's position, too.
// A state's length and its successor are looked up in registers, a clock late: states are longer.
// ready_o comes a clock after done_o.
`default_nettype none
module spline_sequencer #(
    parameter int Order  = 6,   // [2, 12]
    parameter int Bits   = 36,  // [18, 36]
    parameter int Mode   = 1,   // 0 series, 1 polynomial
    parameter int Anchor = 1    // 0, 1
) (
    input  wire logic                               clk_i,
    input  wire logic                               rst_ni,
    input  wire logic                               start_i,
    output logic                                    ready_o,
    output logic      [spline_pkg::ControlBits-1:0] control_o,
    output logic                                    done_o
);

  localparam int Top = (Anchor != 0) ? Order - 1 : Order;
  localparam int Digits = curvecore_pkg::weight_digits(Bits);
  localparam int Late = 2 * Digits - 31;
  localparam int Pause = (Late > 0) ? Late : 0;

  // Clocks from the start of V (of phi with Anchor 0) of the last order.
  localparam int RestQ = Order + Digits + 6;
  localparam int RestX = 4 * Order + 15;
  localparam int RestSeries = (RestX > RestQ) ? RestX : RestQ;
  localparam int RestAnchored = (Mode == 0) ? RestSeries : RestQ;
  localparam int RestStates = (Order == 2) ? 84 : 12 * Order + 46;
  localparam int Rest = (Anchor != 0) ? RestAnchored : RestStates;

  typedef enum logic [2:0] {
    Idle,
    V,
    P,
    Phi,
    Last
  } state_t;

  // Clocks of a state, less one, by order.
  logic [7:0] v_clocks  [16];
  logic [7:0] p_clocks  [16];
  logic [7:0] phi_clocks[16];
  for (genvar i = 0; i < 16; i++) begin : g_clocks
    assign v_clocks[i]   = 8'(3 * i + 5);
    assign p_clocks[i]   = 8'(3 * i + 6);
    assign phi_clocks[i] = (i == 2) ? 8'(3 * i + 13 + Pause) : 8'(3 * i + 13);
  end

  logic start_v_q;
  logic start_x_q;
  logic start_p_q;
  logic start_phi_q;
  logic [3:0] order_q;
  assign control_o = {start_phi_q, start_p_q, start_x_q, start_v_q, order_q};

  state_t state_q, next, next_q;
  logic [7:0] count_q;
  logic [7:0] clocks;
  logic [7:0] clocks_q;
  logic [3:0] next_order;
  logic [3:0] next_order_q;
  logic       turn_q;
  assign ready_o = state_q == Idle && next_q == V;
  always_comb begin
    next       = state_q;
    next_order = order_q;
    clocks     = v_clocks[order_q];
    case (state_q)
      Idle: begin
        next       = V;
        next_order = 4'd1;
        clocks     = v_clocks[1];
      end
      V: begin
        next   = P;
        clocks = p_clocks[order_q];
      end
      P: begin
        next   = Phi;
        clocks = phi_clocks[order_q];
        if (Anchor == 0 && order_q == 4'(Order)) begin
          next   = Last;
          clocks = 8'(Rest - 1);
        end
      end
      Phi: begin
        next       = V;
        next_order = order_q + 4'd1;
        clocks     = v_clocks[next_order];
        if (Anchor != 0 && order_q == 4'(Top)) begin
          next   = Last;
          clocks = 8'(Rest - 1);
        end
      end
      default: next = Idle;
    endcase
  end

  logic go;
  assign go = (state_q == Idle) ? start_i : turn_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q     <= Idle;
      start_v_q   <= 1'b0;
      start_x_q   <= 1'b0;
      start_p_q   <= 1'b0;
      start_phi_q <= 1'b0;
      done_o      <= 1'b0;
    end else begin
      if (go) state_q <= next_q;
      start_v_q   <= go && next_q == V;
      start_x_q   <= go && (next_q == V || (next_q == Last && Anchor != 0));
      start_p_q   <= go && next_q == P;
      start_phi_q <= go && (next_q == Phi || (next_q == Last && Anchor == 0));
      done_o      <= go && state_q == Last;
    end
  end
  always_ff @(posedge clk_i) begin
    next_q       <= next;
    next_order_q <= next_order;
    clocks_q     <= clocks;
    turn_q       <= !go && count_q == 8'd1;
    count_q      <= go ? clocks_q : count_q - 8'd1;
    if (go && next_q != Idle) order_q <= next_order_q;
  end

endmodule
`default_nettype wire
