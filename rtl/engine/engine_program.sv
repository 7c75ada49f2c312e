// SPDX-License-Identifier: Apache-2.0
// The engine's program: instructions that the device's configuration loads from a file of
// hexadecimal words; without one all of them are 0, no instructions. Block RAM is slow, so a
// register follows it.
//
//   clock          0       1             2
//   place_i        place
//   ahead_o                instruction
//   fetch_i                1
//   instruction_o                        instruction, until the next fetch
`default_nettype none
module engine_program #(
    parameter int Instructions = 2048,  // [2, 32768]
    parameter int Form         = 0,     // 2: block RAM of UP5K
    parameter     Program      = ""     // file
) (
    input wire logic clk_i,

    input  wire logic [$clog2(Instructions)-1:0] place_i,
    input  wire logic                            fetch_i,
    output logic      [                    31:0] ahead_o,
    output logic      [                    31:0] instruction_o
);

  initial
    if (Instructions < 2 || Instructions > 32768) $fatal(1, "Instructions must be in [2, 32768]");

  // UP5K's blocks are small; others hold a power of two without a multiplexer.
  localparam int Depth = (Form == 2) ? Instructions : 2 ** $clog2(Instructions);
  logic [31:0] memory[Depth];
  if (Program == "") begin : g_empty
`ifndef SYNTHESIS  // nobody makes a device without programs
    initial for (int n = 0; n < Depth; n = n + 1) memory[n] = '0;
`endif
  end else begin : g_file
    initial $readmemh(Program, memory);
  end

  always_ff @(posedge clk_i) begin
    ahead_o <= memory[place_i];
    if (fetch_i) instruction_o <= ahead_o;
  end

endmodule
`default_nettype wire
