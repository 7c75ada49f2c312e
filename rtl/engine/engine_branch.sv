// SPDX-License-Identifier: Apache-2.0
// The places of the two programs, 0 the background's and 1 the foreground's: one on with each
// instruction, anywhere by BR. F0 is {end, return, call, not, condition}.
//
//   clock      0         1              2        3
//   run_i      BR, no stall_o
//   place_o              where it goes
//   ends_o               the foreground
//   fetch_i                             there
//   run_i                                        there
`default_nettype none
module engine_branch #(
    parameter int PlaceBits = 11  // [1, 15]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // The program to be read, the one whose instruction is fetched, the one that runs
    input  wire logic                 next_thread_i,
    output logic      [PlaceBits-1:0] place_o,
    input  wire logic                 fetch_i,
    input  wire logic                 ahead_thread_i,
    input  wire logic                 run_i,
    input  wire logic                 thread_i,

    input  wire logic        branch_i,    // it is BR
    input  wire logic        waits_i,     // the tick is waited for
    input  wire logic [23:0] fields_i,    // {F0, F1, F2}
    input  wire logic        tick_i,
    input  wire logic        negative_i,
    input  wire logic        zero_i,
    input  wire logic [12:0] board_i,     // conditions 3 to 15
    output logic             stall_o,
    output logic             ends_o,      // the foreground

    input  wire logic                 link_i,        // written by OUT
    input  wire logic [PlaceBits-1:0] link_place_i,
    output logic      [PlaceBits-1:0] link_o
);

  logic ends, returns, calls, negates;
  logic [3:0] number;
  assign {ends, returns, calls, negates, number} = fields_i[23:16];

  logic [15:0] conditions;
  logic holds;
  logic goes_q;
  assign conditions = {board_i, zero_i, negative_i, 1'b0};
  assign holds = conditions[number] != negates;
  assign stall_o = branch_i && waits_i && !tick_i;
  assign ends_o = goes_q && ends && thread_i;
  always_ff @(posedge clk_i) goes_q <= rst_ni && run_i && branch_i && !stall_o && holds;

  // A place is read while it is taken.
  logic [PlaceBits-1:0] pc_q[2];
  logic [PlaceBits-1:0] link_q[2];
  logic [15:0] target;
  logic [PlaceBits-1:0] goal;
  assign target = fields_i[15:0];
  assign link_o = link_q[thread_i];
  assign goal = returns ? link_o : target[PlaceBits-1:0];
  assign place_o = goes_q && next_thread_i == thread_i ? goal : pc_q[next_thread_i];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      pc_q[0]   <= '0;
      pc_q[1]   <= PlaceBits'(1);
      link_q[0] <= '0;
      link_q[1] <= '0;
    end else begin
      if (fetch_i) pc_q[ahead_thread_i] <= pc_q[ahead_thread_i] + PlaceBits'(1);
      if (goes_q) pc_q[thread_i] <= goal;
      if (link_i) link_q[thread_i] <= link_place_i;
      if (goes_q && calls) link_q[thread_i] <= pc_q[thread_i];
    end
  end

endmodule
`default_nettype wire
