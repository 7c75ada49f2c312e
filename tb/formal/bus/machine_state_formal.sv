// SPDX-License-Identifier: Apache-2.0
// rtl/bus/machine_state.sv: a cause to stop stops the machine on the next clock; the machine turns
// on only on request and without a fault; words are taken of referenced axes alone; the motion ends
// only switched off or at rest; a fault stays until it is cleared. Either a program's words or a
// host's samples are taken, and the choice changes only with nothing of the other under way.
// control: ESTOP_PASSES s/= estop_i \&\& enable_o/= 1'b0/
// control: ESTOP_IS_REFUSED s/estop = control_asked_i/estop = control_write_i/
// control: LIMIT_PASSES s/= limit_i != '0 \&\& enable_o/= 1'b0/
// control: COMES_ON_FAULTY s/(!stopped \&\& empty_q)/empty_q/
// control: COMES_ON_FULL s/(!stopped \&\& empty_q)/!stopped/
// control: KEEPS_REFERENCE s/!rst_ni || turned_off/!rst_ni/
// control: WORDS_UNREFERENCED s/enable_o \&\& ready/enable_o/
// control: FLUSHES_MOVING s/(flush_q \&\& rests)/flush_q/
// control: FORGETS_FAULT s/(faults_q \& ~/(18'd0 \& ~/
// control: BOTH s/ \&\& !position_o;/;/
// control: CHANGES s/enable_o ? clean || asks_position == position_o/enable_o ? 1'b1/
// control: FLUSHES_QUEUED s/position_o ? !queued_i/position_o ? 1'b1/
// control: HOST_GONE s/position_o ? Stops ^ Other/position_o ? Stops/
// control: SLEEPS_BY_POSITION s/active_i || (enable_o \&\& position_o)/active_i/
// control: STAYS_HOMED s/& ~uncertain_i/\& ~(2'd0 \& uncertain_i)/
// control: PASSES_THE_PROBE s/ || caught_i//
// control: SLEEPS s/silence_q == watchdog_i/1'b0/
// control: REFUSED_IS_LIFE s/obeyed = write_i \&\& !error_i/obeyed = write_i/
// control: FOLLOWS_PASSES s/{following_i, encoder_i}/{1'b0, encoder_i}/
// control: HOMED_ASTRAY s/ \& ~astray//
// control: BEGINS_MOVED s/begins_o = !moved_q \&\&/begins_o = /
// control: NAMES_THE_LAST s/enable_o ? {following_i, encoder_i} : 2'd0/{following_i, encoder_i}/
// control: NAMES_WITHOUT_FAULT s/else if (sources\[17:16\] != '0) axis_q/else axis_q/
`default_nettype none
module machine_state_formal (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        write_i,
    input wire logic [ 1:0] where_i,
    input wire logic [31:0] command_i,
    input wire logic        error_i,
    input wire logic        active_i,
    input wire logic        standing_i,
    input wire logic [ 7:0] motion_fault_i,
    input wire logic        sample_i,
    input wire logic        offered_i,
    input wire logic        queued_i,
    input wire logic        word_i,
    input wire logic        tick_i,
    input wire logic        answered_i,
    input wire logic        estop_i,
    input wire logic [ 1:0] limit_i,
    input wire logic [ 1:0] referenced_i,
    input wire logic [ 1:0] uncertain_i,
    input wire logic        caught_i,
    input wire logic        late_i,
    input wire logic        encoder_i,
    input wire logic        following_i,
    input wire logic        axis_i
);

  logic control;
  logic control_ready;
  logic state_write;
  logic reference;
  logic reference_ready;
  logic homes;
  logic [1:0] homed;
  logic [31:0] state;
  logic hold;
  logic ends;
  logic empty;
  logic words;
  logic samples;
  logic position;
  logic begins;
  logic enable;
  logic word;  // one that is taken: another access than the writes
  assign word = word_i && !write_i && (words || samples);
  assign control = write_i && where_i == 2'd0 && control_ready;
  assign state_write = write_i && where_i == 2'd1;
  assign reference = write_i && where_i == 2'd2 && reference_ready;
  assign homes = write_i && where_i == 2'd3;
  assign empty = ends && !offered_i;
  machine_state #(
      .Axes(2)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .control_asked_i(write_i && where_i == 2'd0),
      .control_write_i(control),
      .control_ready_o(control_ready),
      .state_write_i(state_write),
      .reference_write_i(reference),
      .reference_ready_o(reference_ready),
      .homed_write_i(homes),
      .command_i,
      .write_i(answered_i),
      .error_i,
      .watchdog_i(16'd2),
      .state_o(state),
      .homed_o(homed),
      .caught_i,
      .active_i,
      .standing_i,
      .underrun_i(1'b0),
      .motion_fault_i,
      .word_i(word),
      .offered_i,
      .empty_i(empty),
      .sample_i,
      .position_o(position),
      .samples_o(samples),
      .queued_i,
      .hold_o(hold),
      .ends_o(ends),
      .keeps_o(),
      .words_o(words),
      .begins_o(begins),
      .tick_i,
      .estop_i,
      .limit_i,
      .referenced_i,
      .uncertain_i,
      .overrun_i(1'b0),
      .refused_i(1'b0),
      .late_i,
      .encoder_i,
      .following_i,
      .fault_axis_i({3'd0, axis_i}),
      .enable_o(enable)
  );

  logic started_q = 1'b0;
  logic ran_q;  // no reset in the clock before
  logic wrong_q;  // in the clock before: a source that stops the machine
  logic asked_q;  // to come on
  logic empty_q;
  logic enable_q;
  logic [17:0] faults;
  logic [17:0] faults_q;
  logic [17:0] cleared_q;
  logic [3:0] axis_q;
  logic [3:0] named_q;  // STATE.fault_axis in the clock before
  logic [1:0] astray;
  assign faults = {state[26:25], state[15:0]};
  assign astray = following_i ? 2'd1 << axis_i : 2'd0;
  logic [1:0] known_q;  // axes that are or will be referenced, since the machine went off
  logic [1:0] home_q;  // axes that the host called homed, and no pulse was cut since
  logic flush_q;  // asked for, and not done
  logic moved_q;  // a sample came since it was empty
  logic [1:0] silence_q;  // samples, 3 at most
  logic silent_q;  // the watchdog's time is over
  logic position_q;
  logic ready_q;  // all axes were, in the clock before
  logic used_q;  // a word or sample came since it was empty
  logic watches;
  assign watches = active_i || (position && enable);
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    ran_q <= rst_ni;
    wrong_q    <= estop_i || limit_i != 2'd0 || motion_fault_i[7] ||
        (enable && (encoder_i || following_i)) || (write_i && where_i == 2'd0 && command_i[3]);
    asked_q <= control && command_i[0];
    empty_q <= empty;
    ready_q <= (referenced_i | known_q) == 2'b11;
    enable_q <= enable;
    faults_q <= faults;
    axis_q <= faults[17:16] != 2'd0 ? state[30:27] : {3'd0, axis_i};
    named_q <= state[30:27];
    position_q <= position;
    cleared_q <= state_write ? {command_i[26:25], command_i[15:0]} : 18'd0;
    if (!rst_ni) begin
      known_q   <= 2'd0;
      home_q    <= 2'd0;
      flush_q   <= 1'b0;
      moved_q   <= 1'b0;
      silence_q <= '0;
      silent_q  <= 1'b0;
      used_q    <= 1'b0;
    end else begin
      if (empty) used_q <= 1'b0;
      else if (word) used_q <= 1'b1;
      if (homes) home_q <= command_i[1:0] & ~uncertain_i & ~astray;
      else home_q <= home_q & ~uncertain_i & ~astray;
      if (reference) known_q <= known_q | command_i[1:0];
      if (enable_q && !enable) known_q <= reference ? command_i[1:0] : 2'd0;
      if (control && command_i[2]) flush_q <= 1'b1;
      if (empty) flush_q <= 1'b0;
      if (sample_i) moved_q <= 1'b1;
      if (empty) moved_q <= 1'b0;
      silent_q <= tick_i && watches && silence_q == 2'd2;
      if ((answered_i && !error_i) || !watches) silence_q <= '0;
      else if (tick_i && silence_q != 2'd3) silence_q <= silence_q + 1'b1;
    end
  end

  always_comb begin
    if (!started_q) assume (!rst_ni);
    if (empty_q) assume (!offered_i);  // rtl/bus/paced_motion.sv resets the motion
    if (started_q && rst_ni) begin
      Stops : assert (!(wrong_q && enable));
      Comes_on :
      assert (!(enable && !enable_q) || (asked_q && empty_q && faults_q[17:16] == 2'd0 &&
          faults_q[7:2] == 6'd0));
      Words : assert (!(words || samples) || (enable && ready_q));
      One : assert (!(words && samples) && !(words && position) && !(samples && !position));
      Chosen : assert (!ran_q || position == position_q || !enable_q || !used_q);
      Ends :
      assert (!(ends && enable) || (flush_q && (position ? !queued_i : standing_i || !moved_q)));
      Stay : assert (!ran_q || (faults_q & ~cleared_q & ~faults) == 18'd0);
      Names : assert (!ran_q || faults[17:16] == 2'd0 || state[30:27] == axis_q);
      Begins : assert (begins == (!moved_q && !position));
      Stays : assert (!ran_q || faults[17:16] != 2'd0 || state[30:27] == named_q);
      Homed : assert (homed == home_q);
      Caught : assert (!caught_i || hold);
      Watches : assert (!silent_q || (state[1] && hold));
      Alone : assert (!silent_q || !position_q || !enable);
      On : cover (enable && words);
      Off : cover (enable_q && !enable && wrong_q);
      Flushed : cover (enable && ends && moved_q);
      Silent : cover (silent_q && enable);
      Samples : cover (samples && used_q);
    end
  end

endmodule
`default_nettype wire
