// SPDX-License-Identifier: Apache-2.0
// motion_system for systems on a chip: registers behind AXI4-Lite (rtl/bus/axi_lite_port.sv), words
// by two AXI4-Streams, which wait where a register would refuse. A word is the low 48 bits of
// TDATA; segments and pieces: hls/words.hpp.
//
// A host that writes CONTROL.flush, or finds the machine off, ends its streams first: later words
// would be the middle of a program, which is a fault.
`default_nettype none
module motion_axi #(
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
    parameter int SampleBufferWords = 512,   // [32, 4096], a power of two; for position mode
    parameter int Galvo             = 0,     // 0, 1
    parameter int ClockHertz        = 0,     // clock of the CLOCK register, Hz
    parameter int Encoders          = 0,     // [0, 15]
    parameter int Outputs           = 0,     // 0: none; rtl/output/path_outputs.sv
    parameter int Shaper            = 0,     // 0: none; rtl/pulse/input_shaper.sv
    parameter     Program           = "",    // files of Build 2: scripts/microcode.sh
    parameter     Data              = ""
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // AXI4-Lite
    input  wire logic        awvalid_i,
    output logic             awready_o,
    input  wire logic [ 8:0] awaddr_i,
    input  wire logic        wvalid_i,
    output logic             wready_o,
    input  wire logic [31:0] wdata_i,
    input  wire logic [ 3:0] wstrb_i,
    output logic             bvalid_o,
    input  wire logic        bready_i,
    output logic      [ 1:0] bresp_o,
    input  wire logic        arvalid_i,
    output logic             arready_o,
    input  wire logic [ 8:0] araddr_i,
    output logic             rvalid_o,
    input  wire logic        rready_i,
    output logic      [31:0] rdata_o,
    output logic      [ 1:0] rresp_o,

    // AXI4-Streams of segments, and of pieces with their branches
    input  wire logic        segment_tvalid_i,
    output logic             segment_tready_o,
    input  wire logic [63:0] segment_tdata_i,
    input  wire logic        profile_tvalid_i,
    output logic             profile_tready_o,
    input  wire logic [63:0] profile_tdata_i,

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
  logic error;
  logic [31:0] answer;
  axi_lite_port u_port (
      .clk_i,
      .rst_ni,
      .awvalid_i,
      .awready_o,
      .awaddr_i,
      .wvalid_i,
      .wready_o,
      .wdata_i,
      .wstrb_i,
      .bvalid_o,
      .bready_i,
      .bresp_o,
      .arvalid_i,
      .arready_o,
      .araddr_i,
      .rvalid_o,
      .rready_i,
      .rdata_o,
      .rresp_o,
      .valid_o(valid),
      .write_o(write),
      .word_o (word),
      .data_o (data),
      .done_i (done),
      .error_i(error),
      .data_i (answer)
  );
  logic unused_upper;
  assign unused_upper = &{segment_tdata_i[63:48], profile_tdata_i[63:48]};
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
      .SampleBufferWords(SampleBufferWords),
      .Galvo(Galvo),
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
      .error_o(error),
      .data_o(answer),
      .segment_valid_i(segment_tvalid_i),
      .segment_ready_o(segment_tready_o),
      .segment_data_i(segment_tdata_i[47:0]),
      .profile_valid_i(profile_tvalid_i),
      .profile_ready_o(profile_tready_o),
      .profile_data_i(profile_tdata_i[47:0]),
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
