// SPDX-License-Identifier: Apache-2.0
// rtl/path/sample_gate.sv: no more requests and ticks are under way than there is room for, a tick
// for the first of every 2^n samples and for no other, none while paused, kill is final, no time
// without good settings, nothing gets stuck. n changes where it may.
// control: OVERFLOWS s/8'(Room - 2)/8'(Room)/
// control: TICKS_OVERFLOW s/started_o <= 5'd14/started_o <= 5'd17/
// control: TICK_EACH s/assign tick = admit \&\& first/assign tick = admit/
// control: KILL_PASSES s/if (kill_i) killed_o <= 1'b1/killed_o <= kill_i/
// control: PAUSE_PASSES s/tick_room_q \&\& !pause_i/tick_room_q/
// control: BAD_RUNS s/ || !good_i//
// control: NEVER_MIND_TICKS s/assign quiet_o = .*/assign quiet_o = admitted_q == '0;/
// control: NO_RESET s/admitted_q  <= '0;//
`default_nettype none
module sample_gate_formal (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic [ 1:0] n_i,
    input wire logic        pause_i,
    input wire logic        good_i,
    input wire logic        request_i,
    input wire logic        kill_i,
    input wire logic        hold_i,
    input wire logic        underrun_i,
    input wire logic [16:0] override_i,
    input wire logic        taken_i,
    input wire logic        sent_i
);

  localparam int Room = 20;
  localparam int Ticks = 16;

  logic quiet;
  logic ready;
  logic tick;
  logic [16:0] target;
  logic killed;
  logic [4:0] started;
  logic wanted;
  sample_gate #(
      .Room(Room)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .samples_per_tick_log2_i({2'b0, n_i}),
      .pause_i,
      .good_i,
      .quiet_o(quiet),
      .request_valid_i(request_i),
      .request_ready_o(ready),
      .kill_i,
      .hold_i,
      .underrun_i,
      .override_i,
      .tick_o(tick),
      .target_o(target),
      .killed_o(killed),
      .tick_taken_i(taken_i),
      .started_o(started),
      .sent_i,
      .wanted_o(wanted)
  );

  logic begun_q = 1'b0;
  logic [1:0] n_q;
  logic [4:0] admitted_q;
  logic [4:0] ticks_q;
  logic [2:0] index_q;
  logic was_first_q;
  logic was_killed_q;
  logic was_held_q;
  logic may_change_q;
  logic [1:0] idle_q;  // cycles without anything on the way
  logic admit;
  logic first;
  assign admit = request_i && ready;
  assign first = index_q == '0;
  always_ff @(posedge clk_i) begin
    begun_q      <= 1'b1;
    n_q          <= n_i;
    was_first_q  <= rst_ni && admit && first;
    was_killed_q <= rst_ni && (kill_i || was_killed_q);
    was_held_q   <= hold_i || underrun_i || kill_i || !good_i;
    may_change_q <= !rst_ni || (quiet && pause_i);
    if (!rst_ni) begin
      admitted_q <= '0;
      ticks_q    <= '0;
      index_q    <= '0;
      idle_q     <= '0;
    end else begin
      admitted_q <= admitted_q + {4'b0, admit} - {4'b0, sent_i};
      ticks_q    <= ticks_q + {4'b0, admit && first} - {4'b0, taken_i};
      if (admit) index_q <= (index_q == (3'd1 << n_i) - 3'd1) ? '0 : index_q + 1'b1;
      idle_q <= (admitted_q != '0 || ticks_q != '0) ? '0 : (idle_q == 2'd2) ? 2'd2 : idle_q + 1'b1;
    end
  end

  always_comb begin
    if (!begun_q) begin
      assume (!rst_ni);
    end else begin
      if (!may_change_q) assume (n_i == n_q);
      if (rst_ni) begin
        if (admitted_q == '0) assume (!sent_i);
        if (ticks_q == '0) assume (!taken_i);

        RoomForSamples : assert (admitted_q <= 5'(Room));
        RoomForTicks : assert (ticks_q <= 5'(Ticks));
        CountsTicks : assert (started == ticks_q);
        WantsWhatIsAdmitted : assert (wanted == (admitted_q != '0));
        Quiet : assert (quiet == (admitted_q == '0 && index_q == '0));
        if (pause_i && first) Pauses : assert (!ready);
        TickForTheFirst : assert (tick == was_first_q);
        KillIsForGood : assert (killed == was_killed_q);
        if (was_held_q || was_killed_q) Stops : assert (target == '0);
        Bounded : assert (target <= 17'h1_0000);
        if (idle_q == 2'd2 && !pause_i) NeverStuck : assert (ready);

        GoesOnInAPause : cover (pause_i && admit);
        Fills : cover (admitted_q == 5'(Room));
        TicksFill : cover (ticks_q == 5'(Ticks));
        FourSamples : cover (tick && index_q == 3'd1 && n_i == 2'd2 && killed);
      end
    end
  end

endmodule
`default_nettype wire
