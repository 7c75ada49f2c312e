// SPDX-License-Identifier: Apache-2.0
// A first-in, first-out queue between a writer and a reader at their own pace, one word per clock.
//
//   clock      0      1      2      3
//   valid_i    1
//   data_i     word
//   valid_o                         1        until ready_i has taken it (Depth + 2 words fit)
//   data_o                          word
//
// The memory is read into a register of its own, so it may be block RAM; that is slow, so a second
// register follows. Reset empties the queue; the memory keeps its bits.
`default_nettype none
module word_queue #(
    parameter int Bits  = 48,  // [1, 128]
    parameter int Depth = 512  // [2, 65536], a power of two
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic            valid_i,
    output logic                 ready_o,
    input  wire logic [Bits-1:0] data_i,

    output logic                 valid_o,
    input  wire logic            ready_i,
    output logic      [Bits-1:0] data_o
);

  initial if (Bits < 1 || Bits > 128) $fatal(1, "Bits must be in [1, 128]");
  initial
    if (Depth < 2 || Depth > 65536 || 2 ** $clog2(Depth) != Depth)
      $fatal(1, "Depth must be a power of two in [2, 65536]");

  localparam int AddressBits = $clog2(Depth);

  // One bit more than an address: equal addresses are a full or an empty memory.
  logic [AddressBits:0] write_q;
  logic [AddressBits:0] read_q;
  logic same_address;
  logic same_lap;
  assign same_address = write_q[AddressBits-1:0] == read_q[AddressBits-1:0];
  assign same_lap = write_q[AddressBits] == read_q[AddressBits];

  logic write;
  logic read;
  logic move;
  logic read_valid_q;
  assign move = !valid_o || ready_i;
  assign ready_o = !(same_address && !same_lap);
  assign write = valid_i && ready_o;
  assign read = !(same_address && same_lap) && (!read_valid_q || move);

  logic [Bits-1:0] read_data_q;
  logic [Bits-1:0] memory[Depth];
  always_ff @(posedge clk_i) begin
    if (ready_o) memory[write_q[AddressBits-1:0]] <= data_i;  // a free place: valid_i may be late
    if (read) read_data_q <= memory[read_q[AddressBits-1:0]];
    if (move) data_o <= read_data_q;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      write_q <= '0;
      read_q <= '0;
      read_valid_q <= 1'b0;
      valid_o <= 1'b0;
    end else begin
      if (write) write_q <= write_q + 1'b1;
      if (read) read_q <= read_q + 1'b1;
      if (read || move) read_valid_q <= read;
      if (move) valid_o <= read_valid_q;
    end
  end

endmodule
`default_nettype wire
