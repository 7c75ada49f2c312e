// SPDX-License-Identifier: Apache-2.0
// Sequence of the instructions: of the foreground's program from due on to its end, else of the
// background's.
//
//   clock             0           1     2      3      4        5
//   last_i, a result  1
//   fetch_o                                           ..3      run_o: 4 clocks behind its last term
//   last_i, of OUT    1     fetch_o     run_o
//   last_i, of BR     1           .     fetch_o run_o
//
// due_i is seen in an instruction that begins 3 clocks later or more.
`default_nettype none
module engine_sequencer #(
    parameter int Foreground = 1  // 0: there is none, due_i is 0
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic due_i,
    input  wire logic ends_i,  // the foreground
    output logic      busy_o,  // the foreground runs
    output logic      late_o,  // it ran when it was due; stays

    input  wire logic last_i,         // term of the instruction, and no wait
    input  wire logic branch_i,
    input  wire logic out_i,
    output logic      fetch_o,
    output logic      run_o,          // a term
    output logic      thread_o,       // its program
    output logic      next_thread_o,  // program to be read
    output logic      ahead_thread_o  // program of the next fetch, read a clock before
);

  // Clocks to the next fetch, one hot
  logic [3:0] left_q;
  logic [3:0] left;
  assign fetch_o = left_q[0];
  always_comb begin
    left = {1'b0, left_q[3:1]};
    if (run_o && last_i) left = branch_i ? 4'b0010 : out_i ? 4'b0001 : 4'b1000;
  end

  assign next_thread_o = Foreground != 0 && busy_o && !ends_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_q         <= 4'b1000;
      run_o          <= 1'b0;
      thread_o       <= 1'b0;
      ahead_thread_o <= 1'b0;
      busy_o         <= 1'b0;
      late_o         <= 1'b0;
    end else begin
      left_q         <= left;
      ahead_thread_o <= next_thread_o;
      if (fetch_o) begin
        run_o    <= 1'b1;
        thread_o <= Foreground != 0 && ahead_thread_o;
      end else if (last_i) begin
        run_o <= 1'b0;
      end
      busy_o <= Foreground != 0 && (due_i || next_thread_o);
      if (due_i && next_thread_o) late_o <= 1'b1;
    end
  end

endmodule
`default_nettype wire
