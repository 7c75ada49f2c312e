// SPDX-License-Identifier: Apache-2.0
// Spline interpolator, [Chikurov] Fig. 10 and equation (30): one Riemann integrator (q), three
// scalers (W), twelve Stieltjes integrators (V, P and, with Mode 0, x for each axis; phi, Q, R) and
// an adder; one instance each, its equation in the last lines.  W V P x are in spline_axis.
//
//     dq = phi dtau    dW = 6a' dq    dV = W dq    dP = V.dV    dphi = Q dP    dQ = R dphi
//     R = -3 phi^2     [dx = V dq]
//
// Twin: hls/spline_network.hpp, which has the words' formats.  Between the nodes go series, term
// after term, {there, order, coefficient}; dV, dP, dphi are D = i times the coefficient.
//
// A step: the words of order 0 (and 6a') by their load pulses from initial_i, or all but 6a' from
// the step before by again_i; with the last of them or later start_i.  Then the outputs give every
// coefficient once; done_o, in the clock that spline_sequencer states, with the last of q and x.
// moved_o (the sum of q) and phi_end_o (the sum of phi) are complete 2 clocks later.
//
// 18 x 18 multipliers: 9, with Mode 0 12; q and W have the time to be made digit after digit.  With
// Guest = 1 those of Q and R are one outside, a half_product of factors_o, which is a guest's until
// 40 clocks after start_i and from done_o on.  So Q[i] is made after phi[i] and R[i] after Q[i];
// with Anchor 1 not the last ones, which nobody reads.
`default_nettype none
module spline_network #(
    parameter int Order    = 6,   // [2, 12]
    parameter int CoefBits = 36,  // [18, 36]
    parameter int Mode     = 1,   // 0 series, 1 polynomial
    parameter int Anchor   = 1,   // 0, 1
    parameter int Guest    = 0,   // 0, 1; 1 with Anchor 1 only
    parameter int Form     = 0    // 0 portable, 1 ECP5
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Initial conditions: bit 0 for X, 1 for Y, 2 for Z
    input wire logic        [         2:0] load_six_a_i,
    input wire logic        [         2:0] load_v_i,
    input wire logic        [         2:0] load_w_i,
    input wire logic                       load_phi_i,
    input wire logic                       load_q_i,
    input wire logic                       load_r_i,
    input wire logic                       again_i,
    input wire logic signed [CoefBits-1:0] initial_i,

    input  wire logic start_i,
    output logic      ready_o,
    output logic      done_o,

    // Terms {there, order, coefficient}; x of the axes with Mode 0
    output logic        [CoefBits+4:0] q_o,
    output logic        [CoefBits+4:0] x_o,
    output logic        [CoefBits+4:0] y_o,
    output logic        [CoefBits+4:0] z_o,
    output logic        [CoefBits+4:0] vx_o,
    output logic        [CoefBits+4:0] vy_o,
    output logic        [CoefBits+4:0] vz_o,
    output logic        [CoefBits+4:0] wx_o,
    output logic        [CoefBits+4:0] wy_o,
    output logic        [CoefBits+4:0] wz_o,
    output logic signed [CoefBits-1:0] moved_o,
    output logic signed [CoefBits-1:0] phi_end_o,

    output logic      [37:0] factors_o,
    input  wire logic [35:0] product_i
);

  initial if (Order < 2 || Order > 12) $fatal(1, "Order must be in [2, 12]");
  initial if (Mode < 0 || Mode > 1) $fatal(1, "Mode must be 0 or 1");
  initial if (Anchor < 0 || Anchor > 1) $fatal(1, "Anchor must be 0 or 1");
  initial if (Guest < 0 || Guest > 1) $fatal(1, "Guest must be 0 or 1");
  initial if (Guest != 0 && Anchor == 0) $fatal(1, "Guest 1 works with Anchor 1 only");

  localparam int TermBits = CoefBits + 5;

  logic start_v;
  logic start_x;
  logic start_p;
  logic start_phi;
  logic [3:0] order;
  spline_sequencer #(
      .Order (Order),
      .Bits  (CoefBits),
      .Mode  (Mode),
      .Anchor(Anchor)
  ) u_sequencer (
      .clk_i,
      .rst_ni,
      .start_i,
      .ready_o,
      .start_v_o(start_v),
      .start_x_o(start_x),
      .start_p_o(start_p),
      .start_phi_o(start_phi),
      .order_o(order),
      .done_o
  );

  // The series, and what nobody reads of them.
  logic [TermBits-1:0] phi;
  logic [TermBits-1:0] dphi;
  logic [TermBits-1:0] cube;  // Q = -phi^3
  logic [TermBits-1:0] square;  // R = -3 phi^2
  logic [TermBits-1:0] dpx;
  logic [TermBits-1:0] dpy;
  logic [TermBits-1:0] dpz;
  logic [TermBits-1:0] dp;
  logic [TermBits-1:0] unused_dcube;
  logic signed [CoefBits-1:0] unused_cube_state;
  logic signed [CoefBits-1:0] unused_square_state;

  // Digits of 1/i for q, of q for the scalers.
  logic take_q;
  logic triple_q;
  logic step_q;
  logic last_q;
  logic [1:0] digit_q;
  logic collect_q;
  logic first_q;
  logic there_q;
  logic [3:0] order_q;
  logic [CoefBits-1:0] coef_q;
  order_digits #(
      .Bits(CoefBits),
      .Last(Order)
  ) u_order_digits (
      .clk_i,
      .rst_ni,
      .there_i(phi[TermBits-1]),
      .order_i(phi[TermBits-2:CoefBits]),
      .take_o(take_q),
      .triple_o(triple_q),
      .step_o(step_q),
      .last_o(last_q),
      .digit_o(digit_q),
      .collect_o(collect_q),
      .first_o(first_q),
      .there_o(there_q),
      .order_o(order_q)
  );
  assign q_o = {there_q, order_q, coef_q};

  logic [11:0] digits;
  word_digits #(
      .Bits(CoefBits),
      .Last((Anchor != 0) ? Order - 2 : Order)
  ) u_word_digits (
      .clk_i,
      .rst_ni,
      .q_i(q_o),
      .digits_o(digits)
  );

  // The network: one node per state equation, the equation in its last lines.

  riemann_integrator #(
      .Bits(CoefBits)
  ) u_q (
      .clk_i,
      .load_i(1'b0),
      .initial_i({CoefBits{1'b0}}),
      .take_i(take_q),
      .close_i(1'b0),
      .triple_i(triple_q),
      .step_i(step_q),
      .last_i(last_q),
      .digit_i(digit_q),
      .advance_i(1'b0),
      .zeroth_i(1'b0),
      .collect_i(collect_q),
      .first_i(first_q),
      .sum_o(moved_o),
      .u_i(phi[CoefBits-1:0]),
      .coef_o(coef_q)
  );

  spline_axis #(
      .CoefBits(CoefBits),
      .Mode(Mode),
      .Form(Form)
  ) u_x (
      .clk_i,
      .rst_ni,
      .load_six_a_i(load_six_a_i[0]),
      .load_v_i(load_v_i[0]),
      .load_w_i(load_w_i[0]),
      .again_i,
      .initial_i,
      .start_v_i(start_v),
      .start_x_i(start_x),
      .start_p_i(start_p),
      .order_i(order),
      .digits_i(digits),
      .phi_i(phi),
      .w_o(wx_o),
      .v_o(vx_o),
      .x_o(x_o),
      .dp_o(dpx)
  );

  spline_axis #(
      .CoefBits(CoefBits),
      .Mode(Mode),
      .Form(Form)
  ) u_y (
      .clk_i,
      .rst_ni,
      .load_six_a_i(load_six_a_i[1]),
      .load_v_i(load_v_i[1]),
      .load_w_i(load_w_i[1]),
      .again_i,
      .initial_i,
      .start_v_i(start_v),
      .start_x_i(start_x),
      .start_p_i(start_p),
      .order_i(order),
      .digits_i(digits),
      .phi_i(phi),
      .w_o(wy_o),
      .v_o(vy_o),
      .x_o(y_o),
      .dp_o(dpy)
  );

  spline_axis #(
      .CoefBits(CoefBits),
      .Mode(Mode),
      .Form(Form)
  ) u_z (
      .clk_i,
      .rst_ni,
      .load_six_a_i(load_six_a_i[2]),
      .load_v_i(load_v_i[2]),
      .load_w_i(load_w_i[2]),
      .again_i,
      .initial_i,
      .start_v_i(start_v),
      .start_x_i(start_x),
      .start_p_i(start_p),
      .order_i(order),
      .digits_i(digits),
      .phi_i(phi),
      .w_o(wz_o),
      .v_o(vz_o),
      .x_o(z_o),
      .dp_o(dpz)
  );

  adder #(
      .Bits(CoefBits)
  ) u_p (
      .clk_i,
      .rst_ni,
      .a_i  (dpx),
      .b_i  (dpy),
      .c_i  (dpz),
      .sum_o(dp)
  );

  logic [37:0] unused_factors;
  stieltjes_integrator #(
      .Bits (CoefBits),
      .Shift(CoefBits - 3),
      .Drop (2),
      .Form (Form)
  ) u_phi (
      .clk_i,
      .rst_ni,
      .load_i(load_phi_i),
      .again_i,
      .initial_i,
      .start_i(start_phi),
      .order_i(order),
      .state_o(phi_end_o),
      .u_i(cube),
      .s_i(dp),
      .d_o(dphi),
      .x_o(phi),
      .factors_o(unused_factors),
      .product_i(36'd0)
  );

  // One after the other: phi[i], Q[i], R[i].
  localparam int TopCube = (Anchor != 0) ? Order - 2 : Order;
  localparam int TopSquare = (Anchor == 0) ? Order : (Order > 3) ? Order - 3 : 0;
  localparam logic [15:0] CubeOrders = 16'((1 << (TopCube + 1)) - 2);
  localparam logic [15:0] SquareOrders = 16'((1 << (TopSquare + 1)) - 2);
  localparam int Own = (Guest != 0) ? 0 : 1;
  logic start_cube;
  logic start_square;
  logic [37:0] cube_factors;
  logic [37:0] square_factors;
  assign start_cube = phi[TermBits-1] && CubeOrders[phi[TermBits-2:CoefBits]];
  assign start_square = cube[TermBits-1] && SquareOrders[cube[TermBits-2:CoefBits]];
  assign factors_o = cube_factors | square_factors;

  stieltjes_integrator #(
      .Bits (CoefBits),
      .Shift(CoefBits - 1),
      .Own  (Own),
      .Form (Form)
  ) u_cube (
      .clk_i,
      .rst_ni,
      .load_i(load_q_i),
      .again_i,
      .initial_i,
      .start_i(start_cube),
      .order_i(phi[TermBits-2:CoefBits]),
      .state_o(unused_cube_state),
      .u_i(square),
      .s_i(dphi),
      .d_o(unused_dcube),
      .x_o(cube),
      .factors_o(cube_factors),
      .product_i
  );

  square_integrator #(
      .Bits(CoefBits),
      .Own (Own),
      .Form(Form)
  ) u_square (
      .clk_i,
      .rst_ni,
      .load_i(load_r_i),
      .again_i,
      .initial_i,
      .start_i(start_square),
      .order_i(cube[TermBits-2:CoefBits]),
      .state_o(unused_square_state),
      .phi_i(phi),
      .r_o(square),
      .factors_o(square_factors),
      .product_i
  );

endmodule
`default_nettype wire
