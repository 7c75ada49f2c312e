// SPDX-License-Identifier: Apache-2.0
// Displacements along a spline in units of 2^k, by the parameter's series and the cubic:
//
//     q = ((q_P tau + ..) tau + q_1) tau
//     d = ((a' q + B') q + V) q                                         for each axis
//
// Twin: hls/spline_kernel.hpp, polynomial mode.
//
//   clock           0        Latency = horner_latency(Order) + horner_latency(3)
//   phase_i         0
//                   tau_i    d_o, tag_o
`default_nettype none
module spline_sampler #(
    parameter int Order          = 6,   // [2, 12]
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int SampleInterval = 1,   // 1, 2, 4, 8
    parameter int TagBits        = 5,   // the low two are the bank
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // From spline_steps, into a bank
    input wire logic [           1:0] bank_i,
    input wire logic [           2:0] a_write_i,
    input wire logic [  CoefBits-1:0] a_i,
    input wire logic [           2:0] v_write_i,
    input wire logic [3*CoefBits-1:0] v_i,
    input wire logic [           2:0] b_write_i,
    input wire logic [3*CoefBits-1:0] b_i,
    input wire logic [  CoefBits+4:0] q_i,

    // Samples
    input  wire logic [           2:0] phase_i,
    input  wire logic                  valid_i,
    input  wire logic [  CoefBits-1:0] tau_i,
    input  wire logic [   TagBits-1:0] tag_i,
    output logic                       valid_o,
    output logic      [3*CoefBits-1:0] d_o,
    output logic      [   TagBits-1:0] tag_o
);

  localparam int SeriesClocks = curvecore_pkg::horner_latency(Order, SampleInterval);

  // A term of the series into its place, a clock later.
  logic                write_q;
  logic [         3:0] pass_q;
  logic [         1:0] bank_q;
  logic [CoefBits-1:0] coef_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) write_q <= 1'b0;
    else write_q <= q_i[CoefBits+4];
  end
  always_ff @(posedge clk_i) begin
    pass_q <= 4'(Order) - q_i[CoefBits+3:CoefBits];
    bank_q <= bank_i;
    coef_q <= q_i[CoefBits-1:0];
  end

  logic                series_valid;
  logic [CoefBits-1:0] series;
  logic [ TagBits-1:0] series_tag;
  horner #(
      .Passes(Order),
      .Lanes(1),
      .Bits(CoefBits),
      .Shift(CoefBits - 1),
      .Interval(SampleInterval),
      .BankBits(2),
      .TagBits(TagBits),
      .Form(MultiplierForm)
  ) u_series (
      .clk_i,
      .rst_ni,
      .en_i(1'b1),
      .write_i(write_q),
      .write_lanes_i({1{1'b1}}),
      .write_bank_i(bank_q),
      .write_pass_i(pass_q),
      .write_coef_i(coef_q),
      .phase_i,
      .valid_i,
      .x_i(tau_i),
      .tag_i,
      .valid_o(series_valid),
      .d_o(series),
      .tag_o(series_tag)
  );

  // One kind of word at a time: a' before V, B' a clock after V or later.
  logic [           2:0] lanes_q;
  logic [           3:0] cubic_pass_q;
  logic [3*CoefBits-1:0] cubic_coef_q;
  logic [           2:0] cubic_phase;
  assign cubic_phase = phase_i - 3'(SeriesClocks % 8);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) lanes_q <= 3'd0;
    else lanes_q <= a_write_i | b_write_i | v_write_i;
  end
  always_ff @(posedge clk_i) begin
    cubic_pass_q <= 4'd0;
    cubic_coef_q <= {3{a_i}};
    if (b_write_i != 3'd0) begin
      cubic_pass_q <= 4'd1;
      cubic_coef_q <= b_i;
    end
    if (v_write_i != 3'd0) begin
      cubic_pass_q <= 4'd2;
      cubic_coef_q <= v_i;
    end
  end
  horner #(
      .Passes(3),
      .Lanes(3),
      .Bits(CoefBits),
      .Shift(CoefBits - 2),
      .LastShift(CoefBits - 1),
      .Interval(SampleInterval),
      .BankBits(2),
      .TagBits(TagBits),
      .Form(MultiplierForm)
  ) u_cubic (
      .clk_i,
      .rst_ni,
      .en_i(1'b1),
      .write_i(lanes_q != 3'd0),
      .write_lanes_i(lanes_q),
      .write_bank_i(bank_q),
      .write_pass_i(cubic_pass_q),
      .write_coef_i(cubic_coef_q),
      .phase_i(cubic_phase & 3'(SampleInterval - 1)),
      .valid_i(series_valid),
      .x_i(series),
      .tag_i(series_tag),
      .valid_o,
      .d_o,
      .tag_o
  );

endmodule
`default_nettype wire
