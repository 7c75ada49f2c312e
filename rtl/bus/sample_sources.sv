// SPDX-License-Identifier: Apache-2.0
// Samples for the step generator from two sources: programs, whose words come by registers or by
// streams, or positions of the host.
//
//   words     -> word_sources -> paced_motion ----> samples
//   positions ----------------> position_buffer -> .. axis by axis
//
// With Build 2 both are rates of the axes, in one ring: rtl/bus/paced_motion.sv.
//
// words_i or positions_i: only one of the two is taken, so samples have one source.
`default_nettype none
module sample_sources #(
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
    parameter int SegmentQueueWords = 1024,
    parameter int ProfileQueueWords = 1024,
    parameter int SamplesAhead      = 4,
    parameter int SampleBufferWords = 512,
    parameter int PeriodLog2        = 13,
    parameter int Outputs           = 0,
    parameter int Shaper            = 0,
    parameter     Program           = "",
    parameter     Data              = ""
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Words of registers, and of streams: rtl/bus/word_sources.sv
    input  wire logic [15:0] digest_i,                // rtl/motion_interpolator.sv
    input  wire logic        words_i,
    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic        profile_valid_i,
    output logic             profile_ready_o,
    input  wire logic [47:0] word_i,
    input  wire logic        segment_stream_valid_i,
    output logic             segment_stream_ready_o,
    input  wire logic [47:0] segment_stream_word_i,
    input  wire logic        profile_stream_valid_i,
    output logic             profile_stream_ready_o,
    input  wire logic [47:0] profile_stream_word_i,

    // Positions: rtl/bus/position_buffer.sv
    input  wire logic        positions_i,
    input  wire logic        position_valid_i,
    output logic             position_ready_o,
    input  wire logic [31:0] position_i,

    output logic        taken_o,    // any of these was taken
    output logic [31:0] room_o,     // contents of the registers ROOM and SAMPLES
    output logic [31:0] samples_o,
    output logic        queued_o,   // samples of the host wait

    // Time: rtl/motion_interpolator.sv
    input wire logic        hold_i,
    input wire logic [16:0] override_i,
    input wire logic [ 3:0] samples_per_tick_log2_i,
    input wire logic [31:0] hold_acceleration_i,
    input wire logic [32:0] hold_slope_i,
    input wire logic [31:0] stop_ticks_i,

    // .. and of Build 2: rtl/bus/paced_motion.sv
    output logic             setting_next_o,
    output logic      [ 6:0] setting_word_o,
    input  wire logic [32:0] setting_i,

    // Samples: all axes of a program's, one axis' position of the host's
    input  wire logic                                            ends_i,
    output logic                                                 empty_o,
    output logic                                                 sample_valid_o,
    input  wire logic                                            sample_ready_i,
    output logic                                                 sample_taken_o,
    output logic      [(3+AuxAxes)*(PositionBits+GuardBits)-1:0] sample_o,
    input  wire logic [                                     3:0] axis_i,
    output logic      [              PositionBits+GuardBits-1:0] position_o,

    // Rates, with Build 2: rtl/bus/paced_motion.sv
    input  wire logic                                          off_i,
    input  wire logic [                         3+AuxAxes-1:0] reference_i,
    input  wire logic [                                   4:0] rates_read_i,
    output logic      [pulse_pkg::StepFraction+PeriodLog2+3:0] rates_o,

    // Outputs: rtl/output/path_outputs.sv
    input  wire logic        keeps_i,
    input  wire logic        drawn_i,
    output logic      [31:0] outputs_o,      // contents of the register OUTPUTS
    output logic             pwm_o,
    input  wire logic        shaper_write_i, // position_i is a word of the shaper

    // Telemetry
    output logic [16:0] path_rate_o,
    output logic [63:0] path_o,
    output logic        path_changes_o,
    output logic        active_o,
    output logic        underrun_o,
    output logic        standing_o,
    output logic [ 7:0] fault_o
);

  logic segment_valid;
  logic segment_ready;
  logic profile_valid;
  logic profile_ready;
  logic [47:0] word;
  word_sources u_words (
      .words_i,
      .segment_valid_i,
      .segment_ready_o,
      .profile_valid_i,
      .profile_ready_o,
      .word_i,
      .segment_stream_valid_i,
      .segment_stream_ready_o,
      .segment_stream_word_i,
      .profile_stream_valid_i,
      .profile_stream_ready_o,
      .profile_stream_word_i,
      .segment_valid_o(segment_valid),
      .segment_ready_i(segment_ready),
      .profile_valid_o(profile_valid),
      .profile_ready_i(profile_ready),
      .word_o(word)
  );

  logic [ 7:0] bits;
  logic [11:0] power;
  assign outputs_o = (32'(bits) << registers_pkg::OutputsBitsLow) |
      (32'(power) << registers_pkg::OutputsPowerLow);
  logic motion_empty;
  logic motion_valid;
  logic motion_taken;
  logic [3:0] rate_axis;
  logic [PositionBits-1:0] position;
  paced_motion #(
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
      .SamplesAhead(SamplesAhead),
      .PeriodLog2(PeriodLog2),
      .Outputs(Outputs),
      .Shaper(Shaper),
      .Program(Program),
      .Data(Data)
  ) u_motion (
      .clk_i,
      .rst_ni,
      .digest_i,
      .segment_valid_i(segment_valid),
      .segment_ready_o(segment_ready),
      .profile_valid_i(profile_valid),
      .profile_ready_o(profile_ready),
      .word_i(word),
      .segment_room_o(room_o[registers_pkg::RoomSegmentLow+:16]),
      .profile_room_o(room_o[registers_pkg::RoomProfileLow+:16]),
      .hold_i,
      .override_i,
      .samples_per_tick_log2_i,
      .hold_acceleration_i,
      .hold_slope_i,
      .stop_ticks_i,
      .setting_next_o,
      .setting_word_o,
      .setting_i,
      .ends_i,
      .empty_o(motion_empty),
      .sample_valid_o(motion_valid),
      .sample_ready_i,
      .sample_taken_o(motion_taken),
      .sample_o,
      .off_i,
      .reference_i,
      .by_host_i(queued_o),
      .axis_o(rate_axis),
      .position_i(position),
      .rates_read_i,
      .rates_o,
      .keeps_i,
      .drawn_i,
      .bits_o(bits),
      .power_o(power),
      .pwm_o,
      .delay_write_i(shaper_write_i && position_i[23:22] == 2'd3),
      .delay_i(position_i[8:0]),
      .path_rate_o,
      .path_o,
      .path_changes_o,
      .active_o,
      .underrun_o,
      .standing_o,
      .fault_o
  );

  logic buffer_ready;
  logic buffer_valid;
  position_buffer #(
      .Axes (3 + AuxAxes),
      .Bits (PositionBits),
      .Words(SampleBufferWords),
      .Form (MultiplierForm),
      .Holds((Build == 2 && MultiplierForm == 2) ? 0 : 1)  // or block RAM to engine is slowest
  ) u_positions (
      .clk_i,
      .rst_ni,
      .write_i(position_valid_i && positions_i),
      .ready_o(buffer_ready),
      .data_i(position_i[PositionBits-1:0]),
      .room_o(samples_o[registers_pkg::SamplesRoomLow+:16]),
      .queued_o(samples_o[registers_pkg::SamplesQueuedLow+:16]),
      .ends_i,
      .empty_i(empty_o),
      .valid_o(buffer_valid),
      .ready_i((Build == 2) ? motion_taken : sample_ready_i),
      .axis_i((Build == 2) ? rate_axis : axis_i),
      .position_o(position)
  );
  assign position_ready_o = buffer_ready && positions_i;
  assign position_o = {position, GuardBits'(0)};
  assign queued_o = samples_o[registers_pkg::SamplesQueuedLow+:16] != '0;

  assign taken_o = segment_valid && segment_ready || profile_valid && profile_ready ||
      position_valid_i && position_ready_o;
  assign sample_valid_o = motion_valid || (buffer_valid && Build != 2);
  assign sample_taken_o = (Build == 2) ? motion_taken : sample_valid_o && sample_ready_i;
  assign empty_o = motion_empty && !(buffer_valid && Build != 2);

endmodule
`default_nettype wire
