// SPDX-License-Identifier: Apache-2.0
// A motion_interpolator whose samples wait until they are taken, and which can be emptied between
// two of them.
//
//   words -> motion_interpolator -> samples that are offered, each until it is taken
//                   ^ SamplesAhead requests
//
// ends_i: no further sample is offered. When none is, empty_o resets the motion while ends_i is 1,
// and a clock more, in which no word is taken.
//
// With Build 2 samples are rates of the axes, and wait here until they are due: one that is taken
// is what rates_read_i, {last, axis}, reads next; rates_o is {valid, and two clocks later
// refused, fresh, moves, rate}. Samples of the host are drawn here, too: one at a time, when no
// other waits.
`default_nettype none
module paced_motion #(
    parameter int Build             = 2,
    parameter int Order             = 6,
    parameter int CoefBits          = 36,
    parameter int PositionBits      = 32,
    parameter int GuardBits         = 10,
    parameter int AuxAxes           = 0,
    parameter int Splines           = 1,
    parameter int Mode              = 1,
    parameter int SampleInterval    = 8,
    parameter int Networks          = 1,
    parameter int MultiplierForm    = 0,
    parameter int Table             = 0,
    parameter int SegmentQueueWords = 1024,  // [64, 65536], a power of two
    parameter int ProfileQueueWords = 1024,  // [16, 4096], a power of two
    parameter int SamplesAhead      = 4,     // [1, 15]
    parameter int PeriodLog2        = 13,
    parameter int Outputs           = 0,     // 0: none; rtl/output/path_outputs.sv
    parameter int Shaper            = 0,     // its Delay
    parameter     Program           = "",    // files of Build 2
    parameter     Data              = ""
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Words, and how many of them the queues still take
    input  wire logic [15:0] digest_i,         // rtl/motion_interpolator.sv
    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic        profile_valid_i,
    output logic             profile_ready_o,
    input  wire logic [47:0] word_i,
    output logic      [15:0] segment_room_o,
    output logic      [15:0] profile_room_o,

    // Time: rtl/motion_interpolator.sv
    input wire logic        hold_i,
    input wire logic [16:0] override_i,
    input wire logic [ 3:0] samples_per_tick_log2_i,
    input wire logic [31:0] hold_acceleration_i,
    input wire logic [32:0] hold_slope_i,
    input wire logic [31:0] stop_ticks_i,

    // .. and with Build 2 instead of these settings what asks for them: rtl/engine/engine_motion.sv
    output logic             setting_next_o,
    output logic      [ 6:0] setting_word_o,
    input  wire logic [32:0] setting_i,

    // Samples, axis 0 in the low bits
    input wire logic ends_i,
    output logic empty_o,
    output logic sample_valid_o,
    input wire logic sample_ready_i,
    output logic sample_taken_o,
    output logic [(3+AuxAxes)*(PositionBits+GuardBits)-1:0] sample_o,  // 0 with Build 2

    // Build 2: rtl/engine/engine_rates.sv, rtl/motion_system.sv. No sample moves what is off.
    input wire logic off_i,
    input wire logic [3+AuxAxes-1:0] reference_i,
    input wire logic by_host_i,  // a host's sample waits
    output logic [3:0] axis_o,
    input wire logic [PositionBits-1:0] position_i,  // axis_o's, a clock later
    input wire logic [4:0] rates_read_i,
    output logic [pulse_pkg::StepFraction+PeriodLog2+3:0] rates_o,

    // Outputs: rtl/output/path_outputs.sv
    input  wire logic        keeps_i,
    input  wire logic        drawn_i,
    output logic      [ 7:0] bits_o,
    output logic      [11:0] power_o,
    output logic             pwm_o,
    input  wire logic        delay_write_i,
    input  wire logic [ 8:0] delay_i,

    // Telemetry
    output logic [16:0] path_rate_o,
    output logic [63:0] path_o,
    output logic        path_changes_o,  // rtl/engine/engine_motion.sv
    output logic        active_o,
    output logic        underrun_o,
    output logic        standing_o,
    output logic [ 7:0] fault_o
);

  initial if (Build != 0 && Networks != 1) $fatal(1, "Build %0d works with Networks 1 only", Build);
  initial if (Table < 0 || Table > 1023) $fatal(1, "Table must be in [0, 1023]");
  initial if (Build != 2 && Table != 0) $fatal(1, "Build %0d works with Table 0 only", Build);
  initial if (SamplesAhead < 1 || SamplesAhead > 15) $fatal(1, "SamplesAhead must be in [1, 15]");

  // An offered sample stays.
  logic rst_n;  // a register: it goes far
  logic made;
  logic taken;
  logic offered_q;
  logic ready;
  logic placing;  // it will be offered
  assign sample_valid_o = made && rst_n && (offered_q || !ends_i);
  assign taken = sample_valid_o && ready;
  assign sample_taken_o = taken;
  assign empty_o = ends_i && !sample_valid_o && !placing;
  always_ff @(posedge clk_i) begin
    rst_n <= rst_ni && !empty_o;
    if (!rst_ni) offered_q <= 1'b0;
    else offered_q <= (sample_valid_o && !ready) || placing;
  end

  // Outputs come later than the axes with a shaper.
  logic standing;
  logic outputs_settled;
  assign standing_o = standing && outputs_settled;

  // Words enter only if there is room: in their queue, or in the engine's entry.
  logic segment_ready;
  logic profile_ready;
  logic segment_valid;
  logic profile_valid;
  logic of_outputs;  // the profile's word
  logic outputs_ready;
  logic [15:0] profile_room, outputs_room;
  assign segment_ready_o = rst_n && segment_ready && segment_room_o != '0;
  assign profile_ready_o = rst_n &&
      (of_outputs ? outputs_ready : profile_ready && profile_room != '0);
  assign segment_valid = segment_valid_i && segment_room_o != '0;
  assign profile_valid = profile_valid_i && profile_room != '0 && !of_outputs;
  assign profile_room_o = (outputs_room < profile_room) ? outputs_room : profile_room;
  logic segment_leaves;
  logic profile_leaves;
  logic path_valid;
  logic [47:0] unused_path_ds;
  logic unused_path_active;
  logic unused_killed;
  logic [15:0] unused_empty_segments;
  if (Build == 2) begin : g_engine
    initial
      if (Program == "" || Data == "")
        $fatal(1, "Build 2 needs Program and Data, files that scripts/microcode.sh makes");
    localparam int RateBits = pulse_pkg::StepFraction + PeriodLog2;
    logic [31:0] out;
    logic [1:0] limb;
    logic [15:0] data;
    logic work;
    logic placing_q;
    logic scale_last;
    logic [3+AuxAxes-1:0] references;
    logic unused_request_ready;
    logic signed [PositionBits-1:0] host;
    logic signed [31:0] position;  // the same with its sign
    assign host = position_i;
    assign position = host;
    assign work = rst_n && !off_i;
    assign placing = placing_q;
    always_ff @(posedge clk_i) begin
      if (!work || out[engine_pkg::OutSampleWhole]) placing_q <= 1'b0;
      else if (out[engine_pkg::OutPlacing]) placing_q <= 1'b1;
    end
    engine_motion #(
        .Order(Order),
        .CoefBits(CoefBits),
        .PositionBits(PositionBits),
        .GuardBits(GuardBits),
        .AuxAxes(AuxAxes),
        .Splines(Splines),
        .Mode(Mode),
        .RateBits(RateBits),
        .Ahead(SamplesAhead),
        .Table(Table),
        .MultiplierForm(MultiplierForm),
        .SegmentQueueWords(SegmentQueueWords),
        .ProfileQueueWords(ProfileQueueWords),
        .Program(Program),
        .Data(Data)
    ) u_motion (
        .clk_i,
        .rst_ni(work),
        .digest_i,
        .setting_next_o,
        .setting_word_o,
        .setting_i,
        .segment_valid_i(segment_valid),
        .segment_ready_o(segment_ready),
        .segment_data_i(word_i),
        .profile_valid_i(profile_valid),
        .profile_ready_o(profile_ready),
        .profile_data_i(word_i),
        .segment_leaves_o(segment_leaves),
        .profile_leaves_o(profile_leaves),
        .segment_room_o,
        .profile_room_o(profile_room),
        .sample_request_valid_i(1'b1),
        .sample_request_ready_o(unused_request_ready),
        .hold_i,
        .kill_i(1'b0),
        .out_o(out),
        .limb_o(limb),
        .data_o(data),
        .leaves_i(taken && !by_host_i),
        .awaited_i(1'b0),
        .position_waits_i(by_host_i && !made),
        .position_i(position),
        .references_i(9'(references)),
        .axis_i(axis_o),
        .scale_last_o(scale_last),
        .path_valid_o(path_valid),
        .path_ds_o(unused_path_ds),
        .path_rate_o,
        .path_active_o(unused_path_active),
        .path_o(path_o[60:0]),
        .path_changes_o,
        .active_o,
        .underrun_o,
        .killed_o(unused_killed),
        .standing_o(standing),
        .fault_o,
        .empty_segments_o(unused_empty_segments)
    );
    assign path_o[63:61] = '0;
    engine_rates #(
        .Axes(3 + AuxAxes),
        .PeriodLog2(PeriodLog2)
    ) u_rates (
        .clk_i,
        .rst_ni,
        .work_i(work),
        .out_i(out),
        .high_i(limb != 2'd0),
        .data_i(data),
        .axis_o,
        .scale_last_i(scale_last),
        .reference_i,
        .references_o(references),
        .empty_i(!rst_n),
        .made_o(made),
        .ready_o(ready),
        .taken_i(taken),
        .valid_o(rates_o[RateBits+3]),
        .read_axis_i(rates_read_i[3:0]),
        .read_last_i(rates_read_i[4]),
        .rate_o(rates_o[RateBits+2:0])
    );
    assign sample_o = '0;
    logic unused;
    assign unused = &{1'b0, sample_ready_i, limb, segment_leaves, profile_leaves,
                      override_i, samples_per_tick_log2_i, hold_acceleration_i, hold_slope_i,
                      stop_ticks_i};
  end else begin : g_samples
    // Requests
    logic [3:0] ahead_q;  // samples requested and not taken
    logic request;
    logic request_ready;
    logic [(3+AuxAxes)*PositionBits-1:0] unused_position;
    assign ready   = sample_ready_i;
    assign placing = 1'b0;
    assign request = ahead_q != 4'(SamplesAhead);
    always_ff @(posedge clk_i) begin
      if (!rst_n) ahead_q <= '0;
      else ahead_q <= ahead_q + {3'b0, request && request_ready} - {3'b0, taken};
    end
    motion_interpolator #(
        .Build(Build),
        .Order(Order),
        .CoefBits(CoefBits),
        .PositionBits(PositionBits),
        .GuardBits(GuardBits),
        .AuxAxes(AuxAxes),
        .Splines(Splines),
        .Mode(Mode),
        .SampleInterval(SampleInterval),
        .Networks(Networks),
        .MultiplierForm(MultiplierForm),
        .SegmentQueueWords(SegmentQueueWords),
        .ProfileQueueWords(ProfileQueueWords)
    ) u_motion (
        .clk_i,
        .rst_ni(rst_n),
        .digest_i,
        .segment_valid_i(segment_valid),
        .segment_ready_o(segment_ready),
        .segment_data_i(word_i),
        .profile_valid_i(profile_valid),
        .profile_ready_o(profile_ready),
        .profile_data_i(word_i),
        .segment_leaves_o(segment_leaves),
        .profile_leaves_o(profile_leaves),
        .sample_request_valid_i(request),
        .sample_request_ready_o(request_ready),
        .hold_i,
        .override_i,
        .kill_i(1'b0),
        .samples_per_tick_log2_i,
        .hold_acceleration_i,
        .hold_slope_i,
        .stop_ticks_i,
        .sample_valid_o(made),
        .sample_ready_i(taken),
        .sample_position_o(unused_position),
        .sample_fine_o(sample_o),
        .path_valid_o(path_valid),
        .path_ds_o(unused_path_ds),
        .path_rate_o,
        .path_active_o(unused_path_active),
        .path_o,
        .active_o,
        .underrun_o,
        .killed_o(unused_killed),
        .standing_o(standing),
        .fault_o,
        .empty_segments_o(unused_empty_segments)
    );
    queue_room #(
        .Words(SegmentQueueWords)
    ) u_segment_room (
        .clk_i,
        .rst_ni (rst_n),
        .put_i  (segment_valid_i && segment_ready_o),
        .leave_i(segment_leaves),
        .room_o (segment_room_o)
    );
    queue_room #(
        .Words(ProfileQueueWords)
    ) u_profile_room (
        .clk_i,
        .rst_ni (rst_n),
        .put_i  (profile_valid_i && profile_ready_o && !of_outputs),
        .leave_i(profile_leaves),
        .room_o (profile_room)
    );
    assign path_changes_o = 1'b0;
    assign axis_o = '0;
    assign rates_o = '0;
    assign setting_next_o = 1'b0;
    assign setting_word_o = '0;
    logic unused;
    assign unused = &{1'b0, setting_i, reference_i, position_i, rates_read_i};
  end

  if (Outputs != 0) begin : g_outputs
    path_outputs #(
        .Words(Outputs),
        .Form (MultiplierForm),
        .Delay(Shaper)
    ) u_outputs (
        .clk_i,
        .rst_ni,
        .flush_i(!rst_n),
        .keep_i(keeps_i),
        .valid_i(profile_valid_i),
        .word_i,
        .next_o(of_outputs),
        .ready_o(outputs_ready),
        .room_o(outputs_room),
        .made_i(path_valid),
        .path_i(path_o[39:8]),
        .taken_i(taken && !by_host_i),
        .drawn_i,
        .enable_i(!off_i),
        .delay_write_i,
        .delay_i,
        .settled_o(outputs_settled),
        .bits_o,
        .power_o,
        .pwm_o
    );
  end else begin : g_no_outputs
    logic unused;
    assign of_outputs = 1'b0;
    assign outputs_ready = 1'b0;
    assign outputs_room = '1;
    assign outputs_settled = 1'b1;
    assign bits_o = '0;
    assign power_o = '0;
    assign pwm_o = 1'b0;
    assign unused = &{1'b0, keeps_i, drawn_i, path_valid, by_host_i, off_i, delay_write_i, delay_i};
  end

endmodule
`default_nettype wire
