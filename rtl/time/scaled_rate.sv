// SPDX-License-Identifier: Apache-2.0
// Rates of ticks from slopes, changes and places: the slope after a tick is what the rate moves in
// it; at rest it is its place. In a stop on a branch R moves so, from 1 on, by the branch's slope
// S, and the rate is r0 R between two ticks of path time. Twin: rate_, stop_on() of
// hls/time_scaler.hpp.
//
//   clock      0          1          2            3                4
//   tick_i     1
//   .._i       of the tick
//   slope_i               after it
//   valid_o                          1                             1, with stop_i
//   rate_o                           rate                          r0 (R - ahead S)
//   in it                 S          R, ahead S   R - ahead S
//
// A tick per clock; behind one with ends_i two clocks without.
`default_nettype none
module scaled_rate (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic               tick_i,
    input wire logic               lands_i,  // the rate is place_i
    input wire logic               rises_i,
    input wire logic        [16:0] place_i,
    input wire logic signed [35:0] slope_i,  // 32 fraction bits
    input wire logic               held_i,   // its target is 0

    // Stops: rtl/time/stop_taker.sv
    input wire logic        stop_i,
    input wire logic        begins_i,
    input wire logic        ends_i,
    input wire logic        moves_i,
    input wire logic [31:0] change_i,
    input wire logic [16:0] base_i,    // r0, 16 fraction bits
    input wire logic [15:0] ahead_i,   // 16 fraction bits

    output logic        valid_o,
    output logic [16:0] rate_o,   // 16 fraction bits
    output logic        held_o,
    output logic        still_o   // it rests at 0, held
);

  // The rate, or R
  logic ticked_q;
  logic lands_q;
  logic rises_q;
  logic stops_q;
  logic begins_q;
  logic moves_q;
  logic [16:0] place_q;
  logic [15:0] ahead_q;
  logic signed [35:0] stop_slope_q;
  logic signed [35:0] from;
  logic signed [35:0] move;
  logic signed [35:0] rate_q;
  assign from = begins_q ? 36'h1_0000_0000 : rate_q;
  assign move = !stops_q ? slope_i : moves_q ? stop_slope_q : '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ticked_q     <= 1'b0;
      stop_slope_q <= '0;
    end else begin
      ticked_q <= tick_i;
      if (tick_i) begin
        if (!stop_i || ends_i) stop_slope_q <= '0;
        else if (moves_i) stop_slope_q <= stop_slope_q + 36'($signed(change_i));
      end
    end
  end
  always_ff @(posedge clk_i) begin
    lands_q  <= lands_i;
    rises_q  <= rises_i || stop_i;
    stops_q  <= stop_i && !ends_i;
    begins_q <= begins_i;
    moves_q  <= moves_i;
    place_q  <= place_i;
    ahead_q  <= ahead_i;
    if (ticked_q) begin
      if (lands_q) rate_q <= {3'b0, place_q, 16'b0};
      else if (rises_q) rate_q <= from + move;
      else rate_q <= from - move;
    end
  end

  // Between two ticks of path time: 17 fraction bits, below 1
  logic signed [34:0] fall_q;
  logic [17:0] between;
  logic [16:0] below_q;
  logic [16:0] base_q;
  logic signed [35:0] slowed_q;
  assign between = rate_q[32:15] - fall_q[33:16];
  always_ff @(posedge clk_i) begin
    if (tick_i && begins_i) base_q <= base_i;
    fall_q   <= $signed(stop_slope_q[32:15]) * $signed({1'b0, ahead_q});
    below_q  <= between[16:0] | {17{between[17]}};
    slowed_q <= $signed({1'b0, below_q}) * $signed({1'b0, base_q});
  end

  // Ticks of a stop are out two clocks later than others. Behind its last one there is a gap as
  // long: rtl/time/time_scaler.sv.
  logic [2:0] valid_q;
  logic [3:0] late_q;
  logic [3:0] held_q;
  logic [2:0] still_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= {valid_q[1:0], ticked_q};
  end
  always_ff @(posedge clk_i) begin
    late_q  <= {late_q[2:0], stop_i};
    held_q  <= {held_q[2:0], held_i};
    still_q <= {still_q[1:0], held_q[0] && place_q == '0 && lands_q};
  end
  logic late;
  assign late    = valid_q[2] && late_q[3];
  assign valid_o = late || (valid_q[0] && !late_q[1]);
  assign rate_o  = late ? slowed_q[33:17] : rate_q[32:16];
  assign held_o  = late ? held_q[3] : held_q[1];
  assign still_o = late ? still_q[2] : still_q[0];

  logic unused;
  assign unused = ^{fall_q[34], fall_q[15:0], slowed_q[35:34], slowed_q[16:0], stop_slope_q[14:0]};

endmodule
`default_nettype wire
