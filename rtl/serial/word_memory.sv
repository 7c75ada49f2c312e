// SPDX-License-Identifier: Apache-2.0
// 256 coefficients, one write and one read port; it starts with the constants of the program:
//
//   0x81 1    0x91 -1    (CoefBits - 2 fraction bits)    0xa2 .. 0xac  1/2 .. 1/12    0xa0 0
//
// The device's configuration loads them.  No program writes there, nor does a reset.
//
//   cycle       0           1
//   read_i      address
//   data_o                  word; undefined if cycle 0 writes it
`default_nettype none
module word_memory #(
    parameter int CoefBits = 36  // [18, 36]
) (
    input wire logic clk_i,

    input wire logic                write_i,
    input wire logic [         7:0] write_address_i,
    input wire logic [CoefBits-1:0] write_data_i,

    input  wire logic [         7:0] read_i,
    output logic      [CoefBits-1:0] data_o
);

  initial if (CoefBits < 18 || CoefBits > 36) $fatal(1, "CoefBits must be in [18, 36]");

  function automatic logic [CoefBits-1:0] first(input int address);
    logic [35:0] word;
    first = '0;
    if (address == 129) first[CoefBits-2] = 1'b1;
    if (address == 145) first[CoefBits-1:CoefBits-2] = 2'b11;
    if (address >= 162 && address <= 172) begin
      word  = curvecore_pkg::reciprocal(CoefBits - 1, address - 160);
      first = word[CoefBits-1:0];
    end
  endfunction

  logic [CoefBits-1:0] memory[256];
  initial for (int n = 0; n < 256; n = n + 1) memory[n] = first(n);
  always_ff @(posedge clk_i) begin
    if (write_i) memory[write_address_i] <= write_data_i;
    data_o <= memory[read_i];
    if (write_i && write_address_i == read_i) data_o <= 'x;  // no program reads this
  end

endmodule
`default_nettype wire
