// SPDX-License-Identifier: Apache-2.0
// Displacements along a spline in units of 2^k.  Twin: hls/spline_kernel.hpp, `sample_xyz`.
//
//     Mode 0   d = ((x_P tau + ..) tau + x_1) tau                         for each axis
//     Mode 1   q = ((q_P tau + ..) tau + q_1) tau
//              d = ((a' q + B') q + V) q                                  for each axis
//
// and d = advance tau for an auxiliary axis.
//
//   clock           0        Latency
//   phase_i         0
//                   tau_i    d_o, tag_o     Latency: horner_latency(Order), with Mode 1 that and
//                                           horner_latency(3)
`default_nettype none
module spline_sampler #(
    parameter int Order          = 6,   // [2, 12]
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int AuxAxes        = 0,   // [0, 6]
    parameter int Mode           = 1,   // 0 series, 1 polynomial
    parameter int SampleInterval = 1,   // 1, 2, 4, 8
    parameter int TagBits        = 5,   // the low two are the bank
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // From spline_steps, into a bank
    input wire logic        [           1:0] bank_i,
    input wire logic                         rate_valid_i,
    input wire logic        [           3:0] rate_axis_i,
    input wire logic signed [  CoefBits-1:0] advance_i,
    input wire logic        [           2:0] a_write_i,
    input wire logic        [  CoefBits-1:0] a_i,
    input wire logic        [           2:0] v_write_i,
    input wire logic        [3*CoefBits-1:0] v_i,
    input wire logic        [           2:0] b_write_i,
    input wire logic        [3*CoefBits-1:0] b_i,
    input wire logic        [  CoefBits+4:0] q_i,
    input wire logic        [  CoefBits+4:0] x_i,
    input wire logic        [  CoefBits+4:0] y_i,
    input wire logic        [  CoefBits+4:0] z_i,

    // Samples
    input  wire logic [                     2:0] phase_i,
    input  wire logic                            valid_i,
    input  wire logic [            CoefBits-1:0] tau_i,
    input  wire logic [             TagBits-1:0] tag_i,
    output logic                                 valid_o,
    output logic      [(3+AuxAxes)*CoefBits-1:0] d_o,
    output logic      [             TagBits-1:0] tag_o
);

  localparam int SeriesClocks = curvecore_pkg::horner_latency(Order, SampleInterval);
  localparam int CubicClocks = curvecore_pkg::horner_latency(3, SampleInterval);
  localparam int Latency = (Mode == 0) ? SeriesClocks : SeriesClocks + CubicClocks;

  // A term of the series into its place, a clock later.
  localparam int Lanes = (Mode == 0) ? 3 : 1;
  logic [      CoefBits+4:0] term;
  logic [Lanes*CoefBits-1:0] coefs;
  logic                      write_q;
  logic [               3:0] pass_q;
  logic [               1:0] bank_q;
  logic [Lanes*CoefBits-1:0] coef_q;
  assign term = (Mode == 0) ? x_i : q_i;
  if (Mode == 0) begin : g_axes
    logic unused;
    assign unused = &{a_write_i, a_i, v_write_i, v_i, b_write_i, b_i, q_i};
    assign coefs  = {z_i[CoefBits-1:0], y_i[CoefBits-1:0], x_i[CoefBits-1:0]};
  end else begin : g_parameter
    logic unused;
    assign unused = &{x_i, y_i, z_i};
    assign coefs  = q_i[CoefBits-1:0];
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) write_q <= 1'b0;
    else write_q <= term[CoefBits+4];
  end
  always_ff @(posedge clk_i) begin
    pass_q <= 4'(Order) - term[CoefBits+3:CoefBits];
    bank_q <= bank_i;
    coef_q <= coefs;
  end

  logic                      series_valid;
  logic [Lanes*CoefBits-1:0] series;
  logic [       TagBits-1:0] series_tag;
  horner #(
      .Passes(Order),
      .Lanes(Lanes),
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
      .write_lanes_i({Lanes{1'b1}}),
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

  if (Mode == 0) begin : g_series
    assign valid_o             = series_valid;
    assign d_o[3*CoefBits-1:0] = series;
    assign tag_o               = series_tag;
  end else begin : g_polynomial
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
        .d_o(d_o[3*CoefBits-1:0]),
        .tag_o
    );
  end

  if (AuxAxes > 0) begin : g_auxiliary
    auxiliary_sampler #(
        .CoefBits(CoefBits),
        .AuxAxes(AuxAxes),
        .SampleInterval(SampleInterval),
        .Latency(Latency),
        .MultiplierForm(MultiplierForm)
    ) u_auxiliary (
        .clk_i,
        .rst_ni,
        .bank_i,
        .rate_valid_i,
        .rate_axis_i,
        .advance_i,
        .phase_i,
        .tau_i,
        .tau_bank_i(tag_i[1:0]),
        .d_o(d_o[(3+AuxAxes)*CoefBits-1:3*CoefBits])
    );
  end else begin : g_no_auxiliary
    logic unused;
    assign unused = &{rate_valid_i, rate_axis_i, advance_i};
  end

endmodule
`default_nettype wire
