// SPDX-License-Identifier: Apache-2.0
// Displacements by Horner's rule on the network's own series, in units of 2^k:
//
//     d = (..(c_P tau + c_(P-1)) tau + ..) tau + c_1) tau,   c_1 = x[1] + advance,  c_i = x[i]
//
// Splines have no advance (linear_i = 0).  TurnBits > 0: arcs only, whose steps turn by at most
// 2^-TurnBits rad; every order has words of its own width.  Twins: hls/spherical_kernel.hpp and
// hls/spline_kernel.hpp, series mode.
//
//   clock           0           Latency, that of `horner` with Passes = Order
//   phase_i         0
//   valid_i         tau_i, tag  valid_o, d_o, tag_o
`default_nettype none
module series_sampler #(
    parameter int Order          = 6,   // [2, 12]
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int SampleInterval = 1,   // 1, 2, 4, 8
    parameter int TurnBits       = 0,   // [0, 14]; above 0: SampleInterval 1
    parameter int TagBits        = 5,   // the low two are the bank
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // From the network, into a bank
    input wire logic        [         1:0] bank_i,
    input wire logic                       rate_valid_i,
    input wire logic        [         3:0] rate_axis_i,
    input wire logic signed [CoefBits-1:0] advance_i,
    input wire logic                       linear_i,
    input wire logic                       collect_i,
    input wire logic        [         3:0] order_i,
    input wire logic signed [CoefBits-1:0] x_i,
    input wire logic signed [CoefBits-1:0] y_i,
    input wire logic signed [CoefBits-1:0] z_i,

    // Samples
    input  wire logic [           2:0] phase_i,
    input  wire logic                  valid_i,
    input  wire logic [  CoefBits-1:0] tau_i,
    input  wire logic [   TagBits-1:0] tag_i,
    output logic                       valid_o,
    output logic      [3*CoefBits-1:0] d_o,
    output logic      [   TagBits-1:0] tag_o
);

  // The segment's linear rates join the first order.
  logic signed [CoefBits-1:0] advance_q[3];
  for (genvar a = 0; a < 3; a++) begin : g_advance
    always_ff @(posedge clk_i) begin
      if (rate_valid_i && rate_axis_i == 4'(a)) advance_q[a] <= advance_i;
    end
  end

  // Two clocks to the banks: register, add.
  logic                       collect_q;
  logic                       write_q;
  logic        [         1:0] bank_q;
  logic        [         1:0] write_bank_q;
  logic        [         3:0] order_q;
  logic        [         3:0] write_pass_q;
  logic signed [CoefBits-1:0] x_q;
  logic signed [CoefBits-1:0] y_q;
  logic signed [CoefBits-1:0] z_q;
  logic signed [CoefBits-1:0] linear_x_q;
  logic signed [CoefBits-1:0] linear_y_q;
  logic signed [CoefBits-1:0] linear_z_q;
  logic signed [CoefBits-1:0] write_x_q;
  logic signed [CoefBits-1:0] write_y_q;
  logic signed [CoefBits-1:0] write_z_q;
  logic                       first;
  assign first = linear_i && order_i == 4'd1;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      collect_q <= 1'b0;
      write_q   <= 1'b0;
    end else begin
      collect_q <= collect_i;
      write_q   <= collect_q;
    end
  end
  always_ff @(posedge clk_i) begin
    if (collect_i) begin
      bank_q     <= bank_i;
      order_q    <= order_i;
      x_q        <= x_i;
      y_q        <= y_i;
      z_q        <= z_i;
      linear_x_q <= first ? advance_q[0] : '0;
      linear_y_q <= first ? advance_q[1] : '0;
      linear_z_q <= first ? advance_q[2] : '0;
    end
    if (collect_q) begin
      write_bank_q <= bank_q;
      write_pass_q <= 4'(Order) - order_q;
      write_x_q    <= x_q + linear_x_q;
      write_y_q    <= y_q + linear_y_q;
      write_z_q    <= z_q + linear_z_q;
    end
  end

  horner #(
      .Passes(Order),
      .Lanes(3),
      .Bits(CoefBits),
      .Shift(CoefBits - 1),
      .Interval(SampleInterval),
      .TurnBits(TurnBits),
      .BankBits(2),
      .TagBits(TagBits),
      .Form(MultiplierForm)
  ) u_xyz (
      .clk_i,
      .rst_ni,
      .en_i(1'b1),
      .write_i(write_q),
      .write_lanes_i({3{1'b1}}),
      .write_bank_i(write_bank_q),
      .write_pass_i(write_pass_q),
      .write_coef_i({write_z_q, write_y_q, write_x_q}),
      .phase_i,
      .valid_i,
      .x_i(tau_i),
      .tag_i,
      .valid_o,
      .d_o,
      .tag_o
  );

endmodule
`default_nettype wire
