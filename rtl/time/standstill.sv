// SPDX-License-Identifier: Apache-2.0
// Signals that the machine stands: the rate of time rests at 0, or a held tick started when no
// program was under way and none could begin before it; and all samples requested before have left.
// It stands until a tick starts whose target is not 0.
//
//   clock          0       1        2       3
//   scaled_i       still
//   leaves_i               the last of those before
//   standing_o                      1       1
//   tick_i                          target not 0
//
// Reset: it stands.
`default_nettype none
module standstill (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Ticks: as they start, and, 16 later at most, as their rates come
    input wire logic tick_i,
    input wire logic stops_i,   // target of tick_i is 0
    input wire logic scaled_i,
    input wire logic held_i,    // target of scaled_i was 0
    input wire logic still_i,   // rate rests at 0 with scaled_i

    // The path: ticks not yet taken, with tick_i, and a program under way, in those taken
    input wire logic [4:0] started_i,
    input wire logic       taken_i,
    input wire logic       active_i,

    // Samples: 511 under way at most
    input wire logic asked_i,
    input wire logic leaves_i,

    output logic standing_o
);

  logic starts;
  logic scaled;
  assign starts = tick_i && !stops_i;
  assign scaled = scaled_i && !held_i;

  logic [4:0] ahead_q;  // ticks with another target than 0 that have no rate yet
  logic [4:0] open_q;  // ticks not yet taken, up to the last one that is not held
  logic [8:0] under_way_q;
  logic [8:0] under_way_d;
  logic rests_q;
  logic [8:0] left_q;  // remaining samples of those requested before it rests
  assign under_way_d = under_way_q + {{8{leaves_i && !asked_i}}, leaves_i != asked_i};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ahead_q     <= '0;
      open_q      <= '0;
      under_way_q <= '0;
      rests_q     <= 1'b1;
      left_q      <= '0;
    end else begin
      ahead_q <= ahead_q + {{4{scaled && !starts}}, scaled != starts};
      if (starts) open_q <= started_i - {4'd0, taken_i};
      else if (taken_i && open_q != '0) open_q <= open_q - 1'b1;
      under_way_q <= under_way_d;
      if (starts) rests_q <= 1'b0;
      else if (scaled_i && still_i && ahead_q == '0) rests_q <= 1'b1;
      else if (tick_i && open_q == '0 && !active_i) rests_q <= 1'b1;
      if (!rests_q) left_q <= under_way_d;
      else if (leaves_i && left_q != '0) left_q <= left_q - 1'b1;
    end
  end
  assign standing_o = rests_q && left_q == '0;

endmodule
`default_nettype wire
