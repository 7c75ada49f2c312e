// SPDX-License-Identifier: Apache-2.0
// rtl/path/piece_clock.sv: every tick gives one event in order, pieces begin one after the other
// and only when they are loaded, time waits where no piece is queued, no program begins in a tick
// that is held, nothing gets stuck. Ticks are numbered through their rates, pieces through their
// banks.
// control: LOSES_TICK s/assign rate_ready_o = .*/assign rate_ready_o = 1'b1;/
// control: TAKES_MISSING s/ \&\& !ends \&\& next_valid_i/ \&\& !ends/
// control: SKIPS_QUEUED s/(ends || !queued_i)/(ends || !next_valid_i)/
// control: BEGINS_HELD s/last_o || barred_q/last_o/
// control: RUNS_ON s/(active_o \&\& !(stops \&\& last_o))/active_o/
// control: NO_RESET s/after_valid_q <= 1'b0;//
`default_nettype none
module piece_clock_formal (
    input wire logic       clk_i,
    input wire logic       rst_ni,
    input wire logic       slot_i,
    input wire logic       rate_valid_i,
    input wire logic       held_i,
    input wire logic       queued_i,
    input wire logic       next_valid_i,
    input wire logic [1:0] next_ticks_i,
    input wire logic       next_final_i
);

  logic [2:0] sent_q;
  logic [2:0] taken_q;
  logic held_q[4];  // of the ticks inside
  logic [2:0] seen_q;
  logic [2:0] piece_q;
  logic next_take;
  logic rate_ready;
  logic taken;
  logic valid;
  logic begins;
  logic still;
  logic ends;
  logic [35:0] elapsed;
  logic [4:0] time_exponent;
  logic [2:0] bank;
  logic [16:0] rate;
  logic active;
  logic last;
  logic signed [21:0] ticks_left;
  piece_clock #(
      .BankBits(3)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .slot_i,
      .queued_i,
      .next_valid_i,
      .next_take_o(next_take),
      .next_ticks_i({18'b0, next_ticks_i}),
      .next_time_exponent_i(5'd2),
      .next_final_i,
      .next_bank_i(piece_q),
      .rate_valid_i,
      .rate_ready_o(rate_ready),
      .rate_i({1'b0, sent_q, 13'b0}),
      .held_i,
      .tick_taken_o(taken),
      .valid_o(valid),
      .begin_o(begins),
      .still_o(still),
      .end_o(ends),
      .time_o(elapsed),
      .time_exponent_o(time_exponent),
      .bank_o(bank),
      .rate_o(rate),
      .active_o(active),
      .last_o(last),
      .ticks_left_o(ticks_left)
  );
  logic unused;
  assign unused = ^{elapsed, time_exponent, ticks_left};

  logic held_before_q;
  logic started_q = 1'b0;
  logic kept_next_q;
  logic kept_final_q;
  logic [1:0] kept_ticks_q;
  logic kept_queued_q;
  logic [2:1] events_q;
  logic event_q;
  logic [3:0] idle_q;  // cycles in which a tick could have been taken
  logic [2:0] in_piece;
  assign in_piece = sent_q - taken_q;
  logic could;
  assign could = in_piece != '0 && slot_i && (next_valid_i || !queued_i);
  logic [3:1] may_stop_q;  // at the tick of an event: no piece follows
  logic was_last_q;
  logic [2:0] event_piece_q;  // pieces begun, as the events tell
  always_ff @(posedge clk_i) begin
    started_q     <= 1'b1;
    kept_next_q   <= rst_ni && next_valid_i && !next_take;
    kept_queued_q <= rst_ni && queued_i && !next_take;
    kept_final_q  <= next_final_i;
    kept_ticks_q  <= next_ticks_i;
    events_q      <= {events_q[1], taken} & {2{rst_ni}};
    event_q       <= events_q[2] && rst_ni;
    idle_q        <= {idle_q[2:0], rst_ni && could && !taken};
    may_stop_q    <= {may_stop_q[2:1], last || !queued_i};
    was_last_q    <= rst_ni && last;
    if (!rst_ni) begin
      sent_q        <= '0;
      taken_q       <= '0;
      seen_q        <= '0;
      piece_q       <= '0;
      event_piece_q <= '0;
    end else begin
      if (rate_valid_i && rate_ready) sent_q <= sent_q + 1'b1;
      if (rate_valid_i && rate_ready) held_q[sent_q[1:0]] <= held_i;
      if (taken) held_before_q <= held_q[taken_q[1:0]] && next_valid_i;
      if (taken) taken_q <= taken_q + 1'b1;
      if (valid) seen_q <= seen_q + 1'b1;
      if (next_take) piece_q <= piece_q + 1'b1;
      if (valid && begins) event_piece_q <= event_piece_q + 1'b1;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      assume (next_ticks_i != '0);
      if (kept_next_q) assume (next_valid_i && next_ticks_i == kept_ticks_q);
      if (kept_next_q) assume (next_final_i == kept_final_q);
      if (kept_queued_q || next_valid_i) assume (queued_i);

      FewInside : assert (in_piece <= 3'd3);
      if (next_take && !active) BeginsFree : assert (!held_q[taken_q[1:0]]);
      if (next_take) TakesLoaded : assert (next_valid_i && taken);
      if (taken) TakesAtSlot : assert (slot_i && in_piece != '0);
      EventPerTick : assert (valid == event_q);
      if (valid) InOrder : assert (rate == {1'b0, seen_q, 13'b0});
      if (valid && begins) OwnBank : assert (bank == event_piece_q && !still);
      if (valid && still) Nowhere : assert (!begins);
      if (last) LastIsActive : assert (active);
      if (was_last_q && !last) FinalStops : assert (!active);
      if (valid && ends && !begins) StopsAtTheEnd : assert (may_stop_q[3] || still);
      if (last) FinalEnds : assert (!next_take);
      if (idle_q == '1) NeverStuck : assert (1'b0);

      BeginsAfterAHold : cover (next_take && !active && held_before_q);
      Passes : cover (valid && begins && event_piece_q == 3'd2);
      Ends : cover (valid && still && event_piece_q == 3'd1);
    end
  end

endmodule
`default_nettype wire
