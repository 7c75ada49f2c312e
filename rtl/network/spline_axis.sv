// SPDX-License-Identifier: Apache-2.0
// One axis of the spline interpolator, [Chikurov] Fig. 10: a scaler and two Stieltjes integrators,
// with Mode 0 three.
//
//     dW = 6a' dq    dV = W dq    dP = V dV    [dx = V dq]         dq = phi dtau
//
// See spline_network.
`default_nettype none
module spline_axis #(
    parameter int CoefBits = 36,  // [18, 36]
    parameter int Mode     = 1,   // 0 series, 1 polynomial
    parameter int Form     = 0    // 0 portable, 1 ECP5
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Initial conditions
    input wire logic                       load_six_a_i,
    input wire logic                       load_v_i,
    input wire logic                       load_w_i,
    input wire logic                       again_i,
    input wire logic signed [CoefBits-1:0] initial_i,

    // From spline_sequencer
    input wire logic       start_v_i,
    input wire logic       start_x_i,
    input wire logic       start_p_i,
    input wire logic [3:0] order_i,

    // Terms {there, order, coefficient}; q as digits (word_digits)
    input  wire logic [        11:0] digits_i,
    input  wire logic [CoefBits+4:0] phi_i,
    output logic      [CoefBits+4:0] w_o,
    output logic      [CoefBits+4:0] v_o,
    output logic      [CoefBits+4:0] dp_o,
    output logic      [CoefBits+4:0] x_o
);

  localparam int TermBits = CoefBits + 5;

  logic [TermBits-1:0] w;
  logic [TermBits-1:0] v;
  logic [TermBits-1:0] dv;
  logic [TermBits-1:0] unused_p;
  logic signed [CoefBits-1:0] unused_w_state;
  logic signed [CoefBits-1:0] unused_v_state;
  logic signed [CoefBits-1:0] unused_p_state;
  logic [37:0] unused_factors_v;
  logic [37:0] unused_factors_p;

  scaler #(
      .Bits(CoefBits)
  ) u_w (
      .clk_i,
      .rst_ni,
      .gain_i(load_six_a_i),
      .load_i(load_w_i),
      .again_i,
      .initial_i,
      .state_o(unused_w_state),
      .digits_i,
      .w_o(w)
  );

  stieltjes_integrator #(
      .Bits (CoefBits),
      .Shift(CoefBits - 2),
      .Drop (2),
      .First(0),
      .Form (Form)
  ) u_v (
      .clk_i,
      .rst_ni,
      .load_i(load_v_i),
      .again_i,
      .initial_i,
      .start_i(start_v_i),
      .order_i,
      .state_o(unused_v_state),
      .u_i(w),
      .s_i(phi_i),
      .d_o(dv),
      .x_o(v),
      .factors_o(unused_factors_v),
      .product_i(36'd0)
  );

  stieltjes_integrator #(
      .Bits(CoefBits),
      .Shift(CoefBits - 1),
      .Quotient(0),
      .Form(Form)
  ) u_p (
      .clk_i,
      .rst_ni,
      .load_i(1'b0),
      .again_i(1'b0),
      .initial_i,
      .start_i(start_p_i),
      .order_i,
      .state_o(unused_p_state),
      .u_i(v),
      .s_i(dv),
      .d_o(dp_o),
      .x_o(unused_p),
      .factors_o(unused_factors_p),
      .product_i(36'd0)
  );

  if (Mode == 0) begin : g_series
    logic [TermBits-1:0] unused_dx;
    logic signed [CoefBits-1:0] unused_x_state;
    logic [37:0] unused_factors_x;
    stieltjes_integrator #(
        .Bits (CoefBits),
        .Shift(CoefBits - 1),
        .First(0),
        .Form (Form)
    ) u_x (
        .clk_i,
        .rst_ni,
        .load_i(1'b0),
        .again_i(1'b0),
        .initial_i,
        .start_i(start_x_i),
        .order_i,
        .state_o(unused_x_state),
        .u_i(v),
        .s_i(phi_i),
        .d_o(unused_dx),
        .x_o,
        .factors_o(unused_factors_x),
        .product_i(36'd0)
    );
  end else begin : g_polynomial
    logic unused_start;
    assign unused_start = start_x_i;
    assign x_o          = '0;
  end

  assign w_o = w;
  assign v_o = v;

endmodule
`default_nettype wire
