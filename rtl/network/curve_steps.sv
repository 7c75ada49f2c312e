// SPDX-License-Identifier: Apache-2.0
// Integration steps of either kind by the networks, one instance an equation: [Chikurov] Figs. 2,
// 3, 8 and 10.  rtl/serial/folded_steps.sv has the same ports.
//
//   segment words -> starter -> spherical_steps, spline_steps -> words for the banks of a step
//
//   clocks (hls/clocks.hpp)    value
//   of an integration step     rtl/network/spherical_steps.sv; spline_steps.sv and 2 more
//   to load a segment          19 + 3 AuxAxes, while the one before is drawn
//
// Segments of a kind not in Curves are drawn as the other kind.
`default_nettype none
module curve_steps #(
    parameter int Curves         = 3,   // 1 lines and arcs, 2 splines, 3 both
    parameter int Order          = 6,   // [2, 12]
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int FineBits       = 42,  // [18, 44]
    parameter int GuardBits      = 10,  // [2, 12]
    parameter int AuxAxes        = 0,   // [0, 6]
    parameter int Mode           = 0,   // 0 series, 1 polynomial
    parameter int Anchor         = 1,   // 0, 1; for splines
    parameter int ParameterGuard = 0,   // [0, 8], for splines
    parameter int Form           = 0    // 0 portable, 1 ECP5
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Segments, 17 + 3 AuxAxes words each
    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic [47:0] segment_data_i,
    output logic      [15:0] empty_segments_o,

    // Steps into banks: with done_o the words of step bank_i are there, and the next five outputs
    // are the step's
    input  wire logic                               room_i,
    input  wire logic [                        1:0] bank_i,
    output logic                                    done_o,
    output logic                                    last_o,
    output logic      [                        4:0] k_o,
    output logic      [curvecore_pkg::StepBits-1:0] offset_o,
    output logic      [  curvecore_pkg::StepBits:0] stride_o,

    // Outputs to the banks of the rates {there, axis, rate}, of the points {there, axis, end,
    // origin}, of the samplers of arcs and of splines (rtl/sampler/bank_pkg.sv)
    output logic [                CoefBits+4:0] rate_o,
    output logic [              2*FineBits+4:0] point_o,
    output logic [          bank_pkg::Bits-1:0] arc_write_o,
    output logic [bank_pkg::Lanes*CoefBits-1:0] arc_words_o,
    output logic [          bank_pkg::Bits-1:0] spline_write_o,
    output logic [bank_pkg::Lanes*CoefBits-1:0] spline_words_o
);

  // The present segment's words.
  logic        [         1:0] ready;
  logic        [         1:0] done;
  logic        [         1:0] start;
  logic                       fresh;
  logic                       spline;
  logic        [CoefBits-1:0] theta;
  logic        [         5:0] lambda;
  logic        [         3:0] arc_segment_axis;
  logic        [         3:0] spline_segment_axis;
  logic        [         3:0] arc_segment_point;
  logic        [         3:0] spline_segment_point;
  logic signed [CoefBits-1:0] tangent;
  logic signed [CoefBits-1:0] normal;
  logic signed [CoefBits-1:0] advance;
  logic signed [CoefBits-1:0] cubic_a, cubic_b, cubic_c;
  logic signed [FineBits-1:0] start_point;
  logic signed [FineBits-1:0] end_point;

  logic [CoefBits+4:0] arc_rate, spline_rate;
  logic [2*FineBits+4:0] arc_point, spline_point;
  assign rate_o  = (Curves == 1 || arc_rate[CoefBits+4]) ? arc_rate : spline_rate;
  assign point_o = (Curves == 1 || arc_point[2*FineBits+4]) ? arc_point : spline_point;
  assign done_o  = done != 2'b00;

  step_starter #(
      .Curves  (Curves),
      .CoefBits(CoefBits),
      .FineBits(FineBits),
      .AuxAxes (AuxAxes)
  ) u_starter (
      .clk_i,
      .rst_ni,
      .segment_valid_i,
      .segment_ready_o,
      .segment_data_i,
      .empty_segments_o,
      .room_i,
      .ready_i(ready == 2'b11 && !done[0]),  // a spline is done before it is ready
      .done_i(done_o),
      .start_o(start),
      .fresh_o(fresh),
      .last_o,
      .offset_o,
      .stride_o,
      .spline_o(spline),
      .theta_o(theta),
      .k_o,
      .lambda_o(lambda),
      .rate_axis_i(arc_segment_axis),
      .tangent_o(tangent),
      .normal_o(normal),
      .advance_o(advance),
      .cubic_axis_i(spline_segment_axis),
      .a_o(cubic_a),
      .b_o(cubic_b),
      .c_o(cubic_c),
      .point_axis_i(spline ? spline_segment_point : arc_segment_point),
      .point_o(start_point),
      .end_o(end_point)
  );

  if (Curves != 2) begin : g_arcs
    spherical_steps #(
        .Order(Order),
        .CoefBits(CoefBits),
        .FineBits(FineBits),
        .GuardBits(GuardBits),
        .AuxAxes(AuxAxes),
        .Mode(Mode)
    ) u_steps (
        .clk_i,
        .rst_ni,
        .start_i(start[0]),
        .fresh_i(fresh),
        .ready_o(ready[0]),
        .done_o(done[0]),
        .theta_i(theta),
        .k_i(k_o),
        .segment_axis_o(arc_segment_axis),
        .tangent_i(tangent),
        .normal_i(normal),
        .advance_i(advance),
        .segment_point_o(arc_segment_point),
        .start_point_i(start_point),
        .end_point_i(end_point),
        .bank_i,
        .rate_o(arc_rate),
        .point_o(arc_point),
        .write_o(arc_write_o),
        .words_o(arc_words_o)
    );
  end else begin : g_no_arcs
    logic unused;
    assign unused = &{start[0], tangent, normal, advance};
    assign ready[0] = 1'b1;
    assign done[0] = 1'b0;
    assign arc_segment_axis = '0;
    assign arc_segment_point = '0;
    assign {arc_rate, arc_point, arc_write_o, arc_words_o} = '0;
  end

  if (Curves != 1) begin : g_splines
    spline_steps #(
        .Order(Order),
        .CoefBits(CoefBits),
        .FineBits(FineBits),
        .GuardBits(GuardBits),
        .AuxAxes(AuxAxes),
        .Mode(Mode),
        .ParameterGuard(ParameterGuard),
        .Anchor(Anchor),
        .Form(Form)
    ) u_steps (
        .clk_i,
        .rst_ni,
        .start_i(start[1]),
        .fresh_i(fresh),
        .ready_o(ready[1]),
        .done_o(done[1]),
        .theta_i(theta),
        .k_i(k_o),
        .lambda_i(lambda[4:0]),
        .segment_axis_o(spline_segment_axis),
        .a_i(cubic_a),
        .b_i(cubic_b),
        .c_i(cubic_c),
        .segment_point_o(spline_segment_point),
        .start_point_i(start_point),
        .end_point_i(end_point),
        .bank_i,
        .rate_o(spline_rate),
        .point_o(spline_point),
        .write_o(spline_write_o),
        .words_o(spline_words_o)
    );
  end else begin : g_no_splines
    logic unused;
    assign unused = &{start[1], lambda, cubic_a, cubic_b, cubic_c};
    assign ready[1] = 1'b1;
    assign done[1] = 1'b0;
    assign spline_segment_axis = '0;
    assign spline_segment_point = '0;
    assign {spline_rate, spline_point, spline_write_o, spline_words_o} = '0;
  end

endmodule
`default_nettype wire
