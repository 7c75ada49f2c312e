// SPDX-License-Identifier: Apache-2.0
// Aim of a tick of the time scaler: its target, or 0 by a step of a stop branch; and the branches'
// clock.
//
//   clock      0            1
//   valid_i    1
//   room_i     1
//   taken_o    1
//   .._i       of the tick
//   obeyed_o   target
//   steady_o   time rests in it
//   passed_o   a tick of path time begins in it
//   stop_o                  of the tick, until the next one is taken
//
// A stop from a rate at rest begins with a tick in which a branch begins; until then, while one may
// come, time goes on: for StopLead - 1 ticks of path time at least, and for the reported number of
// these. It ends with its last step, on its target.
`default_nettype none
module stop_taker (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic        valid_i,
    input  wire logic        room_i,
    output logic             ready_o,
    output logic             taken_o,
    input  wire logic        rests_i,        // the rate rests on its target, BranchRate or more
    input  wire logic        land_i,         // it is on its target at once: no stop begins
    input  wire logic [16:0] target_i,
    output logic      [16:0] obeyed_o,
    output logic             stopping_o,
    output logic             goes_on_o,      // the stop of the last tick continues
    output logic             steady_o,
    output logic             passed_o,
    input  wire logic [19:0] next_wait_i,    // input of time_scaler
    input  wire logic        begins_i,
    input  wire logic        step_valid_i,
    output logic             step_ready_o,
    input  wire logic [10:0] step_ticks_i,
    input  wire logic [31:0] step_change_i,
    input  wire logic        step_last_i,

    output logic        stop_o,
    output logic        begins_o,  // the stop begins with it
    output logic        ends_o,    // .. ends
    output logic        moves_o,   // R moves by a slope that changes by ..
    output logic [31:0] change_o,
    output logic [16:0] base_o,    // the rate that it begins at
    output logic [15:0] ahead_o    // path time from its end to that of R
);

  localparam int LeadBits = $clog2(words_pkg::StopLead);
  logic [19:0] wait_q;
  logic short_wait;
  logic held;
  logic waits;
  logic goes_on;
  logic begins;
  logic paced;
  logic stopping_q;
  logic new_step;
  logic [10:0] left_q;  // ticks of path time of the present step
  logic last_q;
  logic [10:0] left;
  logic ends;
  logic new_ends;
  logic old_ends;
  assign new_ends   = step_last_i && step_ticks_i == 11'd1;
  assign old_ends   = last_q && left_q == 11'd1;
  assign held       = rests_i && target_i == '0 && !land_i;
  assign waits      = held && wait_q != '0;
  assign short_wait = wait_q[19:LeadBits] == '0;
  assign begins     = held && begins_i && next_wait_i != '0 && !stopping_q;
  assign stopping_o = stopping_q || begins;
  assign goes_on_o  = stopping_q;
  assign obeyed_o   = stopping_o ? '0 : waits ? base_o : target_i;

  // The branches' clock goes on by base_o where time rests, and in stops.
  logic signed [17:0] ahead_q;  // of a tick that does so
  logic [15:0] ahead;
  assign goes_on      = rests_i && !land_i && !begins && (waits || target_i == base_o);
  assign steady_o     = land_i ? target_i >= 17'(words_pkg::BranchRate) : goes_on;
  assign paced        = goes_on || stopping_o;
  assign passed_o     = ahead_q[17] || !paced;
  assign ahead        = paced ? ahead_q[15:0] : '0;

  assign new_step     = ahead_q[17] && (begins || left_q == '0);
  assign left         = (new_step ? step_ticks_i : left_q) - 11'(ahead_q[17]);
  assign ends         = stopping_o && ahead_q[17] && (new_step ? new_ends : old_ends);

  assign ready_o      = room_i && !(stopping_o && new_step && !step_valid_i);
  assign taken_o      = ready_o && valid_i;
  assign step_ready_o = room_i && valid_i && stopping_o && new_step;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      stopping_q <= 1'b0;
      wait_q     <= 20'(words_pkg::StopLead - 1);
    end else if (taken_o) begin
      stopping_q <= stopping_o && !ends;
      if (next_wait_i != '0) wait_q <= next_wait_i;
      else if (steady_o && (waits || !short_wait)) wait_q <= wait_q - 20'(passed_o);
      else if (short_wait) wait_q <= 20'(words_pkg::StopLead - 1);
    end
  end
  always_ff @(posedge clk_i) begin
    if (taken_o) begin
      left_q <= stopping_o ? left : '0;
      if (stopping_o && new_step) begin
        change_o <= step_change_i;
        last_q   <= step_last_i;
      end
      stop_o   <= stopping_o;
      begins_o <= begins;
      ends_o   <= ends;
      moves_o  <= passed_o;
      ahead_o  <= ahead;
      ahead_q  <= {2'b0, ahead} - {1'b0, stopping_o ? base_o : obeyed_o};
      if (!stopping_o) base_o <= obeyed_o;
    end
  end

endmodule
`default_nettype wire
