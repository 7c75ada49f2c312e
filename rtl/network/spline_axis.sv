// SPDX-License-Identifier: Apache-2.0
// One axis of the spline interpolator, [Chikurov] Fig. 10: a scaler and two Stieltjes integrators,
// with Mode 0 three.
//
//     dW = 6a' dq    dV = W dq    dP = V dV    [dx = V dq]         dq = phi dtau
//
// The network: rtl/network/spline_network.sv.
`default_nettype none
module spline_axis #(
    parameter int Axis     = 0,   // 0 X, 1 Y, 2 Z
    parameter int CoefBits = 36,  // [18, 36]
    parameter int Mode     = 1,   // 0 series, 1 polynomial
    parameter int Form     = 0    // 0 portable, 1 ECP5
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // From spline_anchor and spline_sequencer, for all axes
    input wire logic        [   spline_pkg::LoadBits-1:0] load_i,
    input wire logic signed [               CoefBits-1:0] initial_i,
    input wire logic        [spline_pkg::ControlBits-1:0] control_i,

    // Terms {there, order, coefficient}; q as digits (word_digits)
    input  wire logic [scaler_pkg::DigitsBits-1:0] digits_i,
    input  wire logic [              CoefBits+4:0] phi_i,
    output logic      [              CoefBits+4:0] w_o,
    output logic      [              CoefBits+4:0] v_o,
    output logic      [              CoefBits+4:0] dp_o,
    output logic      [              CoefBits+4:0] x_o
);

  localparam int TermBits = CoefBits + 5;

  logic [3:0] order;
  logic start_v, start_p;
  logic load_six_a, load_v, load_w, again;
  assign order      = control_i[spline_pkg::Order+:4];
  assign start_v    = control_i[spline_pkg::StartV];
  assign start_p    = control_i[spline_pkg::StartP];
  assign load_six_a = load_i[spline_pkg::SixA+Axis];
  assign load_v     = load_i[spline_pkg::V+Axis];
  assign load_w     = load_i[spline_pkg::W+Axis];
  assign again      = load_i[spline_pkg::Again];

  logic unused;
  logic [37:0] unused_factors_v, unused_factors_p;
  logic [TermBits-1:0] dv, unused_p;
  logic signed [CoefBits-1:0] unused_state_w, unused_state_v, unused_state_p;
  assign unused = &{load_i, control_i};  // read by other axes and modes

  // One node per state equation, the equation in its last line.
  // verilog_format: off
  scaler #(.Bits(CoefBits)) u_w (
      .clk_i, .rst_ni, .load_i({load_six_a, load_w, again}), .initial_i, .state_o(unused_state_w),
      .w_o(w_o), .digits_i(digits_i));  // dW = 6a' dq

  stieltjes_integrator #(
      .Bits(CoefBits), .Shift(CoefBits - 2), .Drop(2), .First(0), .Form(Form)) u_v (
      .clk_i, .rst_ni, .control_i({start_v, order, load_v, again}), .initial_i,
      .state_o(unused_state_v), .factors_o(unused_factors_v), .product_i(36'd0),
      .x_o(v_o), .d_o(dv), .u_i(w_o), .s_i(phi_i));  // dV = W dq

  stieltjes_integrator #(.Bits(CoefBits), .Shift(CoefBits - 1), .Quotient(0), .Form(Form)) u_p (
      .clk_i, .rst_ni, .control_i({start_p, order, 2'b00}), .initial_i,
      .state_o(unused_state_p), .factors_o(unused_factors_p), .product_i(36'd0),
      .x_o(unused_p), .d_o(dp_o), .u_i(v_o), .s_i(dv));  // dP = V dV

  if (Mode == 0) begin : g_series
    logic [TermBits-1:0] unused_dx;
    logic signed [CoefBits-1:0] unused_state_x;
    logic [37:0] unused_factors_x;
    stieltjes_integrator #(.Bits(CoefBits), .Shift(CoefBits - 1), .First(0), .Form(Form)) u_x (
        .clk_i, .rst_ni, .control_i({control_i[spline_pkg::StartX], order, 2'b00}), .initial_i,
        .state_o(unused_state_x), .factors_o(unused_factors_x), .product_i(36'd0),
        .x_o(x_o), .d_o(unused_dx), .u_i(v_o), .s_i(phi_i));  // dx = V dq
  end else begin : g_polynomial
    assign x_o = '0;
  end
  // verilog_format: on

endmodule
`default_nettype wire
