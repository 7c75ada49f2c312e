// SPDX-License-Identifier: Apache-2.0
// rtl/time/time_scaler.sv for the serial build: the same rates, one tick after the other, by the
// program of rtl/path/time_sequencer.sv on one adder; a rate waits until it is taken.
//
//   clock      0        n
//   valid_i    1
//   ready_o    1        1    at the latest, unless steps are missing
//   target_i   target
//   valid_o             1    n < kSerialScaleClocks of hls/clocks.hpp, until
//   taken_i             1
//   rate_o              rate
//   held_o              target is 0
//
// The bounds are constant while ticks come.
`default_nettype none
module time_scaler_serial (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Bounds, in 2^-32 per tick
    input wire logic [31:0] acceleration_i,  // [8, 2^31]
    input wire logic [32:0] slope_i,         // [acceleration_i, 2^32]

    input  wire logic        valid_i,
    output logic             ready_o,
    input  wire logic [16:0] target_i,   // 16 fraction bits, up to 1
    input  wire logic        land_i,     // lands at once
    output logic             stopping_o, // a branch goes on with the next tick, which may not land

    // Branches: time that a stop from here waits for the next one, or 0; one begins
    input  wire logic [19:0] next_wait_i,
    input  wire logic        begins_i,
    input  wire logic        step_valid_i,
    output logic             step_ready_o,
    input  wire logic [10:0] step_ticks_i,   // [1, 2047]
    input  wire logic [31:0] step_change_i,  // change of the slope in each tick
    input  wire logic        step_last_i,

    output logic             valid_o,
    input  wire logic        taken_i,
    output logic      [16:0] rate_o,
    output logic             held_o,
    output logic             still_o   // the rate rests at 0, until a target is not 0
);

  // The present tick; it passes many gates, and reaches the program a clock later.
  logic idle;
  logic takes;
  logic taken_q;
  logic one_q;  // before the tick the rate rests on 1 again
  logic [16:0] obeyed;
  logic stops;
  logic ends;
  logic [31:0] change;
  logic unused;
  stop_taker u_stop (
      .clk_i,
      .rst_ni,
      .valid_i,
      .room_i(idle && !taken_q),
      .ready_o,
      .taken_o(takes),
      .one_i(one_q),
      .land_i,
      .target_i,
      .obeyed_o(obeyed),
      .stopping_o(unused),
      .goes_on_o(stopping_o),
      .next_wait_i,
      .begins_i,
      .step_valid_i,
      .step_ready_o,
      .step_ticks_i,
      .step_change_i,
      .step_last_i,
      .stop_o(stops),
      .ends_o(ends),
      .change_o(change)
  );

  logic lands_q;  // lands on its target
  logic same_q;  // its target is that of the last tick
  logic [16:0] target_q;
  logic rests;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      taken_q <= 1'b0;
      one_q   <= 1'b0;
    end else begin
      taken_q <= takes;
      if (takes) one_q <= 1'b0;
      else if (rests) one_q <= same_q && target_q[16];
    end
  end
  always_ff @(posedge clk_i) begin
    if (takes) begin
      lands_q  <= land_i;
      same_q   <= obeyed == target_q && !land_i;
      target_q <= obeyed;
      held_o   <= target_i == '0;
    end
  end

  localparam logic [16:0] FineFrom = 17'h0e000;
  logic high;
  logic border;
  logic [16:0] goal;
  assign high = target_q[16] || target_q[15:13] == FineFrom[15:13];
  assign goal = border ? FineFrom : target_q;

  logic [time_control_pkg::Bits-1:0] control;
  logic [time_control_pkg::Bits-1:0] ahead;
  logic fine;
  logic zero;
  logic moves;
  logic [35:0] sum;
  time_sequencer u_sequencer (
      .clk_i,
      .rst_ni,
      .ready_o(idle),
      .tick_i(taken_q),
      .lands_i(lands_q),
      .stops_i(stops),
      .ends_i(ends),
      .high_i(high),
      .sent_o(valid_o),
      .taken_i,
      .control_o(control),
      .ahead_o(ahead),
      .fine_o(fine),
      .border_o(border),
      .negative_i(sum[35]),
      .zero_i(zero),
      .rests_o(rests),
      .moves_o(moves)
  );

  time_datapath u_datapath (
      .clk_i,
      .rst_ni,
      .control_i(control),
      .ahead_i(ahead),
      .fine_i(fine),
      .sum_o(sum),
      .zero_o(zero),
      .acceleration_i,
      .slope_i,
      .goal_i(goal),
      .change_i(change)
  );

  // In a stop below 1, with any steps.
  logic stopping;
  assign stopping = stops && !ends;
  assign rate_o   = stopping ? {1'b0, sum[34:19] | {16{sum[35]}}} : fine ? sum[35:19] : sum[32:16];
  assign still_o  = held_o && zero && !moves && !stopping;

endmodule
`default_nettype wire
