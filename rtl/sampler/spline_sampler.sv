// SPDX-License-Identifier: Apache-2.0
// Displacements along a spline in units of 2^k, by the parameter's series and the cubic:
//
//     q = ((q_P tau + ..) tau + q_1) tau
//     d = ((a' q + B') q + V) q                                         for each axis
//
// Twin: hls/curves/spline.hpp, polynomial mode.
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

    // Words of spline_steps, into a bank
    input wire logic [          bank_pkg::Bits-1:0] write_i,
    input wire logic [bank_pkg::Lanes*CoefBits-1:0] words_i,

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

  logic       unused_lanes;
  logic [1:0] bank;
  logic [3:0] series_pass;
  assign unused_lanes = &{write_i, words_i};
  assign bank         = write_i[bank_pkg::Bank+:2];
  assign series_pass  = 4'(Order) - write_i[bank_pkg::OwnPlace+:4];

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
      .write_i(write_i[bank_pkg::Lane+bank_pkg::Own]),
      .write_lanes_i({1{1'b1}}),
      .write_bank_i(bank),
      .write_pass_i(series_pass),
      .write_coef_i(words_i[bank_pkg::Own*CoefBits+:CoefBits]),
      .phase_i,
      .valid_i,
      .x_i(tau_i),
      .tag_i,
      .valid_o(series_valid),
      .d_o(series),
      .tag_o(series_tag)
  );

  logic [2:0] lanes;
  logic [3:0] cubic_pass;
  logic [2:0] cubic_phase;
  assign lanes       = write_i[bank_pkg::Lane+bank_pkg::X+:3];
  assign cubic_pass  = 4'd3 - write_i[bank_pkg::Place+:4];
  assign cubic_phase = phase_i - 3'(SeriesClocks % 8);
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
      .write_i(lanes != 3'd0),
      .write_lanes_i(lanes),
      .write_bank_i(bank),
      .write_pass_i(cubic_pass),
      .write_coef_i(words_i[bank_pkg::X*CoefBits+:3*CoefBits]),
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
