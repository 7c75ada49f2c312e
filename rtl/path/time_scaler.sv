// SPDX-License-Identifier: Apache-2.0
// Time's rate follows its target with bounded slope and bounded change of slope. Twin:
// hls/time_scaler.hpp.
//
//   clock      0        1
//   valid_i    1
//   target_i   target
//   valid_o             1
//   rate_o              rate       one tick per clock
//
// Reset: rate 1. acceleration_i and slope_i stand still while ticks run.
`default_nettype none
module time_scaler (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Bounds, in 2^-32 per tick
    input wire logic [31:0] acceleration_i,  // [1, 2^31]
    input wire logic [32:0] slope_i,         // a multiple of acceleration_i, up to 2^32

    input  wire logic        valid_i,
    input  wire logic [16:0] target_i,  // 16 fraction bits, up to 1
    output logic             valid_o,
    output logic      [16:0] rate_o
);

  logic signed [35:0] rate_q;
  logic signed [35:0] slope_q;
  logic signed [35:0] braking_q;
  logic rising_q;

  logic signed [35:0] acceleration;
  assign acceleration = {4'b0, acceleration_i};
  logic signed [35:0] slope_bound;
  assign slope_bound = {3'b0, slope_i};
  logic signed [35:0] distance;
  assign distance = $signed({3'b0, target_i, 16'b0}) - rate_q;
  logic at_rest;
  assign at_rest = slope_q == 36'sd0;
  logic rising;
  assign rising = at_rest ? !distance[35] : rising_q;
  logic signed [35:0] rest;
  assign rest = rising ? distance : -distance;

  logic signed [35:0] hold_need;
  assign hold_need = braking_q + slope_q;
  logic signed [35:0] faster;
  assign faster = slope_q + acceleration;
  logic signed [35:0] slower;
  assign slower = slope_q - acceleration;
  logic signed [35:0] speed_need;
  assign speed_need = hold_need + faster;

  logic signed [35:0] move;
  logic signed [35:0] slope;
  logic signed [35:0] braking;
  always_comb begin
    slope   = slope_q;
    braking = braking_q;
    move    = slope_q;
    if (at_rest && rest < acceleration) begin
      move = rest;
    end else if (slope_q < slope_bound && rest >= speed_need) begin
      slope   = faster;
      braking = hold_need;
      move    = faster;
    end else if (rest < hold_need) begin
      slope   = slower;
      braking = braking_q - slower;
      move    = slower;
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_o   <= 1'b0;
      rate_q    <= 36'sh1_0000_0000;
      slope_q   <= '0;
      braking_q <= '0;
      rising_q  <= 1'b1;
    end else begin
      valid_o <= valid_i;
      if (valid_i) begin
        rate_q    <= rising ? rate_q + move : rate_q - move;
        slope_q   <= slope;
        braking_q <= braking;
        rising_q  <= rising;
      end
    end
  end
  assign rate_o = rate_q[32:16];

endmodule
`default_nettype wire
