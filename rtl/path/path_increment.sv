// SPDX-License-Identifier: Apache-2.0
// The path's increment, in quanta, from a piece's polynomial. Twin: the end of PathKernel::tick of
// hls/path_kernel.hpp.
//
//     path = min(max(floor(d 2^(exponent - 34) + 1/2), path before), ds)
//
//   clock      0        11
//   valid_i    1
//   d_i, ..    event
//   valid_o             1
//   ds_o                increment
//
// Events as in rtl/path/piece_clock.sv, one per clock.
`default_nettype none
module path_increment (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic               valid_i,
    input wire logic               begin_i,
    input wire logic               still_i,
    input wire logic               end_i,
    input wire logic signed [35:0] d_i,         // 34 fraction bits, in units of 2^exponent
    input wire logic        [ 5:0] exponent_i,  // [0, 46]
    input wire logic        [47:0] ds_i,        // ds of the piece
    input wire logic        [17:0] rate_i,      // bit 17 above the rate: a program is under way

    output logic        valid_o,
    output logic [47:0] ds_o,
    output logic [17:0] rate_o
);

  // Words that travel along: index n belongs to the stage that index n - 1 feeds.
  localparam int Stages = 11;
  logic [Stages:1] valid_q;
  logic [9:1] begin_q;
  logic [8:1] still_q;
  logic [5:1] end_q;
  logic [17:0] rate_q[1:Stages];
  logic [47:0] ds_q[1:8];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= {valid_q[Stages-1:1], valid_i};
  end
  always_ff @(posedge clk_i) begin
    begin_q <= {begin_q[8:1], begin_i};
    still_q <= {still_q[7:1], still_i};
    end_q <= {end_q[4:1], end_i};
    rate_q[1] <= rate_i;
    ds_q[1] <= ds_i;
    for (int n = 2; n <= Stages; n++) rate_q[n] <= rate_q[n-1];
    for (int n = 2; n <= 8; n++) ds_q[n] <= ds_q[n-1];
  end

  // 1 .. 4: to quanta, rounded once: two exact floors.
  logic signed [48:0] coarse_q;
  logic signed [48:0] fine_q;
  logic [5:0] shift_1_q;
  logic [2:0] shift_2_q;
  logic signed [35:0] d_q;
  logic signed [48:0] doubled;
  assign doubled = {d_q, 13'b0};
  logic signed [48:0] nearest;
  assign nearest = fine_q + 49'sd1;
  logic signed [48:0] quanta_q;
  always_ff @(posedge clk_i) begin
    d_q       <= d_i;
    shift_1_q <= 6'd46 - exponent_i;
    coarse_q  <= doubled >>> {shift_1_q[5:3], 3'b0};
    shift_2_q <= shift_1_q[2:0];
    fine_q    <= coarse_q >>> shift_2_q;
    quanta_q  <= nearest >>> 1;
  end

  // 5, 6: between the piece's ends.
  logic signed [48:0] ds_4;
  assign ds_4 = {1'b0, ds_q[4]};
  logic signed [48:0] missing;
  assign missing = quanta_q - ds_4;
  logic beyond_q;
  logic before_q;
  logic [47:0] quanta_5_q;
  logic [47:0] goal_q;
  always_ff @(posedge clk_i) begin
    beyond_q   <= !missing[48];
    before_q   <= quanta_q[48];
    quanta_5_q <= quanta_q[47:0];
    if (end_q[5] || beyond_q) goal_q <= ds_q[5];
    else if (before_q) goal_q <= '0;
    else goal_q <= quanta_5_q;
  end

  // 7: never back, path = max(goal, path before).  The comparison with the path before takes a
  // clock, so it is made with both possible values: the goal before, its path before.
  logic [47:0] goal_7_q;
  logic [47:0] path_q;
  logic [47:0] path_before_q;
  logic [48:0] above_goal;
  logic [48:0] above_path;
  logic above_goal_q;
  logic above_path_q;
  logic taken_q;
  logic rises;
  logic taken;
  assign above_goal = {1'b0, goal_7_q} - {1'b0, goal_q};
  assign above_path = {1'b0, path_q} - {1'b0, goal_q};
  assign rises = taken_q ? above_goal_q : above_path_q;
  assign taken = valid_q[7] && !still_q[7] && (begin_q[7] || rises);
  always_ff @(posedge clk_i) begin
    goal_7_q      <= goal_q;
    above_goal_q  <= above_goal[48];
    above_path_q  <= above_path[48];
    path_before_q <= path_q;
    if (!rst_ni) begin
      path_q  <= '0;
      taken_q <= 1'b0;
    end else begin
      if (taken) path_q <= goal_7_q;
      taken_q <= taken;
    end
  end

  // 9 .. 11: the increment, with the rest of the piece before.
  logic [47:0] piece_ds_q;
  logic [47:0] path_9_q;
  logic [47:0] change_q;
  logic [47:0] rest_q;
  logic [47:0] moved_q;
  logic [47:0] left_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) piece_ds_q <= '0;
    else if (valid_q[8] && !still_q[8]) piece_ds_q <= ds_q[8];
    path_9_q <= path_q;
    change_q <= path_q - path_before_q;
    rest_q   <= piece_ds_q - path_before_q;
    moved_q  <= begin_q[9] ? path_9_q : change_q;
    left_q   <= begin_q[9] ? rest_q : '0;
    ds_o     <= moved_q + left_q;
  end

  assign valid_o = valid_q[11];
  assign rate_o  = rate_q[11];

endmodule
`default_nettype wire
