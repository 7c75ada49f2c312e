// SPDX-License-Identifier: Apache-2.0
// The machine's permission to move, enable, hold, flush, references and faults, by the registers
// CONTROL, STATE and REFERENCE of hls/registers/registers.rdl; and its source of motion, a program
// or positions of the host.
//
//   clock         0          1
//   source        1
//   enable_o      1          0      for a fault that stops the steps: all but bus and watchdog
//   state_o                  fault
//
// While enable_o is 0, and at the end of a flush, ends_o: the motion becomes empty (empty_i) when
// the sample that is offered (offered_i) has been taken.
`default_nettype none
module machine_state #(
    parameter int Axes = 3  // [1, 9]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Registers
    input  wire logic            control_asked_i,    // ready or not: its e-stop is obeyed
    input  wire logic            control_write_i,
    output logic                 control_ready_o,
    input  wire logic            state_write_i,
    input  wire logic            reference_write_i,
    output logic                 reference_ready_o,
    input  wire logic            homed_write_i,
    input  wire logic [    31:0] command_i,
    input  wire logic            write_i,            // any write, answered
    input  wire logic            error_i,            // answered with an error
    input  wire logic [    15:0] watchdog_i,         // samples without an obeyed write
    output logic      [    31:0] state_o,
    output logic      [Axes-1:0] homed_o,
    input  wire logic            caught_i,           // PROBE

    // Motion
    input  wire logic       active_i,
    input  wire logic       standing_i,
    input  wire logic       underrun_i,
    input  wire logic [7:0] motion_fault_i,
    input  wire logic       word_i,          // a word was taken
    input  wire logic       offered_i,       // a sample
    input  wire logic       empty_i,
    input  wire logic       sample_i,        // a sample was taken
    output logic            hold_o,
    output logic            ends_o,
    output logic            keeps_o,         // outputs that are on: a flush leaves them
    output logic            words_o,         // words may be taken
    output logic            begins_o,        // the next sample is a program's first

    // Positions of the host
    output logic      position_o,  // the host moves it, not a program
    output logic      samples_o,   // samples may be taken
    input  wire logic queued_i,    // samples wait

    // Steps
    input  wire logic            tick_i,
    input  wire logic            estop_i,       // synchronised
    input  wire logic [Axes-1:0] limit_i,       // not masked
    input  wire logic [Axes-1:0] referenced_i,
    input  wire logic [Axes-1:0] uncertain_i,
    input  wire logic            overrun_i,     // an axis has one
    input  wire logic            refused_i,
    input  wire logic            late_i,
    input  wire logic            encoder_i,     // axis fault_axis_i has one, as with following_i
    input  wire logic            following_i,
    input  wire logic [     3:0] fault_axis_i,
    output logic      [Axes-1:0] reference_o,
    output logic                 enable_o
);

  localparam int FirstMotion = registers_pkg::StateMotionLow;
  localparam int NoSample = FirstMotion + 7;  // fault_o[7] of motion_interpolator

  // Faults of steps count at their start, for they stay until the next reference.
  logic [2:0] steps;
  logic [2:0] steps_q;
  logic [17:0] faults_q;
  logic [17:0] sources;
  logic [3:0] axis_q;
  logic silent;
  logic estop;
  assign steps = {late_i, refused_i, overrun_i};
  assign estop = control_asked_i && command_i[registers_pkg::ControlEstopLow];
  always_comb begin
    sources = 18'd0;
    sources[registers_pkg::StateBusLow] = write_i && error_i;
    sources[registers_pkg::StateWatchdogLow] = silent;
    sources[registers_pkg::StateEstopLow] = estop;
    sources[registers_pkg::StateEstopInputLow] = estop_i && enable_o;
    sources[registers_pkg::StateLimitLow] = limit_i != '0 && enable_o;
    sources[registers_pkg::StateOverrunLow+:3] = enable_o ? steps & ~steps_q : 3'd0;
    sources[FirstMotion+:8] = motion_fault_i;
    sources[17:16] = enable_o ? {following_i, encoder_i} : 2'd0;
  end
  logic [17:0] cleared;
  assign cleared = {command_i[registers_pkg::StateEncoderLow+:2], command_i[15:0]};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) axis_q <= '0;
    else if (sources[17:16] != '0) axis_q <= fault_axis_i;
    if (!rst_ni) begin
      faults_q <= '0;
      steps_q  <= '0;
    end else begin
      faults_q <= (faults_q & ~(state_write_i ? cleared : 18'd0)) | sources;
      steps_q  <= steps;
    end
  end

  // Enable
  localparam logic [17:0] Stops = 18'(8'b1111_1100) | (18'd1 << NoSample) | 18'h30000;
  // The host moves the axes itself: if it is gone, nobody does; if it is late, motion goes on.
  localparam logic [17:0] Other = (18'd1 << registers_pkg::StateWatchdogLow) |
      (18'd1 << registers_pkg::StateLateLow);
  logic clean_q;
  logic offered_q;
  logic empty_q;
  logic clean;
  logic asks_position;
  logic [17:0] stop_mask;
  logic stops;
  logic stopped;
  logic asks;
  logic may_enable;
  logic turned_off;
  assign stop_mask = position_o ? Stops ^ Other : Stops;
  assign stops = (sources & stop_mask) != '0;
  assign stopped = (faults_q & (Stops | stop_mask)) != '0 || estop_i || limit_i != '0;
  assign asks = command_i[registers_pkg::ControlEnableLow];
  assign may_enable = enable_o ? clean || asks_position == position_o : (!stopped && empty_q);
  assign turned_off = stops || (control_asked_i && !asks && enable_o);
  assign control_ready_o = !asks || may_enable;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || stops) enable_o <= 1'b0;
    else if (control_write_i) enable_o <= asks;
  end

  // A program or positions, chosen when neither is under way.
  // Of the clock before, for a request's answer: empty, the motion stays so for a clock.
  assign clean = clean_q && !offered_q;
  assign asks_position = command_i[registers_pkg::ControlPositionLow];
  always_ff @(posedge clk_i) begin
    offered_q <= offered_i;
    empty_q   <= rst_ni && empty_i;
    if (!rst_ni) position_o <= 1'b0;
    else if (control_write_i && asks) position_o <= asks_position;
  end

  // Hold and flush. Samples before a program's first do not move, and may wait for its words.
  logic hold_q;
  logic flush_q;
  logic keep_q;
  logic moved_q;
  logic rests;
  assign hold_o = hold_q || flush_q || faults_q[registers_pkg::StateWatchdogLow] || caught_i;
  assign begins_o = !moved_q && !position_o;
  assign rests = position_o ? !queued_i : standing_i || !moved_q;
  assign keeps_o = keep_q;
  assign ends_o = !enable_o || (flush_q && rests);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      hold_q  <= 1'b0;
      keep_q  <= 1'b0;
      flush_q <= 1'b0;
    end else begin
      if (control_write_i) hold_q <= command_i[registers_pkg::ControlHoldLow];
      if (control_write_i) keep_q <= command_i[registers_pkg::ControlKeepLow];
      if (empty_i) flush_q <= 1'b0;
      else if (control_write_i && command_i[registers_pkg::ControlFlushLow]) flush_q <= 1'b1;
    end
    if (!rst_ni || empty_i) begin
      moved_q <= 1'b0;
      clean_q <= 1'b1;
    end else begin
      if (sample_i) moved_q <= 1'b1;
      if (word_i) clean_q <= 1'b0;
    end
  end

  // References: the next sample is the next program's, if none came since the queues were emptied.
  logic [Axes-1:0] next_q;
  logic ready;
  logic ready_q;
  assign reference_ready_o = clean;
  assign reference_o = reference_write_i ? command_i[Axes-1:0] : '0;
  assign ready = &(referenced_i | next_q);
  assign words_o = enable_o && ready_q && !flush_q && !position_o;
  assign samples_o = enable_o && ready_q && !flush_q && position_o;
  always_ff @(posedge clk_i) begin
    ready_q <= ready;
    if (!rst_ni || turned_off) next_q <= '0;
    else next_q <= (next_q & ~referenced_i) | reference_o;
  end

  // Homed axes: counts of steps state where they stand, as long as each pulse was a step.
  logic [Axes-1:0] astray;
  assign astray = following_i ? Axes'(1) << fault_axis_i : '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) homed_o <= '0;
    else homed_o <= (homed_write_i ? command_i[Axes-1:0] : homed_o) & ~uncertain_i & ~astray;
  end

  // The host's silence, in samples. Reads are no sign of life: any program may read.
  logic [15:0] silence_q;
  logic under_way;
  logic obeyed;
  assign obeyed = write_i && !error_i;
  assign under_way = active_i || (enable_o && position_o);
  assign silent = tick_i && under_way && watchdog_i != '0 && silence_q == watchdog_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || obeyed || !under_way) silence_q <= '0;
    else if (tick_i) silence_q <= silence_q + 1'b1;
  end

  always_comb begin
    state_o = 32'd0;
    state_o[15:0] = faults_q[15:0];
    state_o[registers_pkg::StateEncoderLow+:2] = faults_q[17:16];
    state_o[registers_pkg::StateFaultAxisLow+:4] = axis_q;
    state_o[registers_pkg::StateEnabledLow] = enable_o;
    state_o[registers_pkg::StateHoldingLow] = hold_o;
    state_o[registers_pkg::StateActiveLow] = active_i;
    state_o[registers_pkg::StateStandingLow] = standing_i;
    state_o[registers_pkg::StateUnderrunLow] = underrun_i;
    state_o[registers_pkg::StateFlushingLow] = flush_q || (!enable_o && offered_i);
    state_o[registers_pkg::StateCleanLow] = clean_q;
    state_o[registers_pkg::StateReadyLow] = ready;
    state_o[registers_pkg::StateEstopPinLow] = estop_i;
    state_o[registers_pkg::StateCaughtLow] = caught_i;
  end

endmodule
`default_nettype wire
