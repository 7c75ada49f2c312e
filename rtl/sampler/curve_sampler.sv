// SPDX-License-Identifier: Apache-2.0
// Displacements of x y z along a step of any curve, in units of 2^k.
//
//   Mode 0   both curves are series of tau by Horner's rule,
//                d = (..(c_P tau + c_(P-1)) tau + ..) tau + c_1) tau
//   Mode 1   polynomial_sampler for lines and arcs, spline_sampler for splines; with both the first
//            waits, and each sample takes the one of its bank's kind
//
// Twins: hls/curves/arc.hpp, hls/curves/spline.hpp.
//
//   clock           0                   curvecore_pkg::sampler_latency(Curves, Mode, Order, ..)
//   phase_i         0
//                   tau_i, tag_i        d_o, tag_o
`default_nettype none
module curve_sampler #(
    parameter int Curves         = 3,   // 1 lines and arcs, 2 splines, 3 both
    parameter int Order          = 6,   // [2, 12]
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int Mode           = 0,   // 0 series, 1 polynomial
    parameter int SampleInterval = 1,   // 1, 2, 4, 8
    parameter int TagBits        = 5,   // the low two are the bank
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Words of spherical_steps and spline_steps, into a bank
    input wire logic [                CoefBits+4:0] rate_i,
    input wire logic [          bank_pkg::Bits-1:0] arc_write_i,
    input wire logic [bank_pkg::Lanes*CoefBits-1:0] arc_words_i,
    input wire logic [          bank_pkg::Bits-1:0] spline_write_i,
    input wire logic [bank_pkg::Lanes*CoefBits-1:0] spline_words_i,

    // Samples
    input  wire logic [           2:0] phase_i,
    input  wire logic                  valid_i,
    input  wire logic [  CoefBits-1:0] tau_i,
    input  wire logic [   TagBits-1:0] tag_i,
    output logic                       valid_o,
    output logic      [3*CoefBits-1:0] d_o,
    output logic      [   TagBits-1:0] tag_o
);

  if (Mode == 0) begin : g_series
    logic                      unused;
    logic                      arc;
    logic [bank_pkg::Bits-1:0] write;
    logic [    3*CoefBits-1:0] words;
    logic [               2:0] lanes;
    logic [               3:0] pass;
    assign unused = &{rate_i, write, arc_words_i, spline_words_i};  // other lanes
    assign arc    = Curves == 1 || arc_write_i[bank_pkg::Lane+bank_pkg::X+:3] != 3'd0;
    assign write  = arc ? arc_write_i : spline_write_i;
    assign words  = arc ? arc_words_i[3*CoefBits-1:0] : spline_words_i[3*CoefBits-1:0];
    assign lanes  = write[bank_pkg::Lane+bank_pkg::X+:3];
    assign pass   = 4'(Order) - write[bank_pkg::Place+:4];
    horner #(
        .Passes(Order),
        .Lanes(3),
        .Bits(CoefBits),
        .Shift(CoefBits - 1),
        .Interval(SampleInterval),
        .BankBits(2),
        .TagBits(TagBits),
        .Form(MultiplierForm)
    ) u_xyz (
        .clk_i,
        .rst_ni,
        .en_i(1'b1),
        .write_i(lanes != 3'd0),
        .write_lanes_i(lanes),
        .write_bank_i(write[bank_pkg::Bank+:2]),
        .write_pass_i(pass),
        .write_coef_i(words),
        .phase_i,
        .valid_i,
        .x_i(tau_i),
        .tag_i,
        .valid_o,
        .d_o,
        .tag_o
    );
  end else begin : g_polynomial
    logic                  spline_valid;
    logic [3*CoefBits-1:0] spline_d;
    logic [   TagBits-1:0] spline_tag;
    if (Curves != 1) begin : g_splines
      spline_sampler #(
          .Order(Order),
          .CoefBits(CoefBits),
          .SampleInterval(SampleInterval),
          .TagBits(TagBits),
          .MultiplierForm(MultiplierForm)
      ) u_sampler (
          .clk_i,
          .rst_ni,
          .write_i(spline_write_i),
          .words_i(spline_words_i),
          .phase_i,
          .valid_i,
          .tau_i,
          .tag_i,
          .valid_o(spline_valid),
          .d_o(spline_d),
          .tag_o(spline_tag)
      );
    end else begin : g_no_splines
      logic unused_terms;
      assign unused_terms = &{spline_write_i, spline_words_i};
      assign spline_valid = 1'b0;
      assign spline_d     = '0;
      assign spline_tag   = '0;
    end

    logic                  arc_valid;
    logic [3*CoefBits-1:0] arc_d;
    logic [   TagBits-1:0] arc_tag;
    if (Curves != 2) begin : g_arcs
      localparam int Wait = (Curves == 1) ? 0 : curvecore_pkg::sampler_latency(
          2, Mode, Order, SampleInterval
      ) - curvecore_pkg::sampler_latency(
          1, Mode, Order, SampleInterval
      );
      logic [CoefBits+TagBits-1:0] late;
      logic [                 2:0] late_phase;
      delay_line #(
          .Bits  (CoefBits + TagBits),
          .Clocks(Wait)
      ) u_wait (
          .clk_i,
          .rst_ni,
          .en_i  (1'b1),
          .data_i({tau_i, tag_i}),
          .data_o(late)
      );
      assign late_phase = (phase_i - 3'(Wait % 8)) & 3'(SampleInterval - 1);
      polynomial_sampler #(
          .Order(Order),
          .CoefBits(CoefBits),
          .SampleInterval(SampleInterval),
          .TagBits(TagBits),
          .MultiplierForm(MultiplierForm)
      ) u_sampler (
          .clk_i,
          .rst_ni,
          .rate_i,
          .write_i(arc_write_i),
          .words_i(arc_words_i),
          .phase_i(late_phase),
          .valid_i(valid_i && Curves == 1),
          .tau_i(late[TagBits+:CoefBits]),
          .tag_i(late[TagBits-1:0]),
          .valid_o(arc_valid),
          .d_o(arc_d),
          .tag_o(arc_tag)
      );
    end else begin : g_no_arcs
      logic unused_steps;
      assign unused_steps = &{rate_i, arc_write_i, arc_words_i};
      assign arc_valid = 1'b0;
      assign arc_d = '0;
      assign arc_tag = '0;
    end

    if (Curves == 3) begin : g_both
      logic unused_arc;
      assign unused_arc = &{arc_valid, arc_tag};
      logic [3:0] spline_q;  // the banks' kinds
      always_ff @(posedge clk_i) begin
        if (!rst_ni) valid_o <= 1'b0;
        else valid_o <= spline_valid;
      end
      always_ff @(posedge clk_i) begin
        if (spline_write_i[bank_pkg::Lane+bank_pkg::Own]) begin
          spline_q[spline_write_i[bank_pkg::Bank+:2]] <= 1'b1;
        end
        if (arc_write_i[bank_pkg::Lane+bank_pkg::X]) begin
          spline_q[arc_write_i[bank_pkg::Bank+:2]] <= 1'b0;
        end
        d_o   <= spline_q[spline_tag[1:0]] ? spline_d : arc_d;
        tag_o <= spline_tag;
      end
    end else begin : g_one
      logic unused_kind;
      assign unused_kind = &{arc_valid, arc_tag, spline_valid, spline_tag};
      assign valid_o     = arc_valid || spline_valid;
      assign d_o         = (Curves == 1) ? arc_d : spline_d;
      assign tag_o       = (Curves == 1) ? arc_tag : spline_tag;
    end
  end

endmodule
`default_nettype wire
