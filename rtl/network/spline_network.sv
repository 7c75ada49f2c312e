// SPDX-License-Identifier: Apache-2.0
// Spline interpolator, [Chikurov] Fig. 10 and equation (30): one Riemann integrator (q), three
// scalers (W), twelve Stieltjes integrators (V, P and, with Mode 0, x for each axis; phi, Q, R) and
// an adder; one instance each, its equation in the last lines.  W V P x are in spline_axis.
//
//     dq = phi dtau    dW = 6a' dq    dV = W dq    dP = V.dV    dphi = Q dP    dQ = R dphi
//     R = -3 phi^2     [dx = V dq]
//
// Twin: hls/curves/spline.hpp, which has the words' formats.  Between the nodes run series, term
// after term, {there, order, coefficient}; dV, dP, dphi are D = i times the coefficient.
//
// A step: the words of order 0 (and 6a') by their pulses in load_i from initial_i, or all but 6a'
// from the step before by Again; with the last of them or later start_i.  Then the outputs give
// every coefficient once; done_o, in the clock that spline_sequencer states, with the last of q and
// x.  moved_o (the sum of q) and phi_end_o (the sum of phi) are complete 2 clocks later.
//
// 18 x 18 multipliers: 9, with Mode 0 12; q and W have time to be made digit after digit.  With
// Guest = 1 those of Q and R are one outside, a half_product of factors_o, which is a guest's until
// 40 clocks after start_i and from done_o on.  So Q[i] is made after phi[i] and R[i] after Q[i];
// with Anchor 1 without the last ones, which are not read.
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

    // Initial conditions
    input wire logic        [spline_pkg::LoadBits-1:0] load_i,
    input wire logic signed [            CoefBits-1:0] initial_i,

    input  wire logic start_i,
    output logic      ready_o,
    output logic      done_o,

    // Terms {there, order, coefficient}; three are X Y Z, X in the low bits; x with Mode 0
    output logic        [   CoefBits+4:0] q_o,
    output logic        [3*CoefBits+14:0] x_o,
    output logic        [3*CoefBits+14:0] v_o,
    output logic        [3*CoefBits+14:0] w_o,
    output logic signed [   CoefBits-1:0] moved_o,
    output logic signed [   CoefBits-1:0] phi_end_o,

    output logic      [37:0] factors_o,
    input  wire logic [35:0] product_i
);

  initial if (Order < 2 || Order > 12) $fatal(1, "Order must be in [2, 12]");
  initial if (Mode < 0 || Mode > 1) $fatal(1, "Mode must be 0 or 1");
  initial if (Anchor < 0 || Anchor > 1) $fatal(1, "Anchor must be 0 or 1");
  initial if (Guest < 0 || Guest > 1) $fatal(1, "Guest must be 0 or 1");
  initial if (Guest != 0 && Anchor == 0) $fatal(1, "Guest 1 works with Anchor 1 only");

  localparam int TermBits = CoefBits + 5;

  logic [spline_pkg::ControlBits-1:0] control;
  logic                               start_phi;
  logic [                        3:0] order;
  assign start_phi = control[spline_pkg::StartPhi];
  assign order     = control[spline_pkg::Order+:4];
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
      .control_o(control),
      .done_o
  );

  // The series.
  logic [TermBits-1:0] phi;
  logic [TermBits-1:0] dphi;
  logic [TermBits-1:0] cube;  // Q = -phi^3
  logic [TermBits-1:0] square;  // R = -3 phi^2
  logic [TermBits-1:0] dpx, dpy, dpz, dp;

  // Digits of 1/i for q, of q for the scalers.
  logic [riemann_pkg::ExpansionBits-1:0] control_q;
  logic                                  there_q;
  logic [                           3:0] order_q;
  logic [                  CoefBits-1:0] coef_q;
  order_digits #(
      .Bits(CoefBits),
      .Last(Order)
  ) u_order_digits (
      .clk_i,
      .rst_ni,
      .there_i  (phi[TermBits-1]),
      .order_i  (phi[TermBits-2:CoefBits]),
      .control_o(control_q),
      .there_o  (there_q),
      .order_o  (order_q)
  );
  assign q_o = {there_q, order_q, coef_q};

  logic [scaler_pkg::DigitsBits-1:0] digits;
  word_digits #(
      .Bits(CoefBits),
      .Last((Anchor != 0) ? Order - 2 : Order)
  ) u_word_digits (
      .clk_i,
      .rst_ni,
      .q_i(q_o),
      .digits_o(digits)
  );

  // One after the other: phi[i], Q[i], R[i].
  localparam int TopCube = (Anchor != 0) ? Order - 2 : Order;
  localparam int TopSquare = (Anchor == 0) ? Order : (Order > 3) ? Order - 3 : 0;
  localparam logic [15:0] CubeOrders = 16'((1 << (TopCube + 1)) - 2);
  localparam logic [15:0] SquareOrders = 16'((1 << (TopSquare + 1)) - 2);
  localparam int Own = (Guest != 0) ? 0 : 1;
  logic [ 3:0] order_phi;
  logic [ 3:0] order_cube;
  logic        start_cube;
  logic        start_square;
  logic [37:0] cube_factors;
  logic [37:0] square_factors;
  assign order_phi    = phi[TermBits-2:CoefBits];
  assign order_cube   = cube[TermBits-2:CoefBits];
  assign start_cube   = phi[TermBits-1] && CubeOrders[order_phi];
  assign start_square = cube[TermBits-1] && SquareOrders[order_cube];
  assign factors_o    = cube_factors | square_factors;

  // Order 0 of phi, Q, R.
  logic again;
  logic load_phi, load_cube, load_square;
  assign again       = load_i[spline_pkg::Again];
  assign load_phi    = load_i[spline_pkg::Phi];
  assign load_cube   = load_i[spline_pkg::Q];
  assign load_square = load_i[spline_pkg::R];

  // Words that are not read.
  logic [37:0] unused_factors;
  logic [TermBits-1:0] unused_dcube;
  logic signed [CoefBits-1:0] unused_cube, unused_square;

  // One node per state equation, the equation in its last line.
  // verilog_format: off
  riemann_integrator #(.Bits(CoefBits)) u_q (
      .clk_i, .control_i({1'b0, control_q}), .initial_i({CoefBits{1'b0}}), .sum_o(moved_o),
      .x_o(coef_q), .u_i(phi[CoefBits-1:0]));  // dq = phi dtau

  spline_axis #(.Axis(0), .CoefBits(CoefBits), .Mode(Mode), .Form(Form)) u_x (
      .clk_i, .rst_ni, .load_i, .initial_i, .control_i(control), .digits_i(digits), .phi_i(phi),
      .w_o(w_o[0+:TermBits]), .v_o(v_o[0+:TermBits]), .x_o(x_o[0+:TermBits]),
      .dp_o(dpx));  // dP = V dV

  spline_axis #(.Axis(1), .CoefBits(CoefBits), .Mode(Mode), .Form(Form)) u_y (
      .clk_i, .rst_ni, .load_i, .initial_i, .control_i(control), .digits_i(digits), .phi_i(phi),
      .w_o(w_o[TermBits+:TermBits]), .v_o(v_o[TermBits+:TermBits]), .x_o(x_o[TermBits+:TermBits]),
      .dp_o(dpy));

  spline_axis #(.Axis(2), .CoefBits(CoefBits), .Mode(Mode), .Form(Form)) u_z (
      .clk_i, .rst_ni, .load_i, .initial_i, .control_i(control), .digits_i(digits), .phi_i(phi),
      .w_o(w_o[2*TermBits+:TermBits]), .v_o(v_o[2*TermBits+:TermBits]),
      .x_o(x_o[2*TermBits+:TermBits]), .dp_o(dpz));

  adder #(.Bits(CoefBits)) u_p (
      .clk_i, .rst_ni,
      .sum_o(dp), .a_i(dpx), .b_i(dpy), .c_i(dpz));  // dP = V.dV

  stieltjes_integrator #(.Bits(CoefBits), .Shift(CoefBits - 3), .Drop(2), .Form(Form)) u_phi (
      .clk_i, .rst_ni, .control_i({start_phi, order, load_phi, again}), .initial_i,
      .state_o(phi_end_o), .factors_o(unused_factors), .product_i(36'd0),
      .x_o(phi), .d_o(dphi), .u_i(cube), .s_i(dp));  // dphi = Q dP

  stieltjes_integrator #(.Bits(CoefBits), .Shift(CoefBits - 1), .Own(Own), .Form(Form)) u_cube (
      .clk_i, .rst_ni, .control_i({start_cube, order_phi, load_cube, again}), .initial_i,
      .state_o(unused_cube), .factors_o(cube_factors), .product_i,
      .x_o(cube), .d_o(unused_dcube), .u_i(square), .s_i(dphi));  // dQ = R dphi

  square_integrator #(.Bits(CoefBits), .Own(Own), .Form(Form)) u_square (
      .clk_i, .rst_ni, .control_i({start_square, order_cube, load_square, again}), .initial_i,
      .state_o(unused_square), .factors_o(square_factors), .product_i,
      .r_o(square), .phi_i(phi));  // R = -3 phi^2
  // verilog_format: on

endmodule
`default_nettype wire
