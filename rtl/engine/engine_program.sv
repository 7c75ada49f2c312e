// SPDX-License-Identifier: Apache-2.0
// The engine's program: 2^PlaceBits instructions that the device's configuration loads from a file
// of hexadecimal words; without one all of them are 0, no instructions. Block RAM is slow, so a
// register follows it.
//
//   clock          0       1             2
//   place_i        place
//   ahead_o                instruction
//   fetch_i                1
//   instruction_o                        instruction, until the next fetch
`default_nettype none
module engine_program #(
    parameter int PlaceBits = 11,  // [1, 15]
    parameter     Program   = ""   // file
) (
    input wire logic clk_i,

    input  wire logic [PlaceBits-1:0] place_i,
    input  wire logic                 fetch_i,
    output logic      [         31:0] ahead_o,
    output logic      [         31:0] instruction_o
);

  initial if (PlaceBits < 1 || PlaceBits > 15) $fatal(1, "PlaceBits must be in [1, 15]");

  logic [31:0] memory[2**PlaceBits];
  if (Program == "") begin : g_empty
`ifndef SYNTHESIS  // nobody makes a device without programs
    initial for (int n = 0; n < 2 ** PlaceBits; n = n + 1) memory[n] = '0;
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
