// SPDX-License-Identifier: Apache-2.0
// rtl/time/idle_gate.sv, before a scaler and a path generator of any latency in which programs
// begin and end at any tick. One tick, any, is watched, with those before it in their order, which
// the gate does not know: as it is taken, it lands if and only if no program was under way after
// each of the 16 before it, its target or one since the last landing was new, and no stop was under
// way. So no tick lands in a motion. And none waits for ever.
// control: LANDS_IN_MOTION s/ \&\& !active_i//
// control: LANDS_EARLY s/idle_q == Count'(Idle) \&\& !stopping_i/!stopping_i/
// control: LANDS_UNKNOWN s/assign known .*/assign known = 1'b1;/
// control: FORGETS_A_TICK s/ahead_q == '0 \&\& !taken_q/ahead_q == '0/
// control: LANDS_IN_A_STOP s/ \&\& !stopping_i;/;/
// control: NEVER_LANDS s/land_o   = may_land/land_o   = 1'b0/
// control: SETTLES s/unsettled_q <= !land_o \&\& /unsettled_q <= 1'b0 \&\& /
// control: WAITS_IN_MOTION s/waits    = may_land \&\& !known/waits    = !known/
`default_nettype none
module idle_gate_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic valid_i,
    input wire logic differs_i,
    input wire logic ready_i,
    input wire logic stopping_i,
    input wire logic take_i,      // the path generator takes a tick, if there is one
    input wire logic program_i,   // a program is under way behind it
    input wire logic watch_i      // this tick is watched
);

  localparam int Idle = words_pkg::IdleTicks;

  logic ready;
  logic valid;
  logic land;
  logic active_q;
  logic taken;
  logic passes;
  logic [4:0] ahead_q;  // passed and not taken
  assign taken  = take_i && ahead_q != '0;
  assign passes = valid && ready_i;
  idle_gate u_dut (
      .clk_i,
      .rst_ni,
      .valid_i,
      .ready_o(ready),
      .differs_i,
      .valid_o(valid),
      .ready_i,
      .land_o(land),
      .stopping_i,
      .tick_taken_i(taken),
      .active_i(active_q)
  );

  logic started_q = 1'b0;
  logic [4:0] idle_q;  // ticks taken without a program since the last with one, Idle at most
  logic new_q;  // targets have changed since a tick landed
  logic watched_q;  // the watched tick is under way, behind before_q others
  logic [4:0] before_q;
  logic landed_q;
  logic due_q;  // it was to land, if nothing is under way
  logic kept_q;
  logic [2:0] still_q;  // clocks in which all ahead are taken and it does not pass
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    kept_q    <= rst_ni && valid_i && !ready;
    if (!rst_ni) begin
      active_q  <= 1'b0;
      ahead_q   <= '0;
      idle_q    <= 5'(Idle);
      new_q     <= 1'b1;
      watched_q <= 1'b0;
      still_q   <= '0;
    end else begin
      ahead_q <= ahead_q + {4'd0, passes} - {4'd0, taken};
      if (taken) active_q <= program_i;
      if (taken) idle_q <= program_i ? '0 : (idle_q == 5'(Idle)) ? idle_q : idle_q + 1'b1;
      if (passes) new_q <= !land && (new_q || differs_i);
      if (passes && watch_i && !watched_q) begin
        watched_q <= 1'b1;
        before_q  <= ahead_q - {4'd0, taken};
        landed_q  <= land;
        due_q     <= (new_q || differs_i) && !stopping_i;
      end else if (watched_q && taken) begin
        before_q <= before_q - 1'b1;
        if (before_q == '0) watched_q <= 1'b0;
      end
      still_q <= valid_i && ready_i && !ready && ahead_q == '0 ? still_q + 1'b1 : '0;
    end
  end

  // The tick that is taken is the watched one: idle_q is of those before it.
  logic comes;
  assign comes = watched_q && taken && before_q == '0;
  always_comb begin
    if (!started_q) assume (!rst_ni);
    if (started_q && rst_ni) begin
      // Of the ticks started and not yet taken the one at the gate is one: 16 at most.
      if (valid_i) assume (ahead_q < 5'(Idle));
      // An offer stays.
      if (kept_q) assume (valid_i);
      Lands : assert (!comes || landed_q == (due_q && idle_q == 5'(Idle)));
      Goes_on : assert (still_q < 3'd3);
      In_motion : assert (!(active_q && valid_i && ready_i) || ready);
      Landed : cover (comes && landed_q);
      Passed : cover (comes && due_q && !landed_q && !active_q);
      Filled : cover (ahead_q == 5'(Idle - 1) && passes);
    end
  end

endmodule
`default_nettype wire
