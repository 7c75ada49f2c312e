// SPDX-License-Identifier: Apache-2.0
// A memory of 256 or 512 coefficients with one write and one read port; it starts with the
// constants of the program:
//
//   0x81 1    0x91 -1    0xad -2    0xae -3/2    0xaf 1/4      CoefBits - 2 fraction bits
//   0xa0 0    0xa1 1/1, with CoefBits - 2                       0xa2 .. 0xac  1/2 .. 1/12
//
// The device's configuration loads them; serial/folded_datapath.sv never writes there.
//
//   cycle       0           1
//   read_i      address
//   data_o                  word; undefined if cycle 0 writes it, which no program does
`default_nettype none
module word_memory #(
    parameter int CoefBits = 36,  // [18, 36]
    parameter int Words    = 256  // 256, 512
) (
    input wire logic clk_i,

    input wire logic                     write_i,
    input wire logic [$clog2(Words)-1:0] write_address_i,
    input wire logic [     CoefBits-1:0] write_data_i,

    input  wire logic [$clog2(Words)-1:0] read_i,
    output logic      [     CoefBits-1:0] data_o
);

  initial if (CoefBits < 18 || CoefBits > 36) $fatal(1, "CoefBits must be in [18, 36]");
  initial if (Words != 256 && Words != 512) $fatal(1, "Words must be 256 or 512");

  function automatic logic [CoefBits-1:0] first(input int address);
    logic [35:0] word;
    first = '0;
    if (address == 129 || address == 161) first[CoefBits-2] = 1'b1;
    if (address == 145) first[CoefBits-1:CoefBits-2] = 2'b11;
    if (address == 173) first[CoefBits-1] = 1'b1;
    if (address == 174) first[CoefBits-1:CoefBits-3] = 3'b101;
    if (address == 175) first[CoefBits-4] = 1'b1;
    if (address >= 162 && address <= 172) begin
      word  = curvecore_pkg::reciprocal(CoefBits - 1, address - 160);
      first = word[CoefBits-1:0];
    end
  endfunction

  (* no_rw_check *)
  logic [CoefBits-1:0] memory[Words];
  initial for (int n = 0; n < Words; n = n + 1) memory[n] = first(n);
  always @(posedge clk_i) begin  // with always_ff nothing else, no initial block, might write it
    if (write_i) memory[write_address_i] <= write_data_i;
    data_o <= memory[read_i];
  end

endmodule
`default_nettype wire
