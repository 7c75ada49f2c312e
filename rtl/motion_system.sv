// SPDX-License-Identifier: Apache-2.0
// A board's motion: words and settings in through registers, step and direction pins out.
//   requests -> register_file -> words, settings -> motion_interpolator -> samples
//                  ^ v                                    ^ one per period   v
//               machine_state <- faults <---------------- step_generator -> pins
// A sample is taken every 2^PeriodLog2 clocks; SamplesAhead are requested before they are due, in
// position mode from rtl/bus/position_buffer.sv. Requests: rtl/bus/register_file.sv; after a reset
// nothing is enabled, and what a host writes is in sysc/wire/README.md.
//
//   clock             0       1       2       3       4
//   estop_i, limit_i  1
//   .. synchronised                   1
//   step_o                                    low: of all axes; of that axis
//   enable_o, step_o                          0       low: of the other axes
`default_nettype none
module motion_system #(
    parameter int Build             = 2,     // 0 parallel, 2 the engine
    parameter int Order             = 6,     // [2, 12]
    parameter int CoefBits          = 36,    // [18, 36]
    parameter int PositionBits      = 32,    // [16, 32]
    parameter int GuardBits         = 10,    // [2, 12]
    parameter int AuxAxes           = 0,     // [0, 6]
    parameter int Splines           = 1,     // 0, 1
    parameter int Mode              = 1,     // 0 series, 1 polynomial
    parameter int SampleInterval    = 8,     // 1, 2, 4, 8 clocks, with Build 0
    parameter int Networks          = 1,     // 1, and with Build 0 0: rtl/motion_interpolator.sv
    parameter int MultiplierForm    = 0,     // 0 portable, 1 ECP5, 2 UP5K
    parameter int Table             = 0,     // [0, 1023] of a further curve: ref/curves
    parameter int SegmentQueueWords = 1024,  // [64, 65536], a power of two
    parameter int ProfileQueueWords = 1024,  // [16, 4096], a power of two
    parameter int ScaleBits         = 44,    // [40, 56], with Build 2 [40, 45]
    parameter int PeriodLog2        = 13,    // [6, 20], with Build 2 [12, 13]
    parameter int TimeBits          = 12,    // [4, 16]
    parameter int SamplesAhead      = 4,     // [1, 15]; Build 2 has 15
    parameter int Galvo             = 0,     // 1: frames of scan heads too, with Build 0
    parameter int SampleBufferWords = 512,   // [32, 4096], a power of two; for position mode
    parameter int ClockHertz        = 0,     // clock of the CLOCK register, Hz
    parameter int Encoders          = 0,     // [0, 15] 0: none; rtl/pulse/glitch_filter.sv
    parameter int Outputs           = 0,     // 0: none; rtl/output/path_outputs.sv
    parameter int Shaper            = 0,     // 0: none; rtl/pulse/input_shaper.sv
    parameter     Program           = "",    // files of Build 2: scripts/microcode.sh
    parameter     Data              = ""
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic                 valid_i,
    input  wire logic                 write_i,
    input  wire logic [          6:0] word_i,
    input  wire logic [         31:0] data_i,
    output logic                      done_o,
    output logic                      error_o,
    output logic      [         31:0] data_o,
    // Streams of words, beside those of registers: rtl/bus/word_sources.sv
    input  wire logic                 segment_valid_i,
    output logic                      segment_ready_o,
    input  wire logic [         47:0] segment_data_i,
    input  wire logic                 profile_valid_i,
    output logic                      profile_ready_o,
    input  wire logic [         47:0] profile_data_i,
    input  wire logic                 estop_i,
    input  wire logic [3+AuxAxes-1:0] limit_i,
    input  wire logic                 probe_i,
    input  wire logic [3+AuxAxes-1:0] home_i,
    input  wire logic [3+AuxAxes-1:0] encoder_a_i,
    input  wire logic [3+AuxAxes-1:0] encoder_b_i,
    output logic      [3+AuxAxes-1:0] step_o,
    output logic      [3+AuxAxes-1:0] direction_o,
    output logic                      enable_o,
    output logic      [          7:0] output_o,
    output logic                      pwm_o,
    output logic                      galvo_clock_o,
    output logic                      galvo_sync_o,
    output logic      [          2:0] galvo_data_o
);
  localparam int Axes = 3 + AuxAxes;
  localparam int FineBits = PositionBits + GuardBits;
  localparam int Capability = system_pkg::capability(
      Axes, PeriodLog2, Build, Splines, Encoders, Outputs
  ) + system_pkg::memories(
      SegmentQueueWords, ProfileQueueWords, SampleBufferWords
  );
  localparam int Core = system_pkg::core(Order, Mode, CoefBits, PositionBits, GuardBits, Table);
  localparam logic [15:0] BoardDigest = system_pkg::digest(Capability, Core, ClockHertz);
  localparam int Ahead = (Build == 2) ? 15 : SamplesAhead;  // samples_ahead() of hls/clocks.hpp
  logic [16:0] override_rate, rate;
  logic [15:0] watchdog, digest;
  logic [3:0] samples_per_tick_log2, scale_axis, steps_axis, position_axis, fault_axis;
  logic [31:0] hold_acceleration, stop_ticks;
  logic [32:0] hold_slope, setting;
  logic [TimeBits-1:0] steplen, stepspace, dirsetup, dirhold;
  logic [Axes-1:0] step_inverted, direction_inverted, limit_masked;
  logic [ScaleBits-1:0] scale;
  logic segment_valid, segment_ready, profile_valid, profile_ready, position_write, position_ready;
  logic [47:0] register_word;
  logic control_asked, control_write, control_ready, state_write, reference_write, reference_ready;
  logic [Axes-1:0] limit, referenced, uncertain, overrun, refused, reference_axes, homed;
  logic caught, encoder, following, tick, late, estop, shaper_write, settled;
  logic scale_write, probe_write, homed_write, note_ready, kept_ready, setting_next, path_changes;
  logic [31:0] command, state, room, samples, outputs, steps, note_data, kept;
  logic [63:0] path;
  logic [6:0] note_word, kept_word, setting_word;
  register_file #(
      .Axes      (Axes),
      .ScaleBits (ScaleBits),
      .TimeBits  (TimeBits),
      .Capability(Capability),
      .Core      (Core),
      .Widths    (system_pkg::widths(TimeBits, ScaleBits, Ahead, Shaper)),
      .ClockHertz(ClockHertz)
  ) u_registers (
      .clk_i,
      .rst_ni,
      .valid_i,
      .write_i,
      .word_i,
      .data_i,
      .done_o,
      .error_o,
      .data_o,
      .override_o(override_rate),
      .watchdog_o(watchdog),
      .samples_per_tick_log2_o(samples_per_tick_log2),
      .hold_acceleration_o(hold_acceleration),
      .hold_slope_o(hold_slope),
      .stop_ticks_o(stop_ticks),
      .digest_o(digest),
      .steplen_o(steplen),
      .stepspace_o(stepspace),
      .dirsetup_o(dirsetup),
      .dirhold_o(dirhold),
      .step_inverted_o(step_inverted),
      .direction_inverted_o(direction_inverted),
      .limit_masked_o(limit_masked),
      .off_i(!enable_o),
      .scale_write_o(scale_write),
      .scale_axis_o(scale_axis),
      .scale_o(scale),
      .segment_valid_o(segment_valid),
      .segment_ready_i(segment_ready),
      .profile_valid_o(profile_valid),
      .profile_ready_i(profile_ready),
      .motion_word_o(register_word),
      .sample_valid_o(position_write),
      .sample_ready_i(position_ready),
      .control_asked_o(control_asked),
      .control_write_o(control_write),
      .control_ready_i(control_ready),
      .state_write_o(state_write),
      .reference_write_o(reference_write),
      .reference_ready_i(reference_ready),
      .probe_write_o(probe_write),
      .homed_write_o(homed_write),
      .shaper_write_o(shaper_write),
      .command_o(command),
      .state_i(state),
      .axes_i(system_pkg::axes(9'(referenced), 9'(uncertain), 9'(limit))),
      .room_i(room),
      .samples_i(samples),
      .outputs_i(outputs),
      .path_i(path),
      .rate_i(rate),
      .path_changes_i(path_changes),
      .steps_axis_o(steps_axis),
      .steps_i(steps),
      .note_ready_o(note_ready),
      .note_word_i(note_word),
      .note_data_i(note_data),
      .kept_word_i(kept_word),
      .kept_o(kept),
      .kept_ready_o(kept_ready),
      .read_next_i(setting_next),
      .read_word_i(setting_word),
      .setting_o(setting)
  );
  logic hold, ends, keeps, empty, begins, active, standing, underrun, words, positions;
  logic [7:0] motion_fault;
  logic [Axes*FineBits-1:0] sample;
  logic [FineBits-1:0] position;
  logic sample_valid, sample_ready, sample_taken, by_position, queued, word_taken;
  logic [4:0] rates_read;
  logic [pulse_pkg::StepFraction+PeriodLog2+3:0] rates;
  logic [2*Axes-1:0] step_counts;
  machine_state #(
      .Axes(Axes)
  ) u_state (
      .clk_i,
      .rst_ni,
      .control_asked_i(control_asked),
      .control_write_i(control_write),
      .control_ready_o(control_ready),
      .state_write_i(state_write),
      .reference_write_i(reference_write),
      .reference_ready_o(reference_ready),
      .homed_write_i(homed_write),
      .command_i(command),
      .write_i(done_o && write_i),
      .error_i(error_o),
      .watchdog_i(watchdog),
      .state_o(state),
      .homed_o(homed),
      .caught_i(caught),
      .active_i(active),
      .standing_i(standing && settled),
      .underrun_i(underrun),
      .motion_fault_i(motion_fault),
      .word_i(word_taken),
      .offered_i(sample_valid),
      .empty_i(empty),
      .sample_i(sample_taken),
      .hold_o(hold),
      .ends_o(ends),
      .keeps_o(keeps),
      .words_o(words),
      .begins_o(begins),
      .position_o(by_position),
      .samples_o(positions),
      .queued_i(queued || !settled),
      .tick_i(tick),
      .estop_i(estop),
      .limit_i(limit & ~limit_masked),
      .referenced_i(referenced),
      .uncertain_i(uncertain),
      .overrun_i(overrun != '0),
      .refused_i(refused != '0),
      .late_i(late),
      .encoder_i(encoder),
      .following_i(following),
      .fault_axis_i(fault_axis),
      .reference_o(reference_axes),
      .enable_o
  );
  assign output_o = outputs[31:registers_pkg::OutputsBitsLow];
  machine_inputs #(
      .Axes(Axes),
      .Encoders(Encoders)
  ) u_inputs (
      .clk_i,
      .rst_ni,
      .probe_i,
      .home_i,
      .encoder_a_i,
      .encoder_b_i,
      .write_i(probe_write),
      .command_i(command[5:0]),
      .homed_i(homed),
      .caught_o(caught),
      .steps_i(steps),
      .path_i(path[47:16]),
      .path_changes_i(path_changes),
      .note_ready_i(note_ready),
      .note_word_o(note_word),
      .note_data_o(note_data),
      .word_i,
      .kept_word_o(kept_word),
      .kept_i(kept),
      .kept_ready_i(kept_ready),
      .step_counts_i(step_counts),
      .referenced_i(referenced),
      .encoder_o(encoder),
      .following_o(following),
      .fault_axis_o(fault_axis)
  );
  sample_sources #(
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
      .Table(Table),
      .SegmentQueueWords(SegmentQueueWords),
      .ProfileQueueWords(ProfileQueueWords),
      .SamplesAhead(Ahead),
      .SampleBufferWords(SampleBufferWords),
      .PeriodLog2(PeriodLog2),
      .Outputs(Outputs),
      .Shaper(Shaper),
      .Program(Program),
      .Data(Data)
  ) u_sources (
      .clk_i,
      .rst_ni,
      .digest_i((Build == 2) ? BoardDigest : digest ^ BoardDigest),
      .words_i(words),
      .segment_valid_i(segment_valid),
      .segment_ready_o(segment_ready),
      .profile_valid_i(profile_valid),
      .profile_ready_o(profile_ready),
      .word_i(register_word),
      .segment_stream_valid_i(segment_valid_i),
      .segment_stream_ready_o(segment_ready_o),
      .segment_stream_word_i(segment_data_i),
      .profile_stream_valid_i(profile_valid_i),
      .profile_stream_ready_o(profile_ready_o),
      .profile_stream_word_i(profile_data_i),
      .positions_i(positions),
      .position_valid_i(position_write),
      .position_ready_o(position_ready),
      .position_i(command),
      .taken_o(word_taken),
      .room_o(room),
      .samples_o(samples),
      .queued_o(queued),
      .hold_i(hold),
      .override_i(override_rate),
      .samples_per_tick_log2_i(samples_per_tick_log2),
      .hold_acceleration_i(hold_acceleration),
      .hold_slope_i(hold_slope),
      .stop_ticks_i(stop_ticks),
      .setting_next_o(setting_next),
      .setting_word_o(setting_word),
      .setting_i(setting),
      .ends_i(ends),
      .keeps_i(keeps),
      .empty_o(empty),
      .sample_valid_o(sample_valid),
      .sample_ready_i(sample_ready),
      .sample_taken_o(sample_taken),
      .sample_o(sample),
      .axis_i(position_axis),
      .position_o(position),
      .off_i(!enable_o),
      .reference_i(reference_axes),
      .rates_read_i(rates_read),
      .rates_o(rates),
      .drawn_i(tick),
      .outputs_o(outputs),
      .pwm_o,
      .shaper_write_i(shaper_write),
      .path_rate_o(rate),
      .path_o(path),
      .path_changes_o(path_changes),
      .active_o(active),
      .underrun_o(underrun),
      .standing_o(standing),
      .fault_o(motion_fault)
  );
  motion_pins #(
      .Axes(Axes),
      .FineBits(FineBits),
      .ScaleBits(ScaleBits),
      .PeriodLog2(PeriodLog2),
      .TimeBits(TimeBits),
      .Galvo(Galvo),
      .Rates((Build == 2) ? 1 : 0),
      .Shaper(Shaper)
  ) u_pins (
      .clk_i,
      .rst_ni,
      .scale_write_i(scale_write),
      .scale_axis_i(scale_axis),
      .scale_i(scale),
      .steplen_i(steplen),
      .stepspace_i(stepspace),
      .dirsetup_i(dirsetup),
      .dirhold_i(dirhold),
      .step_inverted_i(step_inverted),
      .direction_inverted_i(direction_inverted),
      .sample_valid_i(sample_valid),
      .sample_ready_o(sample_ready),
      .sample_i(sample),
      .by_axis_i(by_position),
      .axis_o(position_axis),
      .position_i(position),
      .rates_read_o(rates_read),
      .rates_i(rates),
      .shaper_write_i(shaper_write),
      .shaper_i(command[23:0]),
      .settled_o(settled),
      .begins_i(begins),
      .reference_i(reference_axes),
      .estop_i,
      .limit_i,
      .estop_o(estop),
      .limit_o(limit),
      .limit_masked_i(limit_masked),
      .stop_i(!enable_o),
      .step_o,
      .direction_o,
      .galvo_clock_o,
      .galvo_sync_o,
      .galvo_data_o,
      .steps_axis_i(steps_axis),
      .steps_o(steps),
      .step_counts_o(step_counts),
      .tick_o(tick),
      .referenced_o(referenced),
      .uncertain_o(uncertain),
      .overrun_o(overrun),
      .refused_o(refused),
      .late_o(late)
  );
endmodule
`default_nettype wire
