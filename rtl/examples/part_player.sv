// SPDX-License-Identifier: Apache-2.0
// Plays a part from two memories: the minimum design around motion_interpolator.
// The files are those of `curvecore words PART -o DIR --set SampleInterval=8`; the settings stand
// in DIR/words.json.
//
//   segments.hex, profile.hex -> motion_interpolator <- a request every SampleClocks clocks
//
// valid_o is high for one clock with each position. Past the end they stay.
`default_nettype none
module part_player #(
    parameter     SegmentFile        = "segments.hex",
    parameter     ProfileFile        = "profile.hex",
    parameter int SegmentWords       = 17,              // lines of SegmentFile
    parameter int ProfileWords       = 5,               // lines of ProfileFile
    parameter int SampleClocks       = 2500,            // 100 us at 25 MHz
    parameter int SamplesPerTickLog2 = 0,               // words.json: samples_per_tick_log2
    parameter int HoldAcceleration   = 1,               // words.json: hold_acceleration
    parameter int HoldSlope          = 1,               // words.json: hold_slope
    parameter int StopTicks          = 1,               // words.json: stop_ticks
    parameter int Digest             = 0                // words.json: digest
) (
    input  wire logic        clk_i,
    input  wire logic        rst_ni,
    output logic             valid_o,
    output logic      [95:0] position_o  // X, Y, Z: 32 bits each, X in the low ones
);

  logic [47:0] segments[SegmentWords];
  logic [47:0] profile [ProfileWords];
  initial $readmemh(SegmentFile, segments);
  initial $readmemh(ProfileFile, profile);

  int   segment_q;
  int   profile_q;
  int   wait_q;
  logic segment_ready;
  logic profile_ready;
  logic request_ready;
  logic segment_valid;
  logic profile_valid;
  logic request;
  logic primed_q;
  assign segment_valid = segment_q < SegmentWords;
  assign profile_valid = profile_q < ProfileWords;
  assign request = wait_q == 0;

  logic segments_in;
  logic profile_in;
  assign segments_in = !segment_valid || (segment_q != 0 && !segment_ready);
  assign profile_in  = !profile_valid || (profile_q != 0 && !profile_ready);

  // Time starts once the queues are full: an underrun would stop on the path.
  always_ff @(posedge clk_i) begin
    if (segment_valid && segment_ready) segment_q <= segment_q + 1;
    if (profile_valid && profile_ready) profile_q <= profile_q + 1;
    if (segments_in && profile_in) primed_q <= 1'b1;
    if (primed_q && !request) wait_q <= wait_q - 1;
    if (request && request_ready) wait_q <= SampleClocks - 1;
    if (!rst_ni) begin
      segment_q <= 0;
      profile_q <= 0;
      primed_q <= 1'b0;
      wait_q <= SampleClocks - 1;
    end
  end

  // Outputs for telemetry and faults may stay open.
  motion_interpolator #(
      .Splines       (1),
      .SampleInterval(8)
  ) u_motion (
      .clk_i,
      .rst_ni,
      .digest_i(16'(Digest)),
      .segment_valid_i(segment_valid),
      .segment_ready_o(segment_ready),
      .segment_data_i(segments[segment_q]),
      .profile_valid_i(profile_valid),
      .profile_ready_o(profile_ready),
      .profile_data_i(profile[profile_q]),
      .sample_request_valid_i(request),
      .sample_request_ready_o(request_ready),
      .hold_i(1'b0),
      .override_i(17'd65536),
      .kill_i(1'b0),
      .samples_per_tick_log2_i(4'(SamplesPerTickLog2)),
      .hold_acceleration_i(32'(HoldAcceleration)),
      .hold_slope_i(33'(HoldSlope)),
      .stop_ticks_i(32'(StopTicks)),
      .sample_valid_o(valid_o),
      .sample_ready_i(1'b1),
      .sample_position_o(position_o)
  );

endmodule
