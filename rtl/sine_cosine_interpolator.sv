// SPDX-License-Identifier: Apache-2.0
// Sine and cosine of an angle that grows by theta per step: [Chikurov] Fig. 2 as a core of its own.
// Twin: hls::SineCosineNetwork.
//
// Each step gives the state and its series, one order per pulse of coef_valid_o,
//
//     order 0      sine_o, cosine_o are sin and cos at the step's start
//     order i      their Taylor coefficients in tau (0 .. 1 over the step), divided by theta
//
//   cycle                                      Digits = ceil(CoefBits / 2)
//   0                                          step_i and ready_o; with load_i: from theta_i,
//                                              sine_i, cosine_i, else one step on
//   Digits + 6                                 coef_valid_o, order_o = 0
//   Digits + 8 + (i - 1) (Digits + 3)          coef_valid_o, order_o = i
//   Order (Digits + 3) + 5                     ready_o again
//
// Formats: theta CoefBits - 1 fraction bits, below 1; all else CoefBits - 2 fraction bits.
`default_nettype none
module sine_cosine_interpolator #(
    parameter int Order    = 6,  // [2, 12]
    parameter int CoefBits = 36  // [18, 36]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic                       step_i,
    output logic                            ready_o,
    input  wire logic                       load_i,
    input  wire logic        [CoefBits-1:0] theta_i,
    input  wire logic signed [CoefBits-1:0] sine_i,
    input  wire logic signed [CoefBits-1:0] cosine_i,

    output logic                       coef_valid_o,
    output logic        [         3:0] order_o,
    output logic signed [CoefBits-1:0] sine_o,
    output logic signed [CoefBits-1:0] cosine_o
);

  initial if (Order < 2 || Order > 12) $fatal(1, "Order must be in [2, 12]");
  initial if (CoefBits < 18 || CoefBits > 36) $fatal(1, "CoefBits must be in [18, 36]");

  logic rst_n;
  reset_stretcher u_reset (
      .clk_i,
      .rst_ni,
      .rst_no(rst_n)
  );
  logic ready;
  assign ready_o = ready && rst_n;

  logic                load;
  logic [CoefBits-1:0] theta_q;
  assign load = step_i && ready_o && load_i;
  always_ff @(posedge clk_i) begin
    if (load) theta_q <= theta_i;
  end

  logic [riemann_pkg::ExpansionBits-1:0] control;
  logic                                  zeroth_there;
  logic                                  collect_there;
  logic [                           3:0] order;
  logic                                  unused_done;
  taylor_sequencer #(
      .Order(Order),
      .Bits (CoefBits)
  ) u_sequencer (
      .clk_i,
      .rst_ni(rst_n),
      .start_i(step_i),
      .fresh_i(load_i),
      .theta_i(theta_q),
      .ready_o(ready),
      .control_o(control),
      .zeroth_there_o(zeroth_there),
      .collect_there_o(collect_there),
      .order_there_o(order),
      .done_o(unused_done)
  );

  sine_cosine_network #(
      .CoefBits(CoefBits)
  ) u_network (
      .clk_i,
      .control_i({load, control}),
      .sine_i,
      .cosine_i,
      .y_o(sine_o),
      .z_o(cosine_o)
  );

  assign coef_valid_o = zeroth_there || collect_there;
  assign order_o      = order;

endmodule
`default_nettype wire
