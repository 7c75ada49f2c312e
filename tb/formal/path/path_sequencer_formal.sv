// SPDX-License-Identifier: Apache-2.0
// rtl/path/path_sequencer.sv, for any sum of the datapath: every tick that comes is taken once and
// gives one increment, one after the other; pieces begin only when they are loaded, and with a
// tick; time waits where no piece is queued, no program begins in a tick that is held; memory words
// of the present piece are read inside programs only; no tick exceeds its clocks.
// control: LOSES_TICK s/rate_ready_o = .*;/rate_ready_o = 1'b1;/
// control: TAKES_MISSING s/holds = !next_valid_i/holds = 1'b0/
// control: SKIPS_QUEUED s/ || !queued_i;/ || !next_valid_i;/
// control: BEGINS_HELD s/(held_q \&\& !active_o)/1'b0/
// control: RUNS_ON s/active_o \&\& !last_o/active_o/
// control: DROPS s/holds = !ds_ready_i/holds = 1'b0/
// control: NO_INCREMENT s/ds_valid_o   = .*;/ds_valid_o = 1'b0;/
// control: LONG_PRODUCT s/-7'd15/-7'd19/
// control: NO_RESET s/      .rst_ni,/      .rst_ni(1'b1),/
// forget: held_q u_dut.held_q unless waiting_q
// forget: active_then_q unless owed_q
`default_nettype none
module path_sequencer_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic rate_valid_i,
    input wire logic held_i,
    input wire logic queued_i,
    input wire logic next_valid_i,
    input wire logic next_final_i,
    input wire logic negative_i,
    input wire logic ds_ready_i
);

  logic next_take;
  logic rate_ready;
  logic taken;
  logic [16:0] rate;
  logic [path_control_pkg::Bits-1:0] control;
  logic [path_control_pkg::Bits-1:0] ahead;
  logic [1:0] pass;
  logic ds_valid;
  logic ds_active;
  logic look;
  logic active;
  logic last;
  path_sequencer u_dut (
      .clk_i,
      .rst_ni,
      .queued_i,
      .next_valid_i,
      .next_take_o(next_take),
      .next_final_i,
      .next_time_exponent_i(5'd0),
      .next_exponent_i(6'd34),
      .rate_valid_i,
      .rate_ready_o(rate_ready),
      .rate_i(17'd0),
      .held_i,
      .tick_taken_o(taken),
      .rate_o(rate),
      .control_o(control),
      .ahead_o(ahead),
      .pass_o(pass),
      .negative_i,
      .ds_valid_o(ds_valid),
      .ds_ready_i,
      .ds_active_o(ds_active),
      .look_o(look),
      .active_o(active),
      .last_o(last)
  );
  logic unused;
  assign unused = ^{rate, control, ahead, pass, look};

  logic started_q = 1'b0;
  logic kept_next_q;
  logic kept_final_q;
  logic kept_queued_q;
  logic waiting_q;  // a tick came that was not taken yet
  logic owed_q;  // one was taken that gave no increment yet
  logic held_q;  // of the tick
  logic active_then_q;  // when it was taken, or a piece began with it
  logic was_last_q;
  logic was_active_q;
  logic [6:0] clocks_q;  // since it came, without those in which its piece is not loaded
  always_ff @(posedge clk_i) begin
    started_q     <= 1'b1;
    kept_next_q   <= rst_ni && next_valid_i && !next_take;
    kept_queued_q <= rst_ni && queued_i && !next_take;
    kept_final_q  <= next_final_i;
    was_last_q    <= rst_ni && last;
    was_active_q  <= rst_ni && active;
    if (!rst_ni) begin
      waiting_q <= 1'b0;
      owed_q    <= 1'b0;
      clocks_q  <= '0;
    end else begin
      if (rate_ready && rate_valid_i) begin
        waiting_q <= 1'b1;
        held_q    <= held_i;
      end else if (taken) begin
        waiting_q <= 1'b0;
      end
      if (taken) begin
        owed_q        <= 1'b1;
        active_then_q <= active || next_take;
      end else if (ds_valid && ds_ready_i) begin
        owed_q <= 1'b0;
      end
      if ((!waiting_q && !owed_q) || ds_valid) clocks_q <= '0;
      else if (!waiting_q || next_valid_i || !queued_i) clocks_q <= clocks_q + 1'b1;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (kept_next_q) assume (next_valid_i && next_final_i == kept_final_q);
      if (kept_queued_q || next_valid_i) assume (queued_i);

      if (rate_ready) OneAtATime : assert (!waiting_q && !owed_q);
      if (taken) TakesWhatCame : assert (waiting_q && !owed_q);
      if (ds_valid) IncrementPerTick : assert (owed_q && ds_active == active_then_q);
      if (next_take) TakesLoaded : assert (next_valid_i && taken);
      if (next_take && !active) BeginsFree : assert (!held_q);
      if (taken && !next_take && active && !negative_i) Waits : assert (last || !queued_i);
      if (last) LastIsActive : assert (active);
      if (was_last_q && !last) FinalStops : assert (!active);
      if (was_active_q && !active) StopsAtFinal : assert (was_last_q);
      if (last) FinalEnds : assert (!next_take);
      InTime : assert (clocks_q < 7'd101);

      Passes : cover (next_take && active);
      Begins : cover (next_take && !active);
      Ends : cover (ds_valid && ds_active && !active);
    end
  end

endmodule
`default_nettype wire
