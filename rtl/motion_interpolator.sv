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
// While they stop time no program begins. kill_i is a permanent hold: killed_o rises at once,
// standing_o when the machine stands: at once between programs. While nothing is under way, first
// and from 16 ticks behind a program on, the rate is override_i at once, and 0 under a hold.
//
// Settings are taken while nothing is under way. With settings outside their ranges time does not
// run; they are reported when a program waits for them, and so is a change while one is under way.
//
//   samples per clock                    1 / SampleInterval, with Build 0
//   request to path increment, clocks    about 60; to sample: plus the core's
//   tick of time to tick, clocks         SampleInterval
//
// Build 2 makes ticks, samples and words in turn, in the clocks of hls/clocks.hpp; its programs are
// made for the parameters, by scripts/microcode.sh.
//
// A reset empties the queues.
//
// Word formats: hls/words.hpp.  Words are made for a digest, that of their configuration, which is
// in words.json; digest_i must equal it when a program's words begin to come, and words for another
// one do not enter.  A stream that starves is no fault: time stops while queued words still cover
// the stop, which underrun_o reports, and continues when they cover two, or a queue is full.  A
// program begins when its words cover as much.  So a program whose full queues do not cover a stop
// (stop_ticks_i + 10 ticks) cannot be drawn: fault.
//
// Faults are sticky until reset.  Those of words cut the streams: further words are taken and
// dropped, queued ones are drawn to a stop.
//
//   fault_o[0]  an invalid or altered segment word: lost, doubled, swapped, changed, foreign, out
//               of range, made for another configuration
//   fault_o[1]  a missing or repeated segment, or one that does not start where the last one ended
//   fault_o[2]  an invalid or altered profile word
//   fault_o[3]  a missing or repeated piece
//   fault_o[4]  segments and pieces of a program end apart, in path or ticks
//   fault_o[5]  a full queue does not cover a stop
//   fault_o[6]  invalid settings, or settings changed in motion: refused
//   fault_o[7]  no sample of a program for 2^13 clocks (Build 2: 2^17): invalid words, positions
//               cannot be trusted; Build 2: Program is for other parameters, or was changed
`default_nettype none
module motion_interpolator #(
    parameter int Build = 0,  // 0 parallel, 2 the engine
    parameter int Order = 6,  // [2, 12]
    parameter int CoefBits = 36,  // [18, 36]
    parameter int PositionBits = 32,  // [16, 32]
    parameter int GuardBits = 10,  // [2, 12]
    parameter int AuxAxes = 0,  // [0, 6]
    parameter int Splines = 0,  // 1: segments of splines too
    parameter int Mode = 0,  // 0 series, 1 polynomial
    parameter int Anchor = 1,  // 0, 1, for splines; 0 with Build 0 only
    parameter int SampleInterval = 1,  // 1, 2, 4, 8 clocks
    parameter int ParameterGuard = 0,  // [0, 8], for splines; above 0 with Build 0 only
    parameter int Networks = 1,  // 1 steps by the networks, 0, with Build 0, by a program
    parameter int MultiplierForm = 0,  // 0 portable, 1 ECP5, 2 UP5K
    parameter int Table = 0,  // [0, 1023]; with Build 2: number of a further curve's table
    parameter int SegmentQueueWords = 4096,  // [64, 65536], a power of two
    parameter int ProfileQueueWords = 4096,  // [16, 4096], a power of two
    parameter Program = "",  // files of Build 2: scripts/microcode.sh
    parameter Data = ""
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
    output logic             segment_leaves_o,  // a word left its queue, of Build 2 its entry
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

  initial if (Build < 0 || Build > 2) $fatal(1, "Build must be 0 or 2");
  initial
    if (Build == 1)
      $fatal(1, "Build 1 is a curve core alone, curve_interpolator_serial; Build 2 is as small");
  initial if (Splines < 0 || Splines > 1) $fatal(1, "Splines must be 0 or 1");
  initial if (Table < 0 || Table > 1023) $fatal(1, "Table must be in [0, 1023]");
  initial if (Build != 2 && Table != 0) $fatal(1, "Build %0d works with Table 0 only", Build);
  initial if (Build != 0 && Anchor != 1) $fatal(1, "Build %0d works with Anchor 1 only", Build);
  initial
    if (Build != 0 && ParameterGuard != 0)
      $fatal(1, "Build %0d works with ParameterGuard 0 only", Build);
  initial if (Build != 0 && Networks != 1) $fatal(1, "Build %0d works with Networks 1 only", Build);

  initial
    if (Build == 2 && (Program == "" || Data == ""))
      $fatal(1, "Build 2 needs Program and Data, files that scripts/microcode.sh makes");

  if (Build == 2) begin : g_engine
    localparam int Axes = 3 + AuxAxes;
    localparam int FineBits = PositionBits + GuardBits;
    logic [31:0] out;
    logic [ 1:0] unused_limb;
    logic [15:0] data;
    logic unused_scale_last, unused_setting_next, unused_path_changes;
    assign path_o[63:61] = '0;
    logic [15:0] unused_segment_room, unused_profile_room;
    logic [ 6:0] setting_word;
    logic [16:0] override_q;
    logic [32:0] setting_q;
    always_ff @(posedge clk_i) begin
      if (sample_request_ready_o) override_q <= override_i;
      case (setting_word)
        registers_pkg::Override:         setting_q <= {16'd0, override_q};
        registers_pkg::Timing:           setting_q <= {29'd0, samples_per_tick_log2_i};
        registers_pkg::HoldAcceleration: setting_q <= {1'b0, hold_acceleration_i};
        registers_pkg::HoldSlope:        setting_q <= hold_slope_i;
        registers_pkg::StopTicks:        setting_q <= {1'b0, stop_ticks_i};
        default:                         setting_q <= '0;
      endcase
    end
    engine_motion #(
        .Order(Order),
        .CoefBits(CoefBits),
        .PositionBits(PositionBits),
        .GuardBits(GuardBits),
        .AuxAxes(AuxAxes),
        .Splines(Splines),
        .Mode(Mode),
        .Table(Table),
        .MultiplierForm(MultiplierForm),
        .SegmentQueueWords(SegmentQueueWords),
        .ProfileQueueWords(ProfileQueueWords),
        .Program(Program),
        .Data(Data)
    ) u_motion (
        .clk_i,
        .rst_ni,
        .digest_i,
        .setting_next_o(unused_setting_next),
        .setting_word_o(setting_word),
        .setting_i(setting_q),
        .segment_valid_i,
        .segment_ready_o,
        .segment_data_i,
        .profile_valid_i,
        .profile_ready_o,
        .profile_data_i,
        .segment_leaves_o,
        .profile_leaves_o,
        .segment_room_o(unused_segment_room),
        .profile_room_o(unused_profile_room),
        .sample_request_valid_i,
        .sample_request_ready_o,
        .hold_i,
        .kill_i,
        .out_o(out),
        .limb_o(unused_limb),
        .data_o(data),
        .leaves_i(sample_valid_o && sample_ready_i),
        .awaited_i(!sample_valid_o && sample_ready_i),
        .position_waits_i(1'b0),
        .position_i(32'd0),
        .references_i(9'd0),
        .axis_i(4'd0),
        .scale_last_o(unused_scale_last),
        .path_valid_o,
        .path_ds_o,
        .path_rate_o,
        .path_active_o,
        .path_o(path_o[60:0]),
        .path_changes_o(unused_path_changes),
        .active_o,
        .underrun_o,
        .killed_o,
        .standing_o,
        .fault_o,
        .empty_segments_o
    );
    engine_samples #(
        .Axes(Axes),
        .FineBits(FineBits),
        .Places(16)
    ) u_samples (
        .clk_i,
        .rst_ni,
        .limb_i (out[engine_pkg::OutSample]),
        .whole_i(out[engine_pkg::OutSampleWhole]),
        .data_i (data),
        .valid_o(sample_valid_o),
        .ready_i(sample_ready_i),
        .data_o (sample_fine_o)
    );
    for (genvar axis = 0; axis < Axes; axis++) begin : g_axes  // rounded, ties upwards
      logic [PositionBits-1:0] whole;
      logic half;
      assign {whole, half} = sample_fine_o[axis*FineBits+GuardBits-1+:PositionBits+1];
      assign sample_position_o[axis*PositionBits+:PositionBits] = whole + PositionBits'(half);
    end
  end else begin : g_circuits
    path_interpolator #(
        .Order(Order),
        .CoefBits(CoefBits),
        .PositionBits(PositionBits),
        .GuardBits(GuardBits),
        .AuxAxes(AuxAxes),
        .Splines(Splines),
        .Mode(Mode),
        .Anchor(Anchor),
        .SampleInterval(SampleInterval),
        .ParameterGuard(ParameterGuard),
        .Networks(Networks),
        .MultiplierForm(MultiplierForm),
        .SegmentQueueWords(SegmentQueueWords),
        .ProfileQueueWords(ProfileQueueWords)
    ) u_motion (
        .clk_i,
        .rst_ni,
        .digest_i,
        .segment_valid_i,
        .segment_ready_o,
        .segment_data_i,
        .profile_valid_i,
        .profile_ready_o,
        .profile_data_i,
        .segment_leaves_o,
        .profile_leaves_o,
        .sample_request_valid_i,
        .sample_request_ready_o,
        .hold_i,
        .override_i,
        .kill_i,
        .samples_per_tick_log2_i,
        .hold_acceleration_i,
        .hold_slope_i,
        .stop_ticks_i,
        .sample_valid_o,
        .sample_ready_i,
        .sample_position_o,
        .sample_fine_o,
        .path_valid_o,
        .path_ds_o,
        .path_rate_o,
        .path_active_o,
        .path_o,
        .active_o,
        .underrun_o,
        .killed_o,
        .standing_o,
        .fault_o,
        .empty_segments_o
    );
  end

endmodule
`default_nettype wire
