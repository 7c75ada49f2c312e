// SPDX-License-Identifier: Apache-2.0
// motion_system behind a stream of bytes: frames in, answers out (rtl/line/frame_port.sv). The
// board carries the bytes: by rtl/line/uart_line.sv, a FIFO, a socket.
`default_nettype none
module motion_board #(
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
    parameter int ScaleBits         = 44,    // [40, 56]
    parameter int PeriodLog2        = 13,    // [6, 20]
    parameter int TimeBits          = 12,    // [4, 16]
    parameter int SamplesAhead      = 4,     // [1, 15]; Build 2 has 15
    parameter int Galvo             = 0,     // 0, 1
    parameter int SampleBufferWords = 512,   // [32, 4096], a power of two; for position mode
    parameter int ClockHertz        = 0,     // clock of the CLOCK register, Hz
    parameter int Encoders          = 0,     // [0, 15]
    parameter int Outputs           = 0,     // 0: none; rtl/output/path_outputs.sv
    parameter int Shaper            = 0,     // 0: none; rtl/pulse/input_shaper.sv
    parameter     Program           = "",    // files of Build 2: scripts/microcode.sh
    parameter     Data              = ""
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Bytes
    input  wire logic       byte_valid_i,
    output logic            byte_ready_o,
    input  wire logic [7:0] byte_i,
    output logic            byte_valid_o,
    input  wire logic       byte_ready_i,
    output logic      [7:0] byte_o,

    // Pins: rtl/motion_system.sv
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

  logic valid;
  logic write;
  logic [6:0] word;
  logic [31:0] data;
  logic done;
  logic [31:0] answer;
  frame_port u_frames (
      .clk_i,
      .rst_ni,
      .byte_valid_i,
      .byte_ready_o,
      .byte_i,
      .byte_valid_o,
      .byte_ready_i,
      .byte_o,
      .valid_o(valid),
      .write_o(write),
      .word_o (word),
      .data_o (data),
      .done_i (done),
      .data_i (answer)
  );
  logic unused_error;
  logic unused_segment_ready;
  logic unused_profile_ready;
  motion_system #(
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
      .ScaleBits(ScaleBits),
      .PeriodLog2(PeriodLog2),
      .TimeBits(TimeBits),
      .SamplesAhead(SamplesAhead),
      .Galvo(Galvo),
      .SampleBufferWords(SampleBufferWords),
      .ClockHertz(ClockHertz),
      .Encoders(Encoders),
      .Outputs(Outputs),
      .Shaper(Shaper),
      .Program(Program),
      .Data(Data)
  ) u_system (
      .clk_i,
      .rst_ni,
      .valid_i(valid),
      .write_i(write),
      .word_i(word),
      .data_i(data),
      .done_o(done),
      .error_o(unused_error),
      .data_o(answer),
      .segment_valid_i(1'b0),
      .segment_ready_o(unused_segment_ready),
      .segment_data_i(48'd0),
      .profile_valid_i(1'b0),
      .profile_ready_o(unused_profile_ready),
      .profile_data_i(48'd0),
      .estop_i,
      .limit_i,
      .probe_i,
      .home_i,
      .encoder_a_i,
      .encoder_b_i,
      .step_o,
      .direction_o,
      .enable_o,
      .output_o,
      .pwm_o,
      .galvo_clock_o,
      .galvo_sync_o,
      .galvo_data_o
  );

endmodule
`default_nettype wire
