// SPDX-License-Identifier: Apache-2.0
// Build 0 of rtl/motion_interpolator.sv, which describes all ports: circuits for each of its tasks.
//
//   profile words -> queue -> path generator -> share -> path increments -> curve core -> samples
//                       requests -> rate of time --^        segment words -> queue --^
`default_nettype none
module path_interpolator #(
    parameter int Order             = 6,     // [2, 12]
    parameter int CoefBits          = 36,    // [18, 36]
    parameter int PositionBits      = 32,    // [16, 32]
    parameter int GuardBits         = 10,    // [2, 12]
    parameter int AuxAxes           = 0,     // [0, 6]
    parameter int Splines           = 0,     // 1: segments of splines too
    parameter int Mode              = 0,     // 0 series, 1 polynomial
    parameter int Anchor            = 1,     // 0, 1, for splines
    parameter int SampleInterval    = 1,     // 1, 2, 4, 8 clocks
    parameter int ParameterGuard    = 0,     // [0, 8], for splines
    parameter int Networks          = 1,     // 1 steps by the networks, 0 by their program
    parameter int MultiplierForm    = 0,     // 0 portable, 1 ECP5, 2 UP5K
    parameter int SegmentQueueWords = 4096,  // [64, 65536], a power of two
    parameter int ProfileQueueWords = 4096   // [16, 4096], a power of two
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Words
    input  wire logic [15:0] digest_i,          // digest of their configuration
    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic [47:0] segment_data_i,
    input  wire logic        profile_valid_i,
    output logic             profile_ready_o,
    input  wire logic [47:0] profile_data_i,
    output logic             segment_leaves_o,  // a word left its queue
    output logic             profile_leaves_o,

    // Requests
    input  wire logic        sample_request_valid_i,
    output logic             sample_request_ready_o,
    input  wire logic        hold_i,
    input  wire logic [16:0] override_i,              // 65536 = 100 %
    input  wire logic        kill_i,                  // stops for good

    // Settings
    input wire logic [3:0] samples_per_tick_log2_i,
    input wire logic [31:0] hold_acceleration_i,  // [8, 2^31] second difference of time, 2^-32
    input wire logic [32:0] hold_slope_i,  // [hold_acceleration_i, 2^32] first difference
    input wire logic [31:0] stop_ticks_i,  // [1, 2^29) ticks of the profile that a stop needs

    // Samples, axis 0 in the low bits
    output logic                                                 sample_valid_o,
    input  wire logic                                            sample_ready_i,
    output logic      [            (3+AuxAxes)*PositionBits-1:0] sample_position_o,
    output logic      [(3+AuxAxes)*(PositionBits+GuardBits)-1:0] sample_fine_o,

    // Telemetry: path_valid_o once per sample, before it
    output logic        path_valid_o,
    output logic [47:0] path_ds_o,
    output logic [16:0] path_rate_o,
    output logic        path_active_o,    // a program was under way
    output logic [63:0] path_o,
    output logic        active_o,         // a program is under way
    output logic        underrun_o,       // sticky
    output logic        killed_o,
    output logic        standing_o,       // 1: at rest until a request has a target above 0
    output logic [ 7:0] fault_o,          // sticky
    output logic [15:0] empty_segments_o
);

  initial if (Splines < 0 || Splines > 1) $fatal(1, "Splines must be 0 or 1");

  localparam int Room = (SampleInterval == 8) ? 16 : (SampleInterval == 4) ? 32 : 128;

  logic rst_n;
  reset_stretcher u_reset (
      .clk_i,
      .rst_ni,
      .rst_no(rst_n)
  );

  logic segment_ready;
  logic profile_ready;
  assign segment_ready_o = segment_ready && rst_n;
  assign profile_ready_o = profile_ready && rst_n;
  logic core_segment_valid;
  logic core_segment_ready;
  logic [47:0] core_segment_data;
  logic word_valid;
  logic word_ready;
  logic [47:0] word;
  logic queued;
  assign segment_leaves_o = core_segment_valid && core_segment_ready;
  assign profile_leaves_o = word_valid && word_ready;
  logic take;
  logic [19:0] take_ticks;
  logic take_final;
  logic present_final;
  logic signed [21:0] present_ticks;
  logic [4:0] started;
  logic [31:0] stop_ticks;
  logic hold;
  logic may_begin;
  word_streams #(
      .CoefBits(CoefBits),
      .FineBits(PositionBits + GuardBits),
      .AuxAxes(AuxAxes),
      .Splines(Splines),
      .SegmentQueueWords(SegmentQueueWords),
      .ProfileQueueWords(ProfileQueueWords)
  ) u_words (
      .clk_i,
      .rst_ni(rst_n),
      .digest_i,
      .segment_valid_i,
      .segment_ready_o(segment_ready),
      .segment_data_i,
      .profile_valid_i,
      .profile_ready_o(profile_ready),
      .profile_data_i,
      .segment_valid_o(core_segment_valid),
      .segment_ready_i(core_segment_ready),
      .segment_data_o(core_segment_data),
      .profile_valid_o(word_valid),
      .profile_ready_i(word_ready),
      .profile_data_o(word),
      .queued_o(queued),
      .take_i(take),
      .take_ticks_i(take_ticks),
      .take_final_i(take_final),
      .active_i(active_o),
      .present_final_i(present_final),
      .present_ticks_i(present_ticks),
      .started_i(started),
      .stop_ticks_i(stop_ticks),
      .hold_o(hold),
      .begin_o(may_begin),
      .underrun_o,
      .fault_o(fault_o[5:0])
  );

  // Rates of time from requests
  logic tick_taken;
  logic sent;
  logic wanted;
  logic [3:0] samples_per_tick_log2;
  logic scaled;
  logic steady;
  logic passed;
  logic [20:0] due;
  logic step_valid;
  logic step_ready;
  logic [43:0] step;
  logic rate_valid;
  logic rate_ready;
  logic [16:0] rate;
  logic held;
  rate_generator #(
      .Room(Room)
  ) u_rate (
      .clk_i,
      .rst_ni(rst_n),
      .samples_per_tick_log2_i,
      .hold_acceleration_i,
      .hold_slope_i,
      .stop_ticks_i,
      .active_i(active_o),
      .queued_i(queued),
      .samples_per_tick_log2_o(samples_per_tick_log2),
      .stop_ticks_o(stop_ticks),
      .settings_fault_o(fault_o[6]),
      .request_valid_i(sample_request_valid_i),
      .request_ready_o(sample_request_ready_o),
      .kill_i,
      .hold_i,
      .underrun_i(hold),
      .override_i,
      .killed_o,
      .standing_o,
      .rate_valid_o(rate_valid),
      .rate_ready_i(rate_ready),
      .rate_o(rate),
      .held_o(held),
      .scaled_o(scaled),
      .steady_o(steady),
      .passed_o(passed),
      .due_i(due),
      .step_valid_i(step_valid),
      .step_ready_o(step_ready),
      .step_i(step),
      .tick_taken_i(tick_taken),
      .started_o(started),
      .sent_i(sent),
      .wanted_o(wanted),
      .leaves_i(sample_valid_o && sample_ready_i)
  );

  // Path increments from ticks
  logic ds_valid;
  logic [47:0] ds;
  logic [16:0] ds_rate;
  logic ds_active;
  path_generator #(
      .Interval(SampleInterval),
      .MultiplierForm(MultiplierForm)
  ) u_path (
      .clk_i,
      .rst_ni(rst_n),
      .word_valid_i(word_valid),
      .word_ready_o(word_ready),
      .word_i(word),
      .queued_i(queued),
      .begin_i(may_begin),
      .rate_valid_i(rate_valid),
      .rate_ready_o(rate_ready),
      .rate_i(rate),
      .held_i(held),
      .tick_taken_o(tick_taken),
      .scaled_i(scaled),
      .steady_i(steady),
      .passed_i(passed),
      .due_o(due),
      .step_valid_o(step_valid),
      .step_ready_i(step_ready),
      .step_o(step),
      .ds_valid_o(ds_valid),
      .ds_o(ds),
      .ds_rate_o(ds_rate),
      .ds_active_o(ds_active),
      .piece_take_o(take),
      .active_o,
      .last_o(present_final),
      .ticks_left_o(present_ticks),
      .next_ticks_o(take_ticks),
      .next_final_o(take_final)
  );

  // Samples' shares from increments, and the path
  logic move_valid;
  logic move_ready;
  logic [47:0] move_ds;
  logic [17:0] move_rate;
  path_shares #(
      .Room(Room)
  ) u_shares (
      .clk_i,
      .rst_ni(rst_n),
      .samples_per_tick_log2_i(samples_per_tick_log2),
      .tick_valid_i(ds_valid),
      .tick_ds_i(ds),
      .tick_rate_i({ds_active, ds_rate}),
      .wanted_i(wanted),
      .sent_o(sent),
      .sample_valid_o(move_valid),
      .sample_ready_i(move_ready),
      .sample_ds_o(move_ds),
      .sample_rate_o(move_rate),
      .path_valid_o,
      .path_ds_o,
      .path_rate_o({path_active_o, path_rate_o}),
      .path_o
  );

  // A bound for invalid words: a sample comes, or this count is up.
  logic [13:0] patience_q;
  logic waits;
  assign waits = move_rate[17] && move_valid && !move_ready && !sample_valid_o;
  assign fault_o[7] = patience_q[13];
  always_ff @(posedge clk_i) begin
    if (!rst_n) patience_q <= '0;
    else if (!patience_q[13]) patience_q <= waits ? patience_q + 1'b1 : '0;
  end

  // Curve
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
      .Networks(Networks),
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

endmodule
`default_nettype wire
