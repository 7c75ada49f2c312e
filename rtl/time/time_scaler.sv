// SPDX-License-Identifier: Apache-2.0
// The rate of time follows its target with bounded slope and bounded change of slope. Twin:
// hls/time_scaler.hpp, tick by tick.
//
//   clock      0        3
//   valid_i    1
//   ready_o    1
//   target_i   target
//   steady_o   time rests in it
//   passed_o   a tick of path time begins in it
//   valid_o             1        at the earliest; in a stop by a branch two clocks later
//   rate_o              rate
//   held_o              target is 0
//
// One tick per clock. A tick whose target differs from the one before waits 4 clocks more; 4 more
// each when the rate reverses and when it arrives, 7 when it passes 7/8, where it rests: from
// there on an eighth of the bounds holds. A tick with land_i, as the first one after a reset, is on
// its target at once; it comes when the rates of all before it are out. The tick after it, or after
// the end of a branch, waits 2 clocks more. The bounds are constant from the last two clocks of a
// reset on. Bounds outside their ranges do no harm while every target is 0: then so is every rate.
//
// The decisions are signs of two margins, kept up to date instead of computed:
//
//     faster  >= 0: may go faster             rest - braking - 2 slope - acceleration
//     steady  >= 0: may keep its slope        rest - braking - slope
//
// with rest the way to the target in the present direction, braking the way that braking takes.
//
// A stop by a branch leaves them unchanged: rtl/time/stop_taker.sv.
`default_nettype none
module time_scaler (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Bounds, in 2^-32 per tick
    input wire logic [31:0] acceleration_i,  // [8, 2^31]
    input wire logic [32:0] slope_i,         // [acceleration_i, 2^32]

    input  wire logic        valid_i,
    output logic             ready_o,
    input  wire logic [16:0] target_i,    // 16 fraction bits, up to 1
    input  wire logic        land_i,      // lands at once
    output logic             stopping_o,  // a branch goes on with the next tick, which may not land
    output logic             steady_o,
    output logic             passed_o,

    // Branches: time that a stop from here waits for the next one, or 0; one begins
    input  wire logic [19:0] next_wait_i,
    input  wire logic        begins_i,
    input  wire logic        step_valid_i,
    output logic             step_ready_o,
    input  wire logic [10:0] step_ticks_i,   // [1, 2047]
    input  wire logic [31:0] step_change_i,  // change of the slope in each tick
    input  wire logic        step_last_i,

    output logic        valid_o,
    output logic [16:0] rate_o,
    output logic        held_o,
    output logic        still_o   // the rate rests at 0, until a target is not 0
);

  // The present tick, and the difference of its target.
  logic head_valid_q;
  logic landing_q;  // lands on its target at once
  logic [16:0] target_q;
  logic signed [17:0] delta_q;
  logic change_q;
  logic beyond_q;  // its target is on the other side of 7/8 ..
  logic direct_q;  // .. is not, or is that
  logic same_q;
  logic zero_q;  // its target is 0, obeyed or not

  // Change adds to both margins: load an operand, give it its sign, add it. Clear and Init begin
  // with other bounds, at rest.
  typedef enum logic [2:0] {
    Clear,
    Init,
    Run,
    Sign,
    Load,
    Add
  } state_t;
  state_t             state_q;

  logic signed [35:0] faster_q;
  logic signed [35:0] steady_q;
  logic signed [35:0] slope_q;  // n a
  logic signed [35:0] next_slope_q;  // slope + a
  logic signed [35:0] faster_cost_q;  // 2 slope + 3 a
  logic               rising_q;
  logic               at_rest_q;
  logic               at_max_q;
  logic               arrived_q;  // at rest on the target
  logic               arriving_q;
  logic               short_q;  // the way to it is not zero
  logic               settling_q;  // the last tick went it: the next one rests

  // The bounds on this side of 7/8
  localparam logic [16:0] FineFrom = 17'h0e000;
  function automatic logic is_fine(input logic [16:0] rate);
    is_fine = rate[16] || rate[15:13] == FineFrom[15:13];
  endfunction
  logic fine_q;
  logic signed [35:0] a;
  logic signed [35:0] a2;
  logic signed [35:0] max_slope;
  assign a = {4'b0, fine_q ? {3'b0, acceleration_i[31:3]} : acceleration_i};
  assign a2 = {a[34:0], 1'b0};
  assign max_slope = {3'b0, fine_q ? {3'b0, slope_i[32:3]} : slope_i};
  // The highest slope from which two steps do not pass the bound.
  logic signed [35:0] below_max_q;
  always_ff @(posedge clk_i) below_max_q <= max_slope - a2;

  // Decisions
  logic change;
  logic turns;
  logic turn;
  logic arrives;
  logic arrive;
  logic swaps;
  logic swap;
  logic tick;
  logic head_ends;
  logic anew;
  logic up;
  logic steady;
  logic no_brake;
  assign turns    = at_rest_q && steady_q[35] && !settling_q;
  assign arrives  = at_rest_q && faster_q[35] && !settling_q && !arrived_q;
  assign swaps    = at_rest_q && beyond_q && arrived_q && !short_q && !settling_q;
  assign change   = state_q == Run && head_valid_q && change_q;
  assign turn     = state_q == Run && !(head_valid_q && change_q) && turns;
  assign arrive   = state_q == Run && head_valid_q && !change_q && !turns && arrives;
  assign swap     = state_q == Run && head_valid_q && !change_q && !turns && swaps;
  assign tick     = state_q == Run && head_valid_q && !change_q && !turns && !arrives && !swaps;
  assign anew     = tick && (landing_q || head_ends);
  assign up       = !faster_q[35] && !at_max_q && !settling_q;
  assign no_brake = !steady_q[35] || settling_q;
  assign steady   = !up && no_brake;

  logic [16:0] goal_q;
  logic        head_stop;
  logic        head_begins;
  logic        head_moves;
  logic [31:0] head_change;
  logic [16:0] head_base;
  logic [15:0] head_ahead;
  logic        room;
  logic        takes;
  logic        stopping;
  logic [16:0] obeyed;
  logic        fast_q;  // the head's target is BranchRate or more
  logic        arrived;
  logic        rests;
  logic        rests_q;
  assign arrived = landing_q || (same_q && arrived_q && !short_q && direct_q && !head_stop);
  assign rests   = tick ? arrived && fast_q : rests_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) rests_q <= 1'b0;
    else if (tick) rests_q <= rests;
    if (takes) fast_q <= obeyed >= 17'(words_pkg::BranchRate);
  end

  assign room = !head_valid_q || tick;
  stop_taker u_stop (
      .clk_i,
      .rst_ni,
      .valid_i,
      .room_i(room),
      .ready_o,
      .taken_o(takes),
      .rests_i(rests),
      .land_i,
      .target_i,
      .obeyed_o(obeyed),
      .stopping_o(stopping),
      .goes_on_o(stopping_o),
      .steady_o,
      .passed_o,
      .next_wait_i,
      .begins_i,
      .step_valid_i,
      .step_ready_o,
      .step_ticks_i,
      .step_change_i,
      .step_last_i,
      .stop_o(head_stop),
      .begins_o(head_begins),
      .ends_o(head_ends),
      .moves_o(head_moves),
      .change_o(head_change),
      .base_o(head_base),
      .ahead_o(head_ahead)
  );

  logic        high;
  logic [16:0] aim;
  logic [16:0] wish;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      head_valid_q <= 1'b0;
      change_q     <= 1'b0;
    end else begin
      if (room) head_valid_q <= takes;
      if (takes) change_q <= aim != goal_q && !land_i && !stopping;
      else if (state_q == Clear) change_q <= aim != goal_q;
      else if (change) change_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (takes) begin
      landing_q <= land_i;
      same_q    <= obeyed == target_q && !land_i;
      target_q  <= obeyed;
      zero_q    <= target_i == '0;
    end
    if (takes || state_q == Clear) begin
      beyond_q <= high != fine_q && !(takes && (land_i || stopping));
      direct_q <= high == fine_q || wish == FineFrom;
      delta_q  <= $signed({1'b0, aim}) - $signed({1'b0, goal_q});
    end
  end

  // The next aim of the rate: the target, or first 7/8.
  assign wish = room ? obeyed : target_q;
  assign high = is_fine(wish);
  assign aim  = high == fine_q ? wish : FineFrom;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) fine_q <= 1'b0;
    else if (anew) fine_q <= is_fine(target_q);
    else if (swap) fine_q <= !fine_q;
    if (anew) goal_q <= target_q;
    else if (change) goal_q <= aim;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) state_q <= Clear;
    else
      case (state_q)
        Clear: state_q <= Init;
        Run:
        if (swap || anew) state_q <= Clear;
        else if (change || turn || arrive) state_q <= Sign;
        Sign: state_q <= Load;
        Load: state_q <= Add;
        default: state_q <= Run;
      endcase
  end

  // Braking adds 2 a and a to the margins; so do the operands of a change in their time, and the
  // first values of all: -a, 0 and 3 a.
  logic signed [35:0] operand_q;
  logic negative_q;
  logic signed [35:0] faster_add_q;
  logic signed [35:0] steady_add_q;
  logic signed [35:0] cost_add_q;
  logic signed [35:0] signed_q;
  always_ff @(posedge clk_i) begin
    if (change) operand_q <= {{2{delta_q[17]}}, delta_q, 16'b0};
    else if (turn) operand_q <= {steady_q[34:0], 1'b0};
    else operand_q <= steady_q;
    negative_q <= !(change && rising_q);
    signed_q   <= negative_q ? -operand_q : operand_q;
    if (state_q == Clear) begin
      faster_add_q <= -a;
      steady_add_q <= '0;
      cost_add_q   <= a2 + a;
    end else if (state_q == Load) begin
      faster_add_q <= signed_q;
      steady_add_q <= signed_q;
    end else begin
      faster_add_q <= a2;
      steady_add_q <= a;
      cost_add_q   <= a2;
    end
  end

  // Each sum is ready before the decision: the mux comes last.
  logic signed [35:0] faster_up;
  logic signed [35:0] faster_steady;
  logic signed [35:0] faster_add;
  logic signed [35:0] steady_up;
  logic signed [35:0] steady_steady;
  logic signed [35:0] steady_add;
  assign faster_up     = faster_q - faster_cost_q;
  assign faster_steady = faster_q - slope_q;
  assign faster_add    = faster_q + faster_add_q;
  assign steady_up     = steady_q - {next_slope_q[34:0], 1'b0};
  assign steady_steady = steady_q - slope_q;
  assign steady_add    = steady_q + steady_add_q;

  logic signed [35:0] next_slope_up;
  logic signed [35:0] slope_down;
  logic signed [35:0] cost_up;
  logic signed [35:0] cost_down;
  assign next_slope_up = next_slope_q + a;
  assign slope_down    = slope_q - a;
  assign cost_up       = faster_cost_q + cost_add_q;
  assign cost_down     = faster_cost_q - a2;
  logic last_step;
  logic last_rise;
  assign last_step = slope_q == a;
  assign last_rise = below_max_q < slope_q;

  logic adds;
  logic margins_up;
  logic margins_steady;
  logic slope_up;
  logic slope_moves;
  assign adds           = state_q == Init || state_q == Add;
  assign margins_up     = state_q == Run && up;
  assign margins_steady = state_q == Run && no_brake;
  assign slope_up       = state_q == Init || up;
  assign slope_moves    = state_q == Init || (tick && !steady);

  always_ff @(posedge clk_i) begin
    if (state_q == Clear) begin
      faster_q      <= '0;
      steady_q      <= '0;
      slope_q       <= '0;
      next_slope_q  <= '0;
      faster_cost_q <= '0;
    end else begin
      if (adds || tick) begin
        faster_q <= margins_up ? faster_up : margins_steady ? faster_steady : faster_add;
        steady_q <= margins_up ? steady_up : margins_steady ? steady_steady : steady_add;
      end
      if (slope_moves) begin
        slope_q       <= slope_up ? next_slope_q : slope_down;
        next_slope_q  <= slope_up ? next_slope_up : slope_q;
        faster_cost_q <= slope_up ? cost_up : cost_down;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (state_q == Clear) begin
      rising_q   <= 1'b1;
      at_rest_q  <= 1'b1;
      at_max_q   <= 1'b0;
      arrived_q  <= 1'b1;
      arriving_q <= 1'b0;
      short_q    <= 1'b0;
      settling_q <= 1'b0;
    end else begin
      if (turn) rising_q <= !rising_q;
      if (tick && !steady) begin
        at_rest_q <= !up && last_step;
        at_max_q  <= up && last_rise;
      end
      if (change || (tick && up)) arrived_q <= 1'b0;
      else if (arrive) arrived_q <= 1'b1;
      if (arrive) arriving_q <= 1'b1;
      else if (state_q == Add) arriving_q <= 1'b0;
      if (arriving_q && state_q == Sign) short_q <= operand_q != 36'sd0;
      else if (tick) short_q <= 1'b0;
      if (tick) settling_q <= short_q;
    end
  end

  scaled_rate u_rate (
      .clk_i,
      .rst_ni,
      .tick_i  (tick),
      .lands_i (landing_q || (head_stop ? head_ends : at_rest_q && !up && !settling_q)),
      .rises_i (rising_q),
      .place_i (landing_q || head_stop ? target_q : goal_q),
      .slope_i (slope_q),
      .held_i  (zero_q),
      .stop_i  (head_stop),
      .begins_i(head_begins),
      .ends_i  (head_ends),
      .moves_i (head_moves),
      .change_i(head_change),
      .base_i  (head_base),
      .ahead_i (head_ahead),
      .valid_o,
      .rate_o,
      .held_o,
      .still_o
  );

endmodule
`default_nettype wire
