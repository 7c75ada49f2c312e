// SPDX-License-Identifier: Apache-2.0
// rtl/time/standstill.sv: while it reports that the machine stands, no sample moves that was
// requested at least two clocks before and did not leave; where it could report this, it does. One
// sample, any, is followed. A tick moves its samples when a program is under way, or begins in it,
// and the rate of time does not rest.
// control: RESTS_TOO_SOON s/ \&\& ahead_q == '0//
// control: RESTS_IN_MOTION s/ \&\& !active_i//
// control: FORGETS_A_TICK s/ \&\& open_q == '0//
// control: COUNTS_NO_SAMPLES s/rests_q \&\& left_q == '0/rests_q/
// control: NEVER_FALLS s/if (starts) rests_q <= 1'b0/if (1'b0) rests_q <= 1'b0/
// control: LOSES_A_SAMPLE s/left_q <= under_way_d/left_q <= under_way_q/
// control: NO_RESET s/ rests_q     <= 1'b1;//
`default_nettype none
module standstill_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic asked_i,
    input wire logic first_i,   // a tick starts with the sample of asked_i
    input wire logic stops_i,   // the target of the tick is 0
    input wire logic scaled_i,
    input wire logic still_i,
    input wire logic taken_i,
    input wire logic begin_i,   // a program, with taken_i
    input wire logic end_i,
    input wire logic leaves_i,
    input wire logic mark_i     // the sample asked for is the one that is followed
);

  localparam int Ticks = 4;
  localparam int Samples = 6;

  // Ticks in order, that are not taken yet, the oldest in bit 0: the first scaled_q have a rate.
  logic [Ticks-1:0] stops_q;
  logic [Ticks-1:0] rate_rests_q;
  logic [2:0] ticks_q;
  logic [2:0] scaled_q;
  logic first;
  logic tick_q;
  logic tick_stops_q;
  logic scaled;
  logic held;
  logic taken;
  assign first  = asked_i && first_i;
  // A clock after its tick_i at the earliest
  assign scaled = scaled_i && ticks_q > scaled_q + {2'b0, tick_q};
  assign held   = stops_q[scaled_q[1:0]];
  assign taken  = taken_i && scaled_q != '0;

  logic active_q;
  logic standing;
  standstill u_dut (
      .clk_i,
      .rst_ni,
      .tick_i(tick_q),
      .stops_i(tick_stops_q),
      .scaled_i(scaled),
      .held_i(held),
      .still_i(still_i && held),
      .started_i({2'b0, ticks_q}),
      .taken_i(taken),
      .active_i(active_q),
      .asked_i,
      .leaves_i,
      .standing_o(standing)
  );

  // The rate rests from a tick that is still to the next with another target.
  logic rests_q;
  logic rests;
  logic active;
  logic moves;
  logic moved_q;  // the last tick taken
  assign rests  = held && (still_i || rests_q);
  assign active = active_q || (begin_i && !stops_q[0]);
  assign moves  = active && !rate_rests_q[0];

  logic [2:0] under_way_q;
  logic followed_q;  // the sample is under way
  logic [2:0] place_q;  // of it, among those under way: they leave first, with it
  logic [2:0] tick_place_q;  // the same of its tick, 0: taken
  logic moves_q;  // it does
  logic [1:0] age_q;  // clocks since it was asked for, 3 at most
  logic stood_q;  // meanwhile it was reported to stand
  logic resolved;
  assign resolved = followed_q && tick_place_q == 3'd1 && taken;
  logic [3:0] calm_q;
  logic started_q = 1'b0;
  logic idle_stop_q;  // the last tick is held, as all not taken, and came when all was idle

  logic active_d;
  assign active_d = taken ? active && !end_i : active_q;
  logic all_stop;
  assign all_stop = ((taken ? stops_q >> 1 : stops_q) | ({Ticks{1'b1}} << ticks_d)) == '1;
  logic [2:0] ticks_d;
  assign ticks_d = ticks_q - {2'b0, taken};
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    tick_stops_q <= stops_i;
    if (!rst_ni) begin
      tick_q       <= 1'b0;
      ticks_q      <= '0;
      scaled_q     <= '0;
      active_q     <= 1'b0;
      rests_q      <= 1'b1;
      moved_q      <= 1'b0;
      under_way_q  <= '0;
      followed_q   <= 1'b0;
      tick_place_q <= '0;
      age_q        <= '0;
      stood_q      <= 1'b0;
      calm_q       <= '0;
      idle_stop_q  <= 1'b1;
    end else begin
      tick_q <= first;
      if (scaled) rate_rests_q[scaled_q[1:0]] <= rests;
      if (taken) begin
        stops_q      <= {1'b0, stops_q[Ticks-1:1]};
        rate_rests_q <= {1'b0, rate_rests_q[Ticks-1:1]};
        if (scaled) rate_rests_q[scaled_q[1:0]-2'd1] <= rests;
      end
      if (first) stops_q[ticks_d[1:0]] <= stops_i;
      if (first) idle_stop_q <= stops_i && (idle_stop_q || (all_stop && !active_d));
      ticks_q  <= ticks_d + {2'b0, first};
      scaled_q <= scaled_q + {2'b0, scaled} - {2'b0, taken};
      if (scaled) rests_q <= rests;
      active_q <= active_d;
      if (taken) moved_q <= moves;
      under_way_q <= under_way_q + {2'b0, asked_i} - {2'b0, leaves_i};

      if (!followed_q && asked_i && mark_i) begin
        followed_q   <= 1'b1;
        place_q      <= under_way_q + 3'd1 - {2'b0, leaves_i};
        tick_place_q <= ticks_d + {2'b0, first};
        moves_q      <= (taken ? moves : moved_q) && ticks_d == '0 && !first;
        age_q        <= '0;
        stood_q      <= 1'b0;
      end else if (followed_q) begin
        if (leaves_i) place_q <= place_q - 3'd1;
        if (leaves_i && place_q == 3'd1) followed_q <= 1'b0;
        if (taken && tick_place_q != '0) tick_place_q <= tick_place_q - 3'd1;
        if (resolved) moves_q <= moves;
        if (age_q != '1) age_q <= age_q + 2'd1;
        if (age_q >= 2'd2 && standing) stood_q <= 1'b1;
      end
      calm_q <= (asked_i || under_way_q != '0 || ticks_q != '0 || tick_q ||
                 !(rests_q || idle_stop_q)) ? '0 : {calm_q[2:0], 1'b1};
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (ticks_q == 3'(Ticks)) assume (!first);
      if (under_way_q == 3'(Samples)) assume (!asked_i);
      if (under_way_q == '0) assume (!leaves_i);
      // A sample leaves when its tick is taken.
      if (followed_q && place_q == 3'd1 && tick_place_q != '0) assume (!leaves_i);

      if (resolved && moves) ItDoesNotStand : assert (!stood_q && !(age_q >= 2'd2 && standing));
      if (followed_q && tick_place_q == '0 && moves_q && age_q >= 2'd2)
        NorUntilItLeft : assert (!standing);
      if (calm_q == '1) Stands : assert (standing);

      StandsWithSamplesUnderWay :
      cover (standing && followed_q && age_q == '1 && place_q == 3'd3 && tick_place_q == 3'd2);
      StandsWhileTimeRuns : cover (standing && !rests_q);
      MovesAgain : cover (followed_q && moves_q && tick_place_q == '0);
    end
  end

endmodule
`default_nettype wire
