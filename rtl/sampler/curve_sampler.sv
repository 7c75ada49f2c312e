// SPDX-License-Identifier: Apache-2.0
// Displacements of x y z along a step, in units of 2^k, whichever curve it lies on.
//
//   Mode 0   both curves are series of tau: one series_sampler for them
//   Mode 1   polynomial_sampler for lines and arcs, spline_sampler for splines; with both the first
//            waits, and each sample takes the one of its bank's kind
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
    parameter int TurnBits       = 0,   // [0, 14]; above 0: Curves 1, Mode 0, SampleInterval 1
    parameter int TagBits        = 5,   // the low two are the bank
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Steps into a bank
    input wire logic [1:0] bank_i,
    input wire logic       spline_i,    // the step is a spline's
    input wire logic       step_done_i,

    // From spherical_steps
    input wire logic                       rate_valid_i,
    input wire logic        [         3:0] rate_axis_i,
    input wire logic signed [CoefBits-1:0] advance_i,
    input wire logic                       zeroth_i,
    input wire logic                       collect_i,
    input wire logic        [         3:0] order_i,
    input wire logic signed [CoefBits-1:0] x_i,
    input wire logic signed [CoefBits-1:0] y_i,
    input wire logic signed [CoefBits-1:0] z_i,
    input wire logic signed [CoefBits-1:0] f_i,
    input wire logic signed [CoefBits-1:0] g_i,
    input wire logic signed [CoefBits-1:0] h_i,
    input wire logic signed [CoefBits-1:0] angle_i,

    // From spline_steps
    input wire logic [           2:0] a_write_i,
    input wire logic [  CoefBits-1:0] a_i,
    input wire logic [           2:0] v_write_i,
    input wire logic [3*CoefBits-1:0] v_i,
    input wire logic [           2:0] b_write_i,
    input wire logic [3*CoefBits-1:0] b_i,
    input wire logic [  CoefBits+4:0] q_term_i,
    input wire logic [  CoefBits+4:0] x_term_i,
    input wire logic [  CoefBits+4:0] y_term_i,
    input wire logic [  CoefBits+4:0] z_term_i,

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
    logic unused;
    assign unused = &{
      zeroth_i, f_i, g_i, h_i, angle_i, step_done_i, a_write_i, a_i, v_write_i, v_i, b_write_i,
      b_i, q_term_i, y_term_i[CoefBits+4:CoefBits], z_term_i[CoefBits+4:CoefBits]
    };
    logic                collect;
    logic [         3:0] order;
    logic [CoefBits-1:0] x;
    logic [CoefBits-1:0] y;
    logic [CoefBits-1:0] z;
    assign collect = spline_i ? x_term_i[CoefBits+4] : collect_i;
    assign order   = spline_i ? x_term_i[CoefBits+3:CoefBits] : order_i;
    assign x       = spline_i ? x_term_i[CoefBits-1:0] : x_i;
    assign y       = spline_i ? y_term_i[CoefBits-1:0] : y_i;
    assign z       = spline_i ? z_term_i[CoefBits-1:0] : z_i;
    series_sampler #(
        .Order(Order),
        .CoefBits(CoefBits),
        .SampleInterval(SampleInterval),
        .TurnBits(TurnBits),
        .TagBits(TagBits),
        .MultiplierForm(MultiplierForm)
    ) u_sampler (
        .clk_i,
        .rst_ni,
        .bank_i,
        .rate_valid_i,
        .rate_axis_i,
        .advance_i,
        .linear_i(!spline_i),
        .collect_i(collect),
        .order_i(order),
        .x_i(x),
        .y_i(y),
        .z_i(z),
        .phase_i,
        .valid_i,
        .tau_i,
        .tag_i,
        .valid_o,
        .d_o,
        .tag_o
    );
  end else begin : g_polynomial
    logic unused;
    assign unused = &{x_term_i, y_term_i, z_term_i};

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
          .bank_i,
          .a_write_i,
          .a_i,
          .v_write_i,
          .v_i,
          .b_write_i,
          .b_i,
          .q_i(q_term_i),
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
      assign unused_terms = &{a_write_i, a_i, v_write_i, v_i, b_write_i, b_i, q_term_i};
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
          .bank_i,
          .rate_valid_i,
          .rate_axis_i,
          .advance_i,
          .zeroth_i,
          .collect_i,
          .order_i,
          .x_i,
          .y_i,
          .z_i,
          .f_i,
          .g_i,
          .h_i,
          .angle_i,
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
      assign unused_steps = &{
        rate_valid_i, rate_axis_i, advance_i, zeroth_i, collect_i, order_i, x_i, y_i, z_i, f_i,
        g_i, h_i, angle_i
      };
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
        if (step_done_i) spline_q[bank_i] <= spline_i;
        d_o   <= spline_q[spline_tag[1:0]] ? spline_d : arc_d;
        tag_o <= spline_tag;
      end
    end else begin : g_one
      logic unused_kind;
      assign unused_kind = &{spline_i, step_done_i, arc_valid, arc_tag, spline_valid, spline_tag};
      assign valid_o     = arc_valid || spline_valid;
      assign d_o         = (Curves == 1) ? arc_d : spline_d;
      assign tag_o       = (Curves == 1) ? arc_tag : spline_tag;
    end
  end

endmodule
`default_nettype wire
