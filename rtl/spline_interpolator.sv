// SPDX-License-Identifier: Apache-2.0
// Positions along splines at constant path speed, one per request: [Chikurov] Fig. 10.
// Twin: hls/interpolator_kernel.hpp with hls/spline_kernel.hpp, bit for bit.
//
//   segment words -> loader -> anchor -> network (steps ahead) -> banks -> sampler -> lander ->
//   requests ------> step tracker -> offset ---------------------------------^         samples
//
// A request moves `ds` quanta (2^-16 length unit) along the path and yields the sample there, in
// order.  It waits until the step it leads to is there.
//
//   clocks                            value
//   between samples                   SampleInterval
//   request to sample                 12 + 3 SampleInterval + that of spline_sampler, and up to
//                                     SampleInterval - 1 more
//   of an integration step            94 + those of spline_sequencer
//   to load a segment                 18 + 3 AuxAxes, while the one before is drawn
//
// Samples come at full rate as long as every step holds the samples of the larger of the last two.
// Segments of other kinds are not for this core.  Reset: two clocks or more.
// Formats: hls/words.hpp.
`default_nettype none
module spline_interpolator #(
    parameter int Order          = 6,   // [2, 12]
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int PositionBits   = 32,  // [16, 32]
    parameter int GuardBits      = 10,  // [2, 12]
    parameter int AuxAxes        = 0,   // [0, 6]
    parameter int Mode           = 1,   // 0 series, 1 polynomial
    parameter int Anchor         = 1,   // 0, 1; 0 with Mode 1 only
    parameter int SampleInterval = 1,   // 1, 2, 4, 8 clocks
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

  initial if (Order < 2 || Order > 12) $fatal(1, "Order must be in [2, 12]");
  initial if (CoefBits < 18 || CoefBits > 36) $fatal(1, "CoefBits must be in [18, 36]");
  initial if (PositionBits < 16 || PositionBits > 32) $fatal(1, "PositionBits must be in [16, 32]");
  initial if (GuardBits < 2 || GuardBits > 12) $fatal(1, "GuardBits must be in [2, 12]");
  initial if (AuxAxes < 0 || AuxAxes > 6) $fatal(1, "AuxAxes must be in [0, 6]");
  initial if (Anchor < 0 || Anchor > 1) $fatal(1, "Anchor must be 0 or 1");
  initial if (Mode < 0 || Mode > 1) $fatal(1, "Mode must be 0 or 1");
  initial
    if (MultiplierForm < 0 || MultiplierForm > 2) $fatal(1, "MultiplierForm must be in [0, 2]");
  initial
    if (SampleInterval != 1 && SampleInterval != 2 && SampleInterval != 4 && SampleInterval != 8)
      $fatal(1, "SampleInterval must be 1, 2, 4 or 8");

  localparam int Axes = 3 + AuxAxes;
  localparam int FineBits = PositionBits + GuardBits;
  localparam int StepBits = curvecore_pkg::StepBits;
  localparam int TagBits = 10;  // 2^-k, a sample, at its segment's end, step

  localparam int Passes = (Mode == 0) ? Order : Order + 3;
  localparam int SamplerClocks = curvecore_pkg::horner_latency(Passes, SampleInterval) + 1;

  // Network side: steps into banks.
  logic                         room;
  logic        [           2:0] write_step;
  logic                         step_done;
  logic                         last;
  logic        [           4:0] k;
  logic        [  StepBits-1:0] offset;
  logic        [    StepBits:0] stride;
  logic                         rate_valid;
  logic        [           3:0] rate_axis;
  logic signed [  CoefBits-1:0] advance;
  logic                         point_write;
  logic        [           3:0] point_axis;
  logic signed [  FineBits-1:0] origin;
  logic signed [  FineBits-1:0] segment_end;
  logic        [           2:0] a_write;
  logic        [  CoefBits-1:0] a;
  logic        [           2:0] v_write;
  logic        [3*CoefBits-1:0] v;
  logic        [           2:0] b_write;
  logic        [3*CoefBits-1:0] b;
  logic        [  CoefBits+4:0] q;
  logic        [  CoefBits+4:0] x;
  logic        [  CoefBits+4:0] y;
  logic        [  CoefBits+4:0] z;
  spline_steps #(
      .Order(Order),
      .CoefBits(CoefBits),
      .FineBits(FineBits),
      .GuardBits(GuardBits),
      .AuxAxes(AuxAxes),
      .Mode(Mode),
      .Anchor(Anchor),
      .Form(MultiplierForm % 2)
  ) u_steps (
      .clk_i,
      .rst_ni,
      .segment_valid_i,
      .segment_ready_o,
      .segment_data_i,
      .empty_segments_o,
      .room_i(room),
      .done_o(step_done),
      .last_o(last),
      .k_o(k),
      .offset_o(offset),
      .stride_o(stride),
      .rate_valid_o(rate_valid),
      .rate_axis_o(rate_axis),
      .advance_o(advance),
      .point_write_o(point_write),
      .point_axis_o(point_axis),
      .origin_o(origin),
      .end_o(segment_end),
      .a_write_o(a_write),
      .a_o(a),
      .v_write_o(v_write),
      .v_o(v),
      .b_write_o(b_write),
      .b_o(b),
      .q_o(q),
      .x_o(x),
      .y_o(y),
      .z_o(z)
  );

  logic [              2:0] tau_phase;
  logic                     tau_valid;
  logic [     CoefBits-1:0] tau;
  logic [      TagBits-1:0] tau_tag;
  logic                     d_valid;
  logic [      TagBits-1:0] d_tag;
  logic [Axes*CoefBits-1:0] d;
  spline_sampler #(
      .Order(Order),
      .CoefBits(CoefBits),
      .AuxAxes(AuxAxes),
      .Mode(Mode),
      .SampleInterval(SampleInterval),
      .TagBits(TagBits),
      .MultiplierForm(MultiplierForm)
  ) u_sampler (
      .clk_i,
      .rst_ni,
      .bank_i(write_step[1:0]),
      .rate_valid_i(rate_valid),
      .rate_axis_i(rate_axis),
      .advance_i(advance),
      .a_write_i(a_write),
      .a_i(a),
      .v_write_i(v_write),
      .v_i(v),
      .b_write_i(b_write),
      .b_i(b),
      .q_i(q),
      .x_i(x),
      .y_i(y),
      .z_i(z),
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
      .SamplerClocks(SamplerClocks)
  ) u_side (
      .clk_i,
      .rst_ni,
      .room_o(room),
      .write_step_o(write_step),
      .step_done_i(step_done),
      .last_i(last),
      .k_i(k),
      .offset_i(offset),
      .stride_i(stride),
      .point_write_i(point_write),
      .point_axis_i(point_axis),
      .origin_i(origin),
      .end_i(segment_end),
      .request_valid_i,
      .request_ready_o,
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
