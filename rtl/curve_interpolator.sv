// SPDX-License-Identifier: Apache-2.0
// Positions along lines, arcs, helices and splines, one per request: [Chikurov] Fig. 8 and Fig. 10
// side by side.  Twin: hls/interpolator_kernel.hpp with hls/curve_kernel.hpp, bit for bit.
//
//   segment words -> steps (ahead) -> banks -> sampler -> lander -> samples
//   requests ------> step tracker -> offset ----^
//
// A request moves `ds` quanta (2^-16 length unit) along the path and yields the sample there, in
// order.  It waits until its step is ready.  Nothing is lost at a change of kind.
//
//   clocks (hls/clocks.hpp)           value
//   between samples                   SampleInterval
//   request to sample                 12 + 3 SampleInterval + curvecore_pkg::sampler_latency, Axes
//                                     more where SampleInterval is as large, and up to
//                                     SampleInterval - 1 more
//   of an integration step            rtl/network/curve_steps.sv, with Networks 0
//                                     rtl/serial/folded_steps.sv
//
// Samples come at full rate as long as every step holds the samples of the larger of the last two.
// While the taker is not ready, requests stop when the samples under way have filled their queue.
// ParameterGuard: fraction bits below the words' in which a spline's parameter adds up.
// Networks 0, for less logic: steps by the networks' program on one multiplier, and block RAM.
// Segments of a kind not in Curves are drawn as the other kind.
// Formats: hls/words.hpp.
`default_nettype none
module curve_interpolator #(
    parameter int Curves         = 3,   // 1 lines and arcs, 2 splines, 3 both
    parameter int Order          = 6,   // [2, 12]
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int PositionBits   = 32,  // [16, 32]
    parameter int GuardBits      = 10,  // [2, 12]
    parameter int AuxAxes        = 0,   // [0, 6]
    parameter int Mode           = 0,   // 0 series, 1 polynomial
    parameter int Anchor         = 1,   // 0, 1; for splines
    parameter int SampleInterval = 1,   // 1, 2, 4, 8 clocks
    parameter int ParameterGuard = 0,   // [0, 8], for splines
    parameter int Networks       = 1,   // 1 steps by the networks, 0 by their program
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Segments, 17 + 3 AuxAxes words each
    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic [47:0] segment_data_i,

    // Path increments
    input  wire logic        request_valid_i,
    output logic             request_ready_o,
    input  wire logic [47:0] request_ds_i,

    // Samples, axis 0 in the low bits
    output logic                                                 sample_valid_o,
    input  wire logic                                            sample_ready_i,
    output logic      [            (3+AuxAxes)*PositionBits-1:0] sample_position_o,
    output logic      [(3+AuxAxes)*(PositionBits+GuardBits)-1:0] sample_fine_o,

    output logic [15:0] empty_segments_o
);

  initial if (Curves < 1 || Curves > 3) $fatal(1, "Curves must be 1, 2 or 3");
  initial if (Order < 2 || Order > 12) $fatal(1, "Order must be in [2, 12]");
  initial if (CoefBits < 18 || CoefBits > 36) $fatal(1, "CoefBits must be in [18, 36]");
  initial if (PositionBits < 16 || PositionBits > 32) $fatal(1, "PositionBits must be in [16, 32]");
  initial if (GuardBits < 2 || GuardBits > 12) $fatal(1, "GuardBits must be in [2, 12]");
  initial if (AuxAxes < 0 || AuxAxes > 6) $fatal(1, "AuxAxes must be in [0, 6]");
  initial if (Mode < 0 || Mode > 1) $fatal(1, "Mode must be 0 or 1");
  initial if (Anchor < 0 || Anchor > 1) $fatal(1, "Anchor must be 0 or 1");
  initial
    if (ParameterGuard < 0 || ParameterGuard > 8) $fatal(1, "ParameterGuard must be in [0, 8]");
  initial if (Networks < 0 || Networks > 1) $fatal(1, "Networks must be 0 or 1");
  initial
    if (Networks == 0 && (Anchor != 1 || ParameterGuard != 0))
      $fatal(1, "Networks 0 works with Anchor 1 and ParameterGuard 0 only");
  initial
    if (MultiplierForm < 0 || MultiplierForm > 2) $fatal(1, "MultiplierForm must be in [0, 2]");
  initial
    if (SampleInterval != 1 && SampleInterval != 2 && SampleInterval != 4 && SampleInterval != 8)
      $fatal(1, "SampleInterval must be 1, 2, 4 or 8");

  localparam int FineBits = PositionBits + GuardBits;
  localparam int StepBits = curvecore_pkg::StepBits;
  localparam int TagBits = 10;  // 2^-k, sample, at its segment's end, step

  logic rst_n;
  reset_stretcher u_reset (
      .clk_i,
      .rst_ni,
      .rst_no(rst_n)
  );
  logic segment_ready, request_ready;
  assign segment_ready_o = segment_ready && rst_n;
  assign request_ready_o = request_ready && rst_n;

  // Steps, ahead of the samples, into banks.
  logic                                room;
  logic [                         2:0] write_step;
  logic                                done;
  logic                                last;
  logic [                         4:0] k;
  logic [                StepBits-1:0] offset;
  logic [                  StepBits:0] stride;
  logic [                CoefBits+4:0] rate;  // {there, axis, rate}
  logic [              2*FineBits+4:0] point;  // {there, axis, end, origin}
  logic [          bank_pkg::Bits-1:0] arc_write;
  logic [          bank_pkg::Bits-1:0] spline_write;
  logic [bank_pkg::Lanes*CoefBits-1:0] arc_words;
  logic [bank_pkg::Lanes*CoefBits-1:0] spline_words;
  if (Networks != 0) begin : g_networks
    curve_steps #(
        .Curves(Curves),
        .Order(Order),
        .CoefBits(CoefBits),
        .FineBits(FineBits),
        .GuardBits(GuardBits),
        .AuxAxes(AuxAxes),
        .Mode(Mode),
        .Anchor(Anchor),
        .ParameterGuard(ParameterGuard),
        .Form(MultiplierForm % 2)
    ) u_steps (
        .clk_i,
        .rst_ni(rst_n),
        .segment_valid_i,
        .segment_ready_o(segment_ready),
        .segment_data_i,
        .empty_segments_o,
        .room_i(room),
        .bank_i(write_step[1:0]),
        .done_o(done),
        .last_o(last),
        .k_o(k),
        .offset_o(offset),
        .stride_o(stride),
        .rate_o(rate),
        .point_o(point),
        .arc_write_o(arc_write),
        .arc_words_o(arc_words),
        .spline_write_o(spline_write),
        .spline_words_o(spline_words)
    );
  end else begin : g_program
    folded_steps #(
        .Curves(Curves),
        .Order(Order),
        .CoefBits(CoefBits),
        .FineBits(FineBits),
        .GuardBits(GuardBits),
        .AuxAxes(AuxAxes),
        .Mode(Mode),
        .MultiplierForm(MultiplierForm)
    ) u_steps (
        .clk_i,
        .rst_ni(rst_n),
        .segment_valid_i,
        .segment_ready_o(segment_ready),
        .segment_data_i,
        .empty_segments_o,
        .room_i(room),
        .bank_i(write_step[1:0]),
        .done_o(done),
        .last_o(last),
        .k_o(k),
        .offset_o(offset),
        .stride_o(stride),
        .rate_o(rate),
        .point_o(point),
        .arc_write_o(arc_write),
        .arc_words_o(arc_words),
        .spline_write_o(spline_write),
        .spline_words_o(spline_words)
    );
  end

  logic [           2:0] tau_phase;
  logic                  tau_valid;
  logic [  CoefBits-1:0] tau;
  logic [   TagBits-1:0] tau_tag;
  logic                  d_valid;
  logic [   TagBits-1:0] d_tag;
  logic [3*CoefBits-1:0] d;
  curve_sampler #(
      .Curves(Curves),
      .Order(Order),
      .CoefBits(CoefBits),
      .Mode(Mode),
      .SampleInterval(SampleInterval),
      .TagBits(TagBits),
      .MultiplierForm(MultiplierForm)
  ) u_sampler (
      .clk_i,
      .rst_ni(rst_n),
      .rate_i(rate),
      .arc_write_i(arc_write),
      .arc_words_i(arc_words),
      .spline_write_i(spline_write),
      .spline_words_i(spline_words),
      .phase_i(tau_phase),
      .valid_i(tau_valid),
      .tau_i(tau),
      .tag_i(tau_tag),
      .valid_o(d_valid),
      .d_o(d),
      .tag_o(d_tag)
  );

  sample_side #(
      .CoefBits(CoefBits),
      .PositionBits(PositionBits),
      .GuardBits(GuardBits),
      .AuxAxes(AuxAxes),
      .SampleInterval(SampleInterval),
      .SamplerClocks(curvecore_pkg::sampler_latency(Curves, Mode, Order, SampleInterval)),
      .QueueBlock(1 - Networks),
      .MultiplierForm(MultiplierForm)
  ) u_side (
      .clk_i,
      .rst_ni(rst_n),
      .room_o(room),
      .write_step_o(write_step),
      .step_done_i(done),
      .last_i(last),
      .k_i(k),
      .offset_i(offset),
      .stride_i(stride),
      .rate_i(rate),
      .point_i(point),
      .request_valid_i,
      .request_ready_o(request_ready),
      .request_ds_i,
      .phase_o(tau_phase),
      .tau_valid_o(tau_valid),
      .tau_o(tau),
      .tag_o(tau_tag),
      .d_valid_i(d_valid),
      .d_i(d),
      .tag_i(d_tag),
      .sample_valid_o,
      .sample_ready_i,
      .sample_position_o,
      .sample_fine_o
  );

endmodule
`default_nettype wire
