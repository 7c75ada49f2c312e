// SPDX-License-Identifier: Apache-2.0
// The sample side of an interpolator for any curve: all but the sampler of x y z, which stands
// between tau and d.  Twin: hls/interpolator_kernel.hpp.
//
//   requests -> step tracker -> offset -> tau .. d -> landers -> samples
//                    ^             ^                     ^
//   steps -> banks --+-------------+---------------------+
//
// Everything up to tau moves in slots of SampleInterval clocks; phase_o counts clocks from a tau's
// slot on.  tag_o goes through the sampler to tag_i: 2^-k, a sample, at its segment's end, step.
// QueueDepth has places for all samples under way.
`default_nettype none
module sample_side #(
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int PositionBits   = 32,  // [16, 32]
    parameter int GuardBits      = 10,  // [2, 12]
    parameter int AuxAxes        = 0,   // [0, 6]
    parameter int SampleInterval = 1,   // 1, 2, 4, 8 clocks
    parameter int SamplerClocks  = 37,  // clocks from tau to d
    parameter int QueueBlock     = 0,   // memory of the queue: 0 distributed, 1 block RAM
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Steps into banks
    output logic                                       room_o,
    output logic      [                           2:0] write_step_o,
    input  wire logic                                  step_done_i,
    input  wire logic                                  last_i,
    input  wire logic [                           4:0] k_i,
    input  wire logic [   curvecore_pkg::StepBits-1:0] offset_i,
    input  wire logic [     curvecore_pkg::StepBits:0] stride_i,
    input  wire logic [                  CoefBits+4:0] rate_i,        // {there, axis, rate}
    input  wire logic [2*(PositionBits+GuardBits)+4:0] point_i,       // {there, axis, end, origin}

    // Path increments
    input  wire logic        request_valid_i,
    output logic             request_ready_o,
    input  wire logic [47:0] request_ds_i,

    // To the sampler and back
    output logic      [           2:0] phase_o,
    output logic                       tau_valid_o,
    output logic      [  CoefBits-1:0] tau_o,
    output logic      [           9:0] tag_o,
    input  wire logic                  d_valid_i,
    input  wire logic [3*CoefBits-1:0] d_i,
    input  wire logic [           9:0] tag_i,

    // Samples, axis 0 in the low bits
    output logic                                                 sample_valid_o,
    input  wire logic                                            sample_ready_i,
    output logic      [            (3+AuxAxes)*PositionBits-1:0] sample_position_o,
    output logic      [(3+AuxAxes)*(PositionBits+GuardBits)-1:0] sample_fine_o
);

  localparam int Axes = 3 + AuxAxes;
  localparam int StepBits = curvecore_pkg::StepBits;

  localparam int UnderWay = (SamplerClocks + 16) / SampleInterval + 7;
  localparam int QueueDepth = (UnderWay > 16) ? 2 ** $clog2(UnderWay) : 16;

  localparam logic [2:0] PhaseMask = 3'(SampleInterval - 1);
  logic [2:0] phase_q;
  logic       slot;
  assign slot = phase_q == 3'd0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      phase_q <= 3'd0;
      phase_o <= (3'd0 - 3'd5) & PhaseMask;  // tau is there five clocks after its slot
    end else begin
      phase_q <= (phase_q + 3'd1) & PhaseMask;
      phase_o <= (phase_o + 3'd1) & PhaseMask;
    end
  end

  logic request_there;
  logic request_take;
  logic room_for_sample;
  logic request_admitted;
  assign request_admitted = request_there && room_for_sample;
  logic [47:0] request_ds;
  skid_buffer #(
      .Bits(48)
  ) u_request (
      .clk_i,
      .rst_ni,
      .valid_i(request_valid_i),
      .ready_o(request_ready_o),
      .data_i (request_ds_i),
      .valid_o(request_there),
      .ready_i(request_take && room_for_sample),
      .data_o (request_ds)
  );

  logic                next_valid;
  logic [  StepBits:0] next_stride;
  logic                token;
  logic                tracked;
  logic [         2:0] step;
  logic [StepBits-1:0] left;
  step_tracker u_tracker (
      .clk_i,
      .rst_ni,
      .slot_i(slot),
      .request_valid_i(request_admitted),
      .request_ready_o(request_take),
      .request_ds_i(request_ds),
      .next_valid_i(next_valid),
      .next_stride_i(next_stride),
      .token_o(token),
      .sample_o(tracked),
      .step_o(step),
      .left_o(left)
  );

  logic [         2:0] look_step;
  logic                look_last;
  logic [         4:0] look_k;
  logic [StepBits-1:0] look_offset;
  logic                tau_sample;
  logic                tau_land;
  logic [         2:0] tau_step;
  logic [         4:0] tau_down;
  sample_offset #(
      .CoefBits(CoefBits)
  ) u_offset (
      .clk_i,
      .rst_ni,
      .token_i(token),
      .sample_i(tracked),
      .step_i(step),
      .left_i(left),
      .look_step_o(look_step),
      .look_last_i(look_last),
      .look_k_i(look_k),
      .look_offset_i(look_offset),
      .valid_o(tau_valid_o),
      .sample_o(tau_sample),
      .land_o(tau_land),
      .step_o(tau_step),
      .down_o(tau_down),
      .tau_o
  );

  assign tag_o = {tau_down, tau_sample, tau_land, tau_step};

  logic [Axes*CoefBits-1:0] d;
  assign d[3*CoefBits-1:0] = d_i;
  if (AuxAxes > 0) begin : g_auxiliary
    auxiliary_sampler #(
        .CoefBits(CoefBits),
        .AuxAxes(AuxAxes),
        .SampleInterval(SampleInterval),
        .Latency(SamplerClocks),
        .MultiplierForm(MultiplierForm)
    ) u_auxiliary (
        .clk_i,
        .rst_ni,
        .bank_i(write_step_o[1:0]),
        .rate_i,
        .phase_i(phase_o),
        .tau_i(tau_o),
        .tau_bank_i(tag_o[1:0]),
        .d_o(d[Axes*CoefBits-1:3*CoefBits])
    );
  end else begin : g_no_auxiliary
    logic unused;
    assign unused = &rate_i;
  end

  logic       leave;
  logic [2:0] leave_step;
  series_buffer u_buffer (
      .clk_i,
      .rst_ni,
      .room_o,
      .write_step_o,
      .write_i(step_done_i),
      .last_i,
      .k_i,
      .offset_i,
      .stride_i,
      .current_step_i(step),
      .next_valid_o(next_valid),
      .next_stride_o(next_stride),
      .look_step_i(look_step),
      .look_last_o(look_last),
      .look_k_o(look_k),
      .look_offset_o(look_offset),
      .leave_i(leave),
      .leave_step_i(leave_step)
  );

  sample_landing #(
      .CoefBits(CoefBits),
      .PositionBits(PositionBits),
      .GuardBits(GuardBits),
      .Axes(Axes),
      .SampleInterval(SampleInterval),
      .QueueDepth(QueueDepth),
      .QueueBlock(QueueBlock)
  ) u_landing (
      .clk_i,
      .rst_ni,
      .write_bank_i(write_step_o[1:0]),
      .point_i,
      .valid_i(d_valid_i),
      .d_i(d),
      .tag_i,
      .leave_o(leave),
      .leave_step_o(leave_step),
      .admit_i(request_admitted && request_take),
      .room_o(room_for_sample),
      .sample_valid_o,
      .sample_ready_i,
      .sample_position_o,
      .sample_fine_o
  );

endmodule
`default_nettype wire
