// SPDX-License-Identifier: Apache-2.0
// The engine's words: 2^LimbPlaceBits limbs of 16 bits in two copies of one memory, so that two are
// read and one is written on every clock. The device's configuration loads it from a file of
// hexadecimal limbs; without one it holds the constants alone.
//
//   clock     0            1
//   first_i   address
//   first_o                limb; undefined if clock 0 writes it, which Engine::hazard() tells
`default_nettype none
module engine_memory #(
    parameter int PlaceBits = 10,  // [10, 14]
    parameter     Data      = ""   // file
) (
    input wire logic clk_i,

    input wire logic                 write_i,
    input wire logic [PlaceBits-1:0] write_place_i,
    input wire logic [         15:0] write_limb_i,

    input  wire logic [PlaceBits-1:0] first_i,
    output logic      [         15:0] first_o,
    input  wire logic [PlaceBits-1:0] second_i,
    output logic      [         15:0] second_o
);

  (* no_rw_check *)
  logic [15:0] memory_a[2**PlaceBits];
  (* no_rw_check *)
  logic [15:0] memory_b[2**PlaceBits];
  if (Data == "") begin : g_constants
`ifndef SYNTHESIS  // as of programs: engine_program
    initial begin
      for (int n = 0; n < 2 ** PlaceBits; n = n + 1) begin
        memory_a[n] = engine_pkg::first_limb(n);
        memory_b[n] = engine_pkg::first_limb(n);
      end
    end
`endif
  end else begin : g_file
    initial begin
      $readmemh(Data, memory_a);
      $readmemh(Data, memory_b);
    end
  end

  always @(posedge clk_i) begin  // with always_ff nothing else, no initial block, might write it
    if (write_i) memory_a[write_place_i] <= write_limb_i;
    first_o <= memory_a[first_i];
  end
  always @(posedge clk_i) begin
    if (write_i) memory_b[write_place_i] <= write_limb_i;
    second_o <= memory_b[second_i];
  end

endmodule
`default_nettype wire
