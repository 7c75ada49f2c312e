// SPDX-License-Identifier: Apache-2.0
// Starts of integration steps from segments, and the segment's words that a step needs.
// Twin: hls/interpolator_kernel.hpp, `open` and `measure`.
//
//   cycle     0                 1
//   start_o   1, fresh_o        theta_o, k_o, lambda_o, spline_o and the reads are the step's
//
// A step starts when there is room for it and none is under way: start_o[0] that of a line or arc,
// start_o[1] that of a spline.  Both are registers, for they reach far.  Until the next start rates
// follow their axis in the same clock, points a clock later.  Segments of a kind not in Curves
// count as the other kind.  With done_i, last_o, offset_o and stride_o are the step's.
`default_nettype none
module step_starter #(
    parameter int Curves   = 3,   // 1 lines and arcs, 2 splines, 3 both
    parameter int CoefBits = 36,  // [18, 36]
    parameter int FineBits = 42,  // [18, 44]
    parameter int AuxAxes  = 0    // [0, 6]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic [47:0] segment_data_i,
    output logic      [15:0] empty_segments_o,

    // Steps
    input  wire logic                               room_i,
    input  wire logic                               ready_i,   // no step is under way, nor done now
    input  wire logic                               done_i,
    output logic      [                        1:0] start_o,
    output logic                                    fresh_o,   // the first of its segment
    output logic                                    last_o,
    output logic      [curvecore_pkg::StepBits-1:0] offset_o,
    output logic      [  curvecore_pkg::StepBits:0] stride_o,

    // The present segment
    output logic                       spline_o,
    output logic        [CoefBits-1:0] theta_o,
    output logic        [         4:0] k_o,
    output logic        [         5:0] lambda_o,
    input  wire logic   [         3:0] rate_axis_i,
    output logic signed [CoefBits-1:0] tangent_o,
    output logic signed [CoefBits-1:0] normal_o,
    output logic signed [CoefBits-1:0] advance_o,
    input  wire logic   [         3:0] cubic_axis_i,
    output logic signed [CoefBits-1:0] a_o,
    output logic signed [CoefBits-1:0] b_o,
    output logic signed [CoefBits-1:0] c_o,
    input  wire logic   [         3:0] point_axis_i,
    output logic signed [FineBits-1:0] point_o,
    output logic signed [FineBits-1:0] end_o
);

  logic                there;
  logic [        47:0] length;
  logic [CoefBits-1:0] theta;
  logic [         4:0] k;
  logic [         5:0] lambda;
  logic                kind;

  logic                take_q;
  logic                go;
  logic                spline_q;
  logic                next_spline;
  assign go = ready_i && start_o == 2'b00 && room_i && (there || !fresh_o);
  assign next_spline = (Curves == 3) ? (fresh_o ? kind : spline_q) : Curves == 2;
  assign spline_o    = (Curves == 3) ? spline_q : Curves == 2;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fresh_o <= 1'b1;
      start_o <= 2'b00;
      take_q  <= 1'b0;
    end else begin
      if (done_i) fresh_o <= last_o;
      start_o <= {go && next_spline, go && !next_spline};
      take_q  <= go && fresh_o;
    end
  end
  always_ff @(posedge clk_i) begin
    if (take_q) begin
      theta_o  <= theta;
      k_o      <= k;
      lambda_o <= lambda;
      spline_q <= kind;
    end
  end

  logic signed [FineBits-1:0] point;
  logic signed [FineBits-1:0] end_point;
  always_ff @(posedge clk_i) begin
    point_o <= point;
    end_o   <= end_point;
  end

  segment_loader #(
      .CoefBits(CoefBits),
      .FineBits(FineBits),
      .AuxAxes (AuxAxes)
  ) u_loader (
      .clk_i,
      .rst_ni,
      .valid_i(segment_valid_i),
      .ready_o(segment_ready_o),
      .data_i(segment_data_i),
      .segment_valid_o(there),
      .take_i(take_q),
      .length_o(length),
      .theta_o(theta),
      .k_o(k),
      .lambda_o(lambda),
      .kind_o(kind),
      .empty_segments_o,
      .rate_axis_i,
      .tangent_o,
      .normal_o,
      .advance_o,
      .cubic_axis_i,
      .a_o,
      .b_o,
      .c_o,
      .point_axis_i,
      .start_o(point),
      .end_o(end_point)
  );

  step_meter u_meter (
      .clk_i,
      .rst_ni,
      .load_i(take_q),
      .length_i(length),
      .k_i(k),
      .next_i(start_o != 2'b00),
      .last_o,
      .offset_o,
      .stride_o
  );

endmodule
`default_nettype wire
