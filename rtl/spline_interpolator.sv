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
//   of an integration step            91 + those of spline_sequencer
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

  // Places for the samples under way at full rate.
  localparam int Passes = (Mode == 0) ? Order : Order + 3;
  localparam int SamplerClocks = curvecore_pkg::horner_latency(Passes, SampleInterval) + 1;
  localparam int UnderWay = (SamplerClocks + 16) / SampleInterval + 7;
  localparam int QueueDepth = (UnderWay > 16) ? 2 ** $clog2(UnderWay) : 16;

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

  // Sample side: in slots of SampleInterval clocks.
  localparam logic [2:0] PhaseMask = 3'(SampleInterval - 1);
  logic [2:0] phase_q;
  logic [2:0] tau_phase_q;  // tau is there five clocks after its slot
  logic       slot;
  assign slot = phase_q == 3'd0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      phase_q     <= 3'd0;
      tau_phase_q <= (3'd0 - 3'd5) & PhaseMask;
    end else begin
      phase_q     <= (phase_q + 3'd1) & PhaseMask;
      tau_phase_q <= (tau_phase_q + 3'd1) & PhaseMask;
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
  logic                tau_valid;
  logic                tau_sample;
  logic                tau_land;
  logic [         2:0] tau_step;
  logic [         4:0] tau_down;
  logic [CoefBits-1:0] tau;
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
      .valid_o(tau_valid),
      .sample_o(tau_sample),
      .land_o(tau_land),
      .step_o(tau_step),
      .down_o(tau_down),
      .tau_o(tau)
  );

  logic                     d_valid;
  logic [              9:0] d_tag;
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
      .phase_i(tau_phase_q),
      .valid_i(tau_valid),
      .tau_i(tau),
      .tag_i({tau_down, tau_sample, tau_land, tau_step}),
      .valid_o(d_valid),
      .d_o(d),
      .tag_o(d_tag)
  );

  // A sample's way through the landers.
  logic [4:0] land_valid_q;
  logic [4:0] land_sample_q;
  logic [2:0] land_q;
  logic [2:0] land_step_q[4];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      land_valid_q  <= '0;
      land_sample_q <= '0;
    end else begin
      land_valid_q  <= {land_valid_q[3:0], d_valid};
      land_sample_q <= {land_sample_q[3:0], d_valid && d_tag[4]};
    end
  end
  always_ff @(posedge clk_i) begin
    land_q         <= {land_q[1:0], d_tag[3]};
    land_step_q[0] <= d_tag[2:0];
    land_step_q[1] <= land_step_q[0];
    land_step_q[2] <= land_step_q[1];
    land_step_q[3] <= land_step_q[2];
  end

  series_buffer u_buffer (
      .clk_i,
      .rst_ni,
      .room_o(room),
      .write_step_o(write_step),
      .write_i(step_done),
      .last_i(last),
      .k_i(k),
      .offset_i(offset),
      .stride_i(stride),
      .current_step_i(step),
      .next_valid_o(next_valid),
      .next_stride_o(next_stride),
      .look_step_i(look_step),
      .look_last_o(look_last),
      .look_k_o(look_k),
      .look_offset_o(look_offset),
      .leave_i(land_valid_q[3]),
      .leave_step_i(land_step_q[3])
  );

  logic [    Axes*FineBits-1:0] fine;
  logic [Axes*PositionBits-1:0] position;
  for (genvar n = 0; n < Axes; n++) begin : g_axis
    logic write;
    assign write = point_write && point_axis == 4'(n);
    lander #(
        .CoefBits(CoefBits),
        .PositionBits(PositionBits),
        .GuardBits(GuardBits)
    ) u_lander (
        .clk_i,
        .write_i(write),
        .write_bank_i(write_step[1:0]),
        .write_origin_i(origin),
        .write_end_i(segment_end),
        .d_i(d[n*CoefBits+:CoefBits]),
        .down_i(d_tag[9:5]),
        .origin_bank_i(land_step_q[0][1:0]),
        .end_bank_i(land_step_q[2][1:0]),
        .land_i(land_q[2]),
        .fine_o(fine[n*FineBits+:FineBits]),
        .position_o(position[n*PositionBits+:PositionBits])
    );
  end

  sample_queue #(
      .Bits (Axes * (FineBits + PositionBits)),
      .Depth(QueueDepth)
  ) u_sample (
      .clk_i,
      .rst_ni,
      .admit_i(request_admitted && request_take),
      .room_o (room_for_sample),
      .push_i (land_sample_q[4]),
      .data_i ({fine, position}),
      .valid_o(sample_valid_o),
      .ready_i(sample_ready_i),
      .data_o ({sample_fine_o, sample_position_o})
  );

endmodule
`default_nettype wire
