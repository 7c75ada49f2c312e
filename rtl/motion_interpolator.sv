// SPDX-License-Identifier: Apache-2.0
// Motion along a program's path: segments and profile pieces in, a position per request out.
// Segments are lines, arcs and helices, and with Splines = 1 splines between them, in one queue.
//
//   profile words -> queue -> path generator -> share -> path increments -> curve core -> samples
//                       requests -> rate of time --^        segment words -> queue --^
//
// A request for the first of 2^samples_per_tick_log2_i samples starts a tick of time. Its rate
// follows override_i, or stops for hold_i, kill_i and underrun, with bounded first and second
// differences; time stops, the geometry stays. Inputs beside the streams belong to that request.
//
//   samples per clock                    1 / SampleInterval (Build 0; Build 1: as the core)
//   request to path increment, clocks    about 60; to sample: plus the core's
//
// Reset: two clocks or more, in which the settings stand still. It empties the queues.
//
// Word formats: hls/words.hpp. Whoever feeds the profile keeps more ticks queued than
// 2 stop_ticks_i + 8, or the final piece; else underrun_o tells that time was stopped meanwhile.
`default_nettype none
module motion_interpolator #(
    parameter int Build             = 0,    // 0 parallel, 1 serial
    parameter int Order             = 6,    // [2, 12]
    parameter int CoefBits          = 36,   // [18, 36]
    parameter int PositionBits      = 32,   // [16, 32]
    parameter int GuardBits         = 10,   // [2, 12]
    parameter int AuxAxes           = 0,    // [0, 6]
    parameter int Splines           = 0,    // 1: segments of splines too
    parameter int Mode              = 0,    // 0 series, 1 polynomial
    parameter int Anchor            = 1,    // of splines: 0, 1; 0 with Build 0 only
    parameter int SampleInterval    = 1,    // 1, 2, 4, 8 clocks
    parameter int ParameterGuard    = 0,    // of splines: [0, 8]; above 0 with Build 0 only
    parameter int TurnBits          = 0,    // [0, 14]; above 0: as curve_interpolator's, Build 0
    parameter int MultiplierForm    = 0,    // 0 portable, 1 ECP5, 2 UP5K
    parameter int SegmentQueueWords = 256,  // [2, 65536], a power of two
    parameter int ProfileQueueWords = 512   // [16, 4096], a power of two
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Words
    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic [47:0] segment_data_i,
    input  wire logic        profile_valid_i,
    output logic             profile_ready_o,
    input  wire logic [47:0] profile_data_i,

    // Requests
    input  wire logic        sample_request_valid_i,
    output logic             sample_request_ready_o,
    input  wire logic        hold_i,
    input  wire logic [16:0] override_i,              // 65536 = 100 %
    input  wire logic        kill_i,                  // stops for good

    // Settings, which stand still
    input wire logic [ 3:0] samples_per_tick_log2_i,
    input wire logic [31:0] hold_acceleration_i,      // second difference of time, 2^-32 per tick^2
    input wire logic [32:0] hold_slope_i,             // first difference, a multiple of it
    input wire logic [31:0] stop_ticks_i,             // from full rate, within these bounds

    // Samples, axis 0 in the low bits
    output logic                                                 sample_valid_o,
    input  wire logic                                            sample_ready_i,
    output logic      [            (3+AuxAxes)*PositionBits-1:0] sample_position_o,
    output logic      [(3+AuxAxes)*(PositionBits+GuardBits)-1:0] sample_fine_o,

    // Telemetry: path_valid_o once per sample, before it
    output logic        path_valid_o,
    output logic [47:0] path_ds_o,
    output logic [16:0] path_rate_o,
    output logic [63:0] path_o,
    output logic        active_o,         // a program is under way
    output logic        underrun_o,       // sticky
    output logic        killed_o,
    output logic [15:0] empty_segments_o
);

  initial if (Build < 0 || Build > 1) $fatal(1, "Build must be 0 or 1");
  initial if (Splines < 0 || Splines > 1) $fatal(1, "Splines must be 0 or 1");
  initial if (Build == 1 && Anchor != 1) $fatal(1, "Build 1 works with Anchor 1 only");
  initial
    if (Build == 1 && ParameterGuard != 0) $fatal(1, "Build 1 works with ParameterGuard 0 only");
  initial if (Build == 1 && TurnBits != 0) $fatal(1, "Build 1 works with TurnBits 0 only");

  // A serial core takes its time: one multiplier does for its path.
  localparam int TickInterval = (Build == 1) ? 8 : SampleInterval;
  localparam int Room = (TickInterval <= 2) ? 128 : (TickInterval == 4) ? 32 : 16;

  // Profile
  logic word_valid;
  logic word_ready;
  logic [47:0] word;
  word_queue #(
      .Bits (48),
      .Depth(ProfileQueueWords)
  ) u_profile_queue (
      .clk_i,
      .rst_ni,
      .valid_i(profile_valid_i),
      .ready_o(profile_ready_o),
      .data_i (profile_data_i),
      .valid_o(word_valid),
      .ready_i(word_ready),
      .data_o (word)
  );

  logic queued;
  logic plenty;
  logic final_queued;
  logic [31:0] queued_ticks;
  logic take;
  logic [19:0] take_ticks;
  logic take_final;
  piece_ledger #(
      .QueueWords(ProfileQueueWords)
  ) u_ledger (
      .clk_i,
      .rst_ni,
      .word_i(profile_valid_i && profile_ready_o),
      .data_i(profile_data_i),
      .take_i(take),
      .take_ticks_i(take_ticks),
      .take_final_i(take_final),
      .queued_o(queued),
      .plenty_o(plenty),
      .final_o(final_queued),
      .ticks_o(queued_ticks)
  );

  logic present_final;
  logic signed [21:0] present_ticks;
  logic [4:0] started;
  logic hold;
  underrun_guard u_guard (
      .clk_i,
      .rst_ni,
      .stop_ticks_i,
      .plenty_i(plenty),
      .final_i(final_queued),
      .ticks_i(queued_ticks),
      .active_i(active_o),
      .present_final_i(present_final),
      .present_ticks_i(present_ticks),
      .started_i(started),
      .hold_o(hold),
      .underrun_o
  );

  // Requests into ticks of time
  logic tick;
  logic [16:0] target;
  logic tick_taken;
  logic sent;
  logic wanted;
  sample_gate #(
      .Room(Room)
  ) u_gate (
      .clk_i,
      .rst_ni,
      .samples_per_tick_log2_i,
      .request_valid_i(sample_request_valid_i),
      .request_ready_o(sample_request_ready_o),
      .kill_i,
      .hold_i,
      .underrun_i(hold),
      .override_i,
      .tick_o(tick),
      .target_o(target),
      .killed_o,
      .tick_taken_i(tick_taken),
      .started_o(started),
      .sent_i(sent),
      .wanted_o(wanted)
  );

  // The gate keeps room in these queues and in that of the increments.
  logic target_room;
  logic next_valid;
  logic next_ready;
  logic [16:0] next_target;
  word_queue #(
      .Bits (17),
      .Depth(16)
  ) u_target_queue (
      .clk_i,
      .rst_ni,
      .valid_i(tick),
      .ready_o(target_room),
      .data_i (target),
      .valid_o(next_valid),
      .ready_i(next_ready),
      .data_o (next_target)
  );

  logic scaled_valid;
  logic [16:0] scaled;
  time_scaler u_scaler (
      .clk_i,
      .rst_ni,
      .acceleration_i(hold_acceleration_i),
      .slope_i(hold_slope_i),
      .valid_i(next_valid),
      .ready_o(next_ready),
      .target_i(next_target),
      .valid_o(scaled_valid),
      .rate_o(scaled)
  );

  logic rate_room;
  logic rate_valid;
  logic rate_ready;
  logic [16:0] rate;
  word_queue #(
      .Bits (17),
      .Depth(16)
  ) u_rate_queue (
      .clk_i,
      .rst_ni,
      .valid_i(scaled_valid),
      .ready_o(rate_room),
      .data_i (scaled),
      .valid_o(rate_valid),
      .ready_i(rate_ready),
      .data_o (rate)
  );

  // Ticks into path increments
  logic ds_valid;
  logic [47:0] ds;
  logic [16:0] ds_rate;
  path_generator #(
      .Interval(TickInterval),
      .MultiplierForm(MultiplierForm)
  ) u_path (
      .clk_i,
      .rst_ni,
      .word_valid_i(word_valid),
      .word_ready_o(word_ready),
      .word_i(word),
      .queued_i(queued),
      .rate_valid_i(rate_valid),
      .rate_ready_o(rate_ready),
      .rate_i(rate),
      .tick_taken_o(tick_taken),
      .ds_valid_o(ds_valid),
      .ds_o(ds),
      .ds_rate_o(ds_rate),
      .piece_take_o(take),
      .active_o,
      .last_o(present_final),
      .ticks_left_o(present_ticks),
      .next_ticks_o(take_ticks),
      .next_final_o(take_final)
  );

  logic ds_room;
  logic share_valid;
  logic share_ready;
  logic [64:0] share;
  word_queue #(
      .Bits (65),
      .Depth(Room)
  ) u_ds_queue (
      .clk_i,
      .rst_ni,
      .valid_i(ds_valid),
      .ready_o(ds_room),
      .data_i ({ds_rate, ds}),
      .valid_o(share_valid),
      .ready_i(share_ready),
      .data_o (share)
  );
  logic unused_rooms;
  assign unused_rooms = target_room && rate_room && ds_room;

  logic move_valid;
  logic move_ready;
  logic [47:0] move_ds;
  logic [16:0] move_rate;
  sample_share u_share (
      .clk_i,
      .rst_ni,
      .samples_per_tick_log2_i,
      .tick_valid_i(share_valid),
      .tick_ready_o(share_ready),
      .tick_ds_i(share[47:0]),
      .tick_rate_i(share[64:48]),
      .wanted_i(wanted),
      .sent_o(sent),
      .sample_valid_o(move_valid),
      .sample_ready_i(move_ready),
      .sample_ds_o(move_ds),
      .sample_rate_o(move_rate)
  );

  path_meter u_meter (
      .clk_i,
      .rst_ni,
      .move_i (move_valid && move_ready),
      .ds_i   (move_ds),
      .rate_i (move_rate),
      .valid_o(path_valid_o),
      .ds_o   (path_ds_o),
      .rate_o (path_rate_o),
      .path_o
  );

  // Curve
  logic core_segment_valid;
  logic core_segment_ready;
  logic [47:0] core_segment_data;
  word_queue #(
      .Bits (48),
      .Depth(SegmentQueueWords)
  ) u_segment_queue (
      .clk_i,
      .rst_ni,
      .valid_i(segment_valid_i),
      .ready_o(segment_ready_o),
      .data_i (segment_data_i),
      .valid_o(core_segment_valid),
      .ready_i(core_segment_ready),
      .data_o (core_segment_data)
  );

  if (Build == 0) begin : g_parallel
    curve_interpolator #(
        .Curves((Splines == 1) ? 3 : 1),
        .Order(Order),
        .CoefBits(CoefBits),
        .PositionBits(PositionBits),
        .GuardBits(GuardBits),
        .AuxAxes(AuxAxes),
        .Mode(Mode),
        .Anchor(Anchor),
        .SampleInterval(SampleInterval),
        .ParameterGuard(ParameterGuard),
        .TurnBits(TurnBits),
        .MultiplierForm(MultiplierForm)
    ) u_core (
        .clk_i,
        .rst_ni,
        .segment_valid_i(core_segment_valid),
        .segment_ready_o(core_segment_ready),
        .segment_data_i(core_segment_data),
        .request_valid_i(move_valid),
        .request_ready_o(move_ready),
        .request_ds_i(move_ds),
        .sample_valid_o,
        .sample_ready_i,
        .sample_position_o,
        .sample_fine_o,
        .empty_segments_o
    );
  end else begin : g_serial
    curve_interpolator_serial #(
        .Order(Order),
        .CoefBits(CoefBits),
        .PositionBits(PositionBits),
        .GuardBits(GuardBits),
        .AuxAxes(AuxAxes),
        .Mode(Mode),
        .SampleInterval(SampleInterval),
        .MultiplierForm(MultiplierForm),
        .Splines(Splines)
    ) u_core (
        .clk_i,
        .rst_ni,
        .segment_valid_i(core_segment_valid),
        .segment_ready_o(core_segment_ready),
        .segment_data_i(core_segment_data),
        .request_valid_i(move_valid),
        .request_ready_o(move_ready),
        .request_ds_i(move_ds),
        .sample_valid_o,
        .sample_ready_i,
        .sample_position_o,
        .sample_fine_o,
        .empty_segments_o
    );
  end

endmodule
`default_nettype wire
