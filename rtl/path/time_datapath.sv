// SPDX-License-Identifier: Apache-2.0
// The datapath that makes rates of time in the serial build, one adder and a memory of a few words,
// by the words of rtl/path/time_program.sv (rtl/path/time_control_pkg.sv).
//
//     sum' = sum +- operand
//
// A word is read a clock before it is the operand, so it is not the word that this clock writes.
//
// Words have 32 fraction bits, on the fine side of 7/8 three more: an eighth of a bound is then its
// bits above the lowest three. Sums whose sign is used are below 2^35: 36 bits suffice.
`default_nettype none
module time_datapath (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic [time_control_pkg::Bits-1:0] control_i,
    input  wire logic [time_control_pkg::Bits-1:0] ahead_i,    // word of the next clock
    input  wire logic                              fine_i,
    output logic      [                      35:0] sum_o,
    output logic                                   zero_o,     // the sum is 0

    input wire logic [31:0] acceleration_i,
    input wire logic [32:0] slope_i,
    input wire logic [16:0] goal_i,
    input wire logic [31:0] change_i         // used on the fine side only
);

  logic minus;
  assign minus = control_i[time_control_pkg::Minus];

  logic [35:0] port;
  always_comb begin
    case (control_i[time_control_pkg::Read+:2])
      2'd0: port = {4'b0, acceleration_i[31:3], fine_i ? 3'b0 : acceleration_i[2:0]};
      2'd1: port = {3'b0, slope_i[32:3], fine_i ? 3'b0 : slope_i[2:0]};
      2'd2: port = fine_i ? {goal_i, 19'b0} : {3'b0, goal_i, 16'b0};
      default: port = {change_i[31], change_i, 3'b0};
    endcase
  end

  (* no_rw_check *)
  logic [35:0] memory [8];
  logic [35:0] word_q;
  always_ff @(posedge clk_i) begin
    if (control_i[time_control_pkg::Store]) memory[control_i[time_control_pkg::Write+:3]] <= sum_o;
    word_q <= memory[ahead_i[time_control_pkg::Read+:3]];
  end

  logic [35:0] operand;
  assign operand = (control_i[time_control_pkg::OfPorts] ? port : word_q) ^ {36{minus}};
  always_ff @(posedge clk_i) begin
    if (!rst_ni || control_i[time_control_pkg::Clear]) sum_o <= '0;
    else if (control_i[time_control_pkg::Add]) sum_o <= sum_o + operand + {35'b0, minus};
  end
  assign zero_o = sum_o == '0;

endmodule
`default_nettype wire
