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
// first answer after a reset takes 2^7 clocks more, in which a memory gets its reset values;
// settings and constants are read from it, and notes (rtl/bus/probe_catch.sv), which wait for two
// clocks at most.
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
    output logic             control_write_o,
    input  wire logic        control_ready_i,
    output logic             state_write_o,
    output logic             reference_write_o,
    input  wire logic        reference_ready_i,
    output logic             probe_write_o,
    output logic             homed_write_o,
    output logic      [31:0] command_o,

    // Readable values
    input  wire logic [31:0] state_i,
    input  wire logic [31:0] axes_i,
    input  wire logic [31:0] room_i,
    input  wire logic [31:0] samples_i,
    input  wire logic [63:0] path_i,
    input  wire logic [16:0] rate_i,
    output logic      [ 3:0] steps_axis_o,
    input  wire logic [31:0] steps_i,       // steps of axis_o

    // Notes: the new value of a word; in the same clock another word is read, and is there in the
    // next one
    output logic             note_ready_o,
    input  wire logic [ 6:0] note_word_i,
    input  wire logic [31:0] note_data_i,
    input  wire logic [ 6:0] kept_word_i,
    output logic      [31:0] kept_o
);

  initial if (Axes < 1 || Axes > 9) $fatal(1, "Axes must be in [1, 9]");
  initial if (ScaleBits < 33 || ScaleBits > 56) $fatal(1, "ScaleBits must be in [33, 56]");
  initial if (TimeBits < 4 || TimeBits > 16) $fatal(1, "TimeBits must be in [4, 16]");

  // Times
  logic [7:0] fill_q;  // words of the memory that have their reset value: up to 2^7
  logic filled;
  logic works_q;
  assign filled = fill_q[7];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fill_q  <= '0;
      works_q <= 1'b0;
      done_o  <= 1'b0;
    end else begin
      if (!filled) fill_q <= fill_q + 1'b1;
      works_q <= filled && valid_i && !works_q && !done_o;
      done_o  <= works_q;
    end
  end

  // The word, of an axis or of all: whether it exists is known a clock before it is written.
  logic of_axis;
  logic axis_exists;
  logic axis_scale;
  logic turns;  // a polarity
  logic exists;
  assign of_axis = word_i[6] && word_i < registers_pkg::Following0;
  assign steps_axis_o = note_ready_o ? note_word_i[5:2] : word_i[5:2];
  assign axis_exists = word_i[5:2] < 4'(Axes);
  assign axis_scale = axis_exists && !word_i[1];
  assign turns        = word_i == registers_pkg::Pins &&
      (data_i[registers_pkg::PinsStepInvertedLow+:Axes] != step_inverted_o ||
       data_i[registers_pkg::PinsDirectionInvertedLow+:Axes] != direction_inverted_o);
  always_comb begin
    if (of_axis && write_i) exists = axis_scale && off_i;
    else if (of_axis) exists = axis_scale || (axis_exists && word_i[1]);
    else if (write_i) exists = registers_pkg::can_write(word_i) && (off_i || !turns);
    else exists = registers_pkg::can_read(word_i);
  end
  logic of_axis_q;
  logic exists_q;
  logic write_q;
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

  // Words to be pushed
  logic [31:0] low_q;
  logic low;
  always_comb begin
    case (word_q)
      registers_pkg::SegmentLo, registers_pkg::ProfileLo: low = 1'b1;
      default: low = of_axis_q && axis_word == registers_pkg::AxisScaleLo;
    endcase
  end
  always_ff @(posedge clk_i) if (writes && low) low_q <= data_i;
  assign motion_word_o     = {data_i[15:0], low_q};
  assign scale_o           = {data_i[ScaleBits-33:0], low_q};
  assign command_o         = data_i;
  assign scale_write_o     = writes && of_axis_q && axis_word == registers_pkg::AxisScaleHi;
  assign segment_valid_o   = works_q && write_q && word_q == registers_pkg::SegmentHi;
  assign profile_valid_o   = works_q && write_q && word_q == registers_pkg::ProfileHi;
  assign sample_valid_o    = works_q && write_q && word_q == registers_pkg::Sample;
  assign control_write_o   = writes && word_q == registers_pkg::Control && control_ready_i;
  assign state_write_o     = writes && word_q == registers_pkg::State;
  assign reference_write_o = writes && word_q == registers_pkg::Reference && reference_ready_i;
  assign probe_write_o     = writes && word_q == registers_pkg::Probe;
  assign homed_write_o     = writes && word_q == registers_pkg::Homed;

  // Settings
  logic [31:0] override_reset;
  assign override_reset = registers_pkg::reset_value(registers_pkg::Override);
  logic [31:0] slope_q;
  logic [28:0] stop_ticks_q;
  assign hold_slope_o = {slope_q == '0, slope_q};
  assign stop_ticks_o = {3'd0, stop_ticks_q};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      override_o                                              <= override_reset[16:0];
      watchdog_o                                              <= '0;
      samples_per_tick_log2_o                                 <= '0;
      hold_acceleration_o                                     <= '0;
      slope_q                                                 <= '0;
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
        registers_pkg::HoldSlope:        slope_q <= data_i;
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

  // The memory. A note never meets an answer that is read.
  logic [31:0] fill_data;
  logic [ 6:0] address;
  logic [31:0] data;
  assign note_ready_o = filled && (!valid_i || done_o);
  always_comb begin
    case (fill_q[6:0])
      registers_pkg::Version: begin
        fill_data = registers_pkg::reset_value(fill_q[6:0]);
        fill_data[registers_pkg::VersionWordsLow+:8] = 8'(words_pkg::Version);
      end
      registers_pkg::Capability: fill_data = 32'(Capability);
      registers_pkg::Core:       fill_data = 32'(Core);
      registers_pkg::Widths:     fill_data = 32'(Widths);
      registers_pkg::Clock:      fill_data = 32'(ClockHertz);
      default:                   fill_data = registers_pkg::reset_value(fill_q[6:0]);
    endcase
  end
  always_comb begin
    if (!filled) {address, data} = {fill_q[6:0], fill_data};
    else if (note_ready_o) {address, data} = {note_word_i, note_data_i};
    else {address, data} = {word_i, data_i};
  end
  (* no_rw_check *)
  logic [31:0] memory [128];
  logic [31:0] kept_q;
  assign kept_o = kept_q;
  always_ff @(posedge clk_i) begin
    if (!filled || note_ready_o || writes) memory[address] <= data;
    kept_q <= memory[note_ready_o?kept_word_i : word_i];
  end

  // Answers. All parts of the path are of one clock.
  logic [31:0] high_q;
  logic [16:0] rate_q;
  typedef enum logic [3:0] {
    Kept,
    State,
    AxesWord,
    Room,
    Samples,
    PathLo,
    PathHi,
    Rate,
    Steps
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
      registers_pkg::PathHi: answer_q <= PathHi;
      registers_pkg::Rate: answer_q <= Rate;
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
      PathHi:  answer = high_q;
      Rate:    answer = {15'd0, rate_q};
      default: answer = steps_i;
    endcase
  end
  always_ff @(posedge clk_i) begin
    if (works_q) begin
      error_o <= !exists_q || (write_q && !taken);
      data_o  <= answer;
      if (!write_q && word_q == registers_pkg::PathLo) begin
        high_q <= path_i[63:32];
        rate_q <= rate_i;
      end
    end
  end

endmodule
`default_nettype wire
