// SPDX-License-Identifier: Apache-2.0
// Samples on their way out, with room for all under way: the sampler never stops, but a request is
// admitted only if its sample will have a place here.
//
//   cycle     0         1         2         3
//   push_i    1
//   valid_o                                 1
//   room_o    admit_i is allowed: of Depth samples admitted and not left, at least one less
//
// A sample is pushed, and taken, as Words words; leave_i: the last one of a sample is taken.
`default_nettype none
module sample_queue #(
    parameter int Bits  = 126,  // [1, 1024]
    parameter int Depth = 64,   // [16, 256], a power of two
    parameter int Words = 1,    // [1, 8]
    parameter int Block = 0     // 0 distributed memory, 1 block RAM
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic admit_i,
    output logic      room_o,

    input wire logic            push_i,
    input wire logic [Bits-1:0] data_i,

    output logic                 valid_o,
    input  wire logic            ready_i,
    output logic      [Bits-1:0] data_o,
    input  wire logic            leave_i
);

  localparam int DepthBits = $clog2(Depth);
  localparam int PlaceBits = $clog2(Depth * Words);

  logic                 admit_q;
  logic                 leave_q;
  logic                 leaves;
  logic                 fetch;
  logic                 more;
  logic                 read_valid_q;  // a sample at the memory's output
  logic [PlaceBits-1:0] write_q;
  logic [PlaceBits-1:0] read_q;
  logic [PlaceBits-1:0] next_write;
  logic [PlaceBits-1:0] next_read;
  logic [  DepthBits:0] admitted_q;  // samples
  logic [  PlaceBits:0] count_q;  // words in the memory
  logic                 stored_q;  // count_q != 0
  assign more   = count_q > (PlaceBits + 1)'(1);
  assign leaves = !valid_o || ready_i;
  assign fetch  = stored_q && (!read_valid_q || leaves);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      admit_q      <= 1'b0;
      leave_q      <= 1'b0;
      admitted_q   <= '0;
      room_o       <= 1'b0;
      read_valid_q <= 1'b0;
      valid_o      <= 1'b0;
      count_q      <= '0;
      stored_q     <= 1'b0;
    end else begin
      if (push_i && !fetch) count_q <= count_q + 1'b1;
      if (fetch && !push_i) count_q <= count_q - 1'b1;
      stored_q <= push_i || (fetch ? more : stored_q);
      admit_q  <= admit_i;
      leave_q  <= leave_i;
      if (admit_q && !leave_q) admitted_q <= admitted_q + 1'b1;
      if (leave_q && !admit_q) admitted_q <= admitted_q - 1'b1;
      // Three more may be admitted before this takes effect.
      room_o <= admitted_q < (DepthBits + 1)'(Depth - 3);
      if (fetch) read_valid_q <= 1'b1;
      else if (leaves) read_valid_q <= 1'b0;
      if (leaves) valid_o <= read_valid_q;
    end
  end

  always_comb begin
    next_write = push_i ? write_q + 1'b1 : write_q;
    next_read  = fetch ? read_q + 1'b1 : read_q;
    if (!rst_ni) begin
      next_write = '0;
      next_read  = '0;
    end
  end
  always_ff @(posedge clk_i) begin
    write_q <= next_write;
    read_q  <= next_read;
  end

  // A register follows the memory, for block RAM is slow.
  logic [Bits-1:0] word_q;
  always_ff @(posedge clk_i) begin
    if (leaves && read_valid_q) data_o <= word_q;
  end
  if (Block != 0) begin : g_block
    (* ram_style = "block", no_rw_check *)
    logic [Bits-1:0] memory[2**PlaceBits];
    always_ff @(posedge clk_i) begin
      if (push_i) memory[write_q] <= data_i;
      if (fetch) word_q <= memory[read_q];
    end
  end else begin : g_distributed
    // Slices, each with its own places: a queue of many samples is wide and deep.
    localparam int Slice = 37;
    localparam int Slices = (Bits + Slice - 1) / Slice;
    for (genvar s = 0; s < Slices; s++) begin : g_slice
      localparam int Low = s * Slice;
      localparam int Width = (Bits - Low < Slice) ? Bits - Low : Slice;
      logic [PlaceBits-1:0] read;
      logic [PlaceBits-1:0] write;
      local_copy #(
          .Bits(2 * PlaceBits)
      ) u_places (
          .clk_i,
          .data_i({next_read, next_write}),
          .data_o({read, write})
      );
      (* ram_style = "distributed" *) logic [Width-1:0] memory[2**PlaceBits];
      always_ff @(posedge clk_i) begin
        if (push_i) memory[write] <= data_i[Low+:Width];
        if (fetch) word_q[Low+:Width] <= memory[read];
      end
    end
  end

endmodule
`default_nettype wire
