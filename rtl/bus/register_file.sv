// SPDX-License-Identifier: Apache-2.0
// The registers of motion_system behind one request port, which every bus shell uses. Their
// meaning: hls/registers/registers.rdl.
//
//   clock       0        1        2
//   valid_i     request           until done_o
//   .._o                 writes
//   done_o                        1
//   error_o, data_o               of it, until the next one's
//
// Every request is answered in two clocks: a word without room is an error, not a wait. Only the
// first answer after a reset takes 2^7 clocks more, in which a memory gets its reset values.
// Settings are read from it, constants, notes (rtl/bus/probe_catch.sv), which wait for two clocks
// at most, and what is kept when PATH_LO is answered: the path of that clock, the rate of the one
// before. While they change, limb by limb in 4 clocks at most, requests wait.
//
// The programs of Build 2 read their settings there, too, and come first: a request that finds them
// reading takes up to 4 clocks more, a read 3, for they read in 3 clocks at most and leave 2 before
// they read or tell the path again. No write meets them, so they read whole words.
`default_nettype none
module register_file #(
    parameter int Axes       = 3,   // [1, 9]
    parameter int ScaleBits  = 44,  // [33, 56]
    parameter int TimeBits   = 12,  // [4, 16]
    parameter int Capability = 0,   // constants with these names
    parameter int Core       = 0,
    parameter int Widths     = 0,
    parameter int ClockHertz = 0
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Requests: valid_i and its operands stay until done_o
    input  wire logic        valid_i,
    input  wire logic        write_i,
    input  wire logic [ 6:0] word_i,   // address / 4
    input  wire logic [31:0] data_i,
    output logic             done_o,
    output logic             error_o,
    output logic      [31:0] data_o,

    // Settings
    output logic [        16:0] override_o,
    output logic [        15:0] watchdog_o,
    output logic [         3:0] samples_per_tick_log2_o,
    output logic [        31:0] hold_acceleration_o,
    output logic [        32:0] hold_slope_o,
    output logic [        31:0] stop_ticks_o,
    output logic [        15:0] digest_o,
    output logic [TimeBits-1:0] steplen_o,
    output logic [TimeBits-1:0] stepspace_o,
    output logic [TimeBits-1:0] dirsetup_o,
    output logic [TimeBits-1:0] dirhold_o,
    output logic [    Axes-1:0] step_inverted_o,
    output logic [    Axes-1:0] direction_inverted_o,
    output logic [    Axes-1:0] limit_masked_o,

    // Scales; like polarities, they change only while the drives are off
    input  wire logic                 off_i,
    output logic                      scale_write_o,
    output logic      [          3:0] scale_axis_o,
    output logic      [ScaleBits-1:0] scale_o,

    // Words of the motion
    output logic             segment_valid_o,
    input  wire logic        segment_ready_i,
    output logic             profile_valid_o,
    input  wire logic        profile_ready_i,
    output logic      [47:0] motion_word_o,

    // Positions of samples: command_o
    output logic      sample_valid_o,
    input  wire logic sample_ready_i,

    // Commands, with the written word
    output logic             control_asked_o,    // ready or not
    output logic             control_write_o,
    input  wire logic        control_ready_i,
    output logic             state_write_o,
    output logic             reference_write_o,
    input  wire logic        reference_ready_i,
    output logic             probe_write_o,
    output logic             homed_write_o,
    output logic             shaper_write_o,     // only while the drives are off
    output logic      [31:0] command_o,

    // Readable values
    input  wire logic [31:0] state_i,
    input  wire logic [31:0] axes_i,
    input  wire logic [31:0] room_i,
    input  wire logic [31:0] samples_i,
    input  wire logic [31:0] outputs_i,
    input  wire logic [63:0] path_i,
    input  wire logic [16:0] rate_i,
    input  wire logic        path_changes_i,  // path or rate: the next clock has parts of two
    output logic      [ 3:0] steps_axis_o,
    input  wire logic [31:0] steps_i,         // steps of axis_o

    // Notes: the new value of a word; in the same clock another word is read, and is there in the
    // next one
    output logic             note_ready_o,
    output logic             kept_ready_o,  // a word is read, not by programs
    input  wire logic [ 6:0] note_word_i,
    input  wire logic [31:0] note_data_i,
    input  wire logic [ 6:0] kept_word_i,
    output logic      [31:0] kept_o,

    // Programs: they read in the next clock; there a word, and a clock later what it says, of
    // HOLD_SLOPE bit 32, too
    input  wire logic        read_next_i,
    input  wire logic [ 6:0] read_word_i,
    output logic      [32:0] setting_o
);

  initial if (Axes < 1 || Axes > 9) $fatal(1, "Axes must be in [1, 9]");
  initial if (ScaleBits < 33 || ScaleBits > 56) $fatal(1, "ScaleBits must be in [33, 56]");
  initial if (TimeBits < 4 || TimeBits > 16) $fatal(1, "TimeBits must be in [4, 16]");

  // Times
  logic [7:0] fill_q;  // words of the memory that have their reset value: up to 2^7
  logic filled;
  logic works_q;
  logic read_q;  // programs read
  logic write_q;
  logic waits;
  assign waits  = read_q || path_changes_i;
  assign filled = fill_q[7];
  always_ff @(posedge clk_i) begin
    read_q <= read_next_i;
    if (!rst_ni) begin
      fill_q  <= '0;
      works_q <= 1'b0;
      done_o  <= 1'b0;
    end else begin
      if (!filled) fill_q <= fill_q + 1'b1;
      works_q <= filled && valid_i && !works_q && !done_o && !waits && !(read_next_i && write_i);
      done_o  <= works_q;
    end
  end

  // The word, of an axis or of all: whether it exists is known a clock before it is written.
  logic of_axis;
  logic axis_exists;
  logic axis_scale;
  logic turns;  // a polarity
  logic standstill;  // .. or shapes
  logic exists;
  assign of_axis = word_i[6] && word_i < registers_pkg::Following0;
  assign steps_axis_o = note_ready_o ? note_word_i[5:2] : word_i[5:2];
  assign axis_exists = word_i[5:2] < 4'(Axes);
  assign axis_scale = axis_exists && !word_i[1];
  assign turns        = word_i == registers_pkg::Pins &&
      (data_i[registers_pkg::PinsStepInvertedLow+:Axes] != step_inverted_o ||
       data_i[registers_pkg::PinsDirectionInvertedLow+:Axes] != direction_inverted_o);
  assign standstill = turns || word_i == registers_pkg::Shaper;
  always_comb begin
    if (of_axis && write_i) exists = axis_scale && off_i;
    else if (of_axis) exists = axis_scale || (axis_exists && word_i[1]);
    else if (write_i) exists = registers_pkg::can_write(word_i) && (off_i || !standstill);
    else exists = registers_pkg::can_read(word_i);
  end
  logic of_axis_q;
  logic exists_q;
  logic [6:0] word_q;
  logic [1:0] axis_word;
  assign axis_word    = word_q[1:0];
  assign scale_axis_o = word_q[5:2];
  always_ff @(posedge clk_i) begin
    of_axis_q <= of_axis;
    exists_q  <= exists;
    write_q   <= write_i;
    word_q    <= word_i;
  end

  // Conditions of what goes on from here
  logic taken;
  logic writes;
  always_comb begin
    case (word_q)
      registers_pkg::SegmentHi: taken = segment_ready_i;
      registers_pkg::ProfileHi: taken = profile_ready_i;
      registers_pkg::Sample:    taken = sample_ready_i;
      registers_pkg::Control:   taken = control_ready_i;
      registers_pkg::Reference: taken = reference_ready_i;
      default:                  taken = 1'b1;
    endcase
  end
  assign writes = works_q && write_q && exists_q;

  // Words to be pushed: the low part is read from the memory.
  logic [31:0] kept_q;
  assign motion_word_o     = {data_i[15:0], kept_q};
  assign scale_o           = {data_i[ScaleBits-33:0], kept_q};
  assign command_o         = data_i;
  assign scale_write_o     = writes && of_axis_q && axis_word == registers_pkg::AxisScaleHi;
  assign segment_valid_o   = works_q && write_q && word_q == registers_pkg::SegmentHi;
  assign profile_valid_o   = works_q && write_q && word_q == registers_pkg::ProfileHi;
  assign sample_valid_o    = works_q && write_q && word_q == registers_pkg::Sample;
  assign control_asked_o   = writes && word_q == registers_pkg::Control;
  assign control_write_o   = control_asked_o && control_ready_i;
  assign state_write_o     = writes && word_q == registers_pkg::State;
  assign reference_write_o = writes && word_q == registers_pkg::Reference && reference_ready_i;
  assign probe_write_o     = writes && word_q == registers_pkg::Probe;
  assign homed_write_o     = writes && word_q == registers_pkg::Homed;
  assign shaper_write_o    = writes && word_q == registers_pkg::Shaper;

  // Settings
  logic [31:0] override_reset;
  assign override_reset = registers_pkg::reset_value(registers_pkg::Override);
  logic [31:0] slope_q;
  logic slope_is_0_q;
  logic [28:0] stop_ticks_q;
  assign hold_slope_o = {slope_is_0_q, slope_q};
  assign stop_ticks_o = {3'd0, stop_ticks_q};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      override_o                                              <= override_reset[16:0];
      watchdog_o                                              <= '0;
      samples_per_tick_log2_o                                 <= '0;
      hold_acceleration_o                                     <= '0;
      slope_q                                                 <= '0;
      slope_is_0_q                                            <= 1'b1;
      stop_ticks_q                                            <= '0;
      digest_o                                                <= '0;
      {stepspace_o, steplen_o}                                <= '0;
      {dirhold_o, dirsetup_o}                                 <= '0;
      {limit_masked_o, direction_inverted_o, step_inverted_o} <= '0;
    end else if (writes) begin
      case (word_q)
        registers_pkg::Override:         override_o <= data_i[16:0];
        registers_pkg::Watchdog:         watchdog_o <= data_i[15:0];
        registers_pkg::Timing:           samples_per_tick_log2_o <= data_i[3:0];
        registers_pkg::HoldAcceleration: hold_acceleration_o <= data_i;
        registers_pkg::HoldSlope: begin
          slope_q      <= data_i;
          slope_is_0_q <= data_i == '0;
        end
        registers_pkg::StopTicks:        stop_ticks_q <= data_i[28:0];
        registers_pkg::Digest:           digest_o <= data_i[15:0];
        registers_pkg::Pulse: begin
          steplen_o   <= data_i[registers_pkg::PulseSteplenLow+:TimeBits];
          stepspace_o <= data_i[registers_pkg::PulseStepspaceLow+:TimeBits];
        end
        registers_pkg::Direction: begin
          dirsetup_o <= data_i[registers_pkg::DirectionDirsetupLow+:TimeBits];
          dirhold_o  <= data_i[registers_pkg::DirectionDirholdLow+:TimeBits];
        end
        registers_pkg::Pins: begin
          step_inverted_o      <= data_i[registers_pkg::PinsStepInvertedLow+:Axes];
          direction_inverted_o <= data_i[registers_pkg::PinsDirectionInvertedLow+:Axes];
          limit_masked_o       <= data_i[registers_pkg::PinsLimitMaskedLow+:Axes];
        end
        default:                         ;
      endcase
    end
  end

  // The memory. A note never meets an answer that is read, nor settings that programs read. A write
  // reads the first word of its four: for the high part of a word or scale the low one, which both
  // streams have in common.
  logic [31:0] fill_data;
  logic fills;
  logic keeps;  // what belongs to PATH_LO, which is read
  logic [6:0] address;
  logic [31:0] data;
  assign kept_ready_o = !read_q;
  assign note_ready_o = filled && (!valid_i || done_o || (waits && !works_q));
  always_comb begin
    fills = !filled;
    fill_data = registers_pkg::reset_value(fill_q[6:0]);
    case (fill_q[6:0])
      registers_pkg::Id, registers_pkg::Version, registers_pkg::Capability, registers_pkg::Core,
      registers_pkg::Clock, registers_pkg::Widths:
      {fills, fill_data} = '0;
      default: ;
    endcase
  end
  assign keeps = filled && valid_i && !done_o && !write_i && word_i == registers_pkg::PathLo;
  always_comb begin
    if (!filled) {address, data} = {fill_q[6:0], fill_data};
    else if (note_ready_o) {address, data} = {note_word_i, note_data_i};
    else if (keeps && works_q) {address, data} = {registers_pkg::PathHi, path_i[63:32]};
    else if (keeps) {address, data} = {registers_pkg::Rate, 15'd0, rate_i};
    else {address, data} = {word_i, data_i};
    if (address == registers_pkg::ProfileLo) address = registers_pkg::SegmentLo;
  end
  (* no_rw_check *)
  logic [31:0] memory[128];
  initial begin  // constants: the device's configuration
    for (int n = 0; n < 128; n = n + 1) memory[n] = '0;
    memory[registers_pkg::Id] = registers_pkg::reset_value(registers_pkg::Id);
    memory[registers_pkg::Version] = registers_pkg::reset_value(registers_pkg::Version) |
        (32'(words_pkg::Version) << registers_pkg::VersionWordsLow);
    memory[registers_pkg::Capability] = 32'(Capability);
    memory[registers_pkg::Core] = 32'(Core);
    memory[registers_pkg::Clock] = 32'(ClockHertz);
    memory[registers_pkg::Widths] = 32'(Widths);
  end
  logic [6:0] read_address;
  assign kept_o = kept_q;
  always_comb begin
    if (read_q) read_address = read_word_i;
    else if (note_ready_o) read_address = kept_word_i;
    else read_address = {word_i[6:2], write_i ? 2'd0 : word_i[1:0]};
  end
  always @(posedge clk_i) begin  // with always_ff nothing else, no initial block, might write it
    if (fills || note_ready_o || keeps || writes) memory[address] <= data;
    kept_q <= memory[read_address];
  end

  // Settings: STOP_TICKS has 29 bits, and of HOLD_SLOPE 0 is 2^32.
  logic stop_ticks_is_read_q;
  always_ff @(posedge clk_i) stop_ticks_is_read_q <= read_word_i == registers_pkg::StopTicks;
  assign setting_o = {slope_is_0_q, stop_ticks_is_read_q ? 3'd0 : kept_q[31:29], kept_q[28:0]};

  // Answers
  typedef enum logic [2:0] {
    Kept,
    State,
    AxesWord,
    Room,
    Samples,
    PathLo,
    Steps,
    Outputs
  } answer_t;
  (* fsm_encoding = "none" *)
  answer_t answer_q;
  logic [31:0] answer;
  always_ff @(posedge clk_i) begin
    case (word_i)
      registers_pkg::State: answer_q <= State;
      registers_pkg::Axes: answer_q <= AxesWord;
      registers_pkg::Room: answer_q <= Room;
      registers_pkg::Samples: answer_q <= Samples;
      registers_pkg::PathLo: answer_q <= PathLo;
      registers_pkg::Outputs: answer_q <= Outputs;
      default: answer_q <= of_axis && word_i[1:0] == registers_pkg::AxisSteps ? Steps : Kept;
    endcase
  end
  always_comb begin
    case (answer_q)
      Kept:    answer = kept_q;
      State:   answer = state_i;
      AxesWord:    answer = axes_i;
      Room:    answer = room_i;
      Samples: answer = samples_i;
      PathLo:  answer = path_i[31:0];
      Steps:   answer = steps_i;
      default: answer = outputs_i;
    endcase
  end
  always_ff @(posedge clk_i) begin
    if (works_q) begin
      error_o <= !exists_q || (write_q && !taken);
      data_o  <= answer;
    end
  end

endmodule
`default_nettype wire
