// SPDX-License-Identifier: Apache-2.0
// Samples on their way out, with room for all under way: the sampler never stops, but a request is
// admitted only if its sample will have a place here.
//
//   cycle     0         1         2
//   push_i    1
//   valid_o                       1
//   room_o    admit_i is allowed: of Depth samples admitted and not taken, at least one less
`default_nettype none
module sample_queue #(
    parameter int Bits  = 222,  // [1, 1024]
    parameter int Depth = 64    // [16, 256], a power of two
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic admit_i,
    output logic      room_o,

    input wire logic            push_i,
    input wire logic [Bits-1:0] data_i,

    output logic                 valid_o,
    input  wire logic            ready_i,
    output logic      [Bits-1:0] data_o
);

  localparam int PlaceBits = $clog2(Depth);

  logic                 admit_q;
  logic                 take;
  logic                 take_q;
  logic                 fetch;
  logic                 more;
  logic [PlaceBits-1:0] write_q;
  logic [PlaceBits-1:0] read_q;
  logic [PlaceBits-1:0] next_read;
  logic [PlaceBits-1:0] next_write;
  logic [  PlaceBits:0] admitted_q;
  logic [  PlaceBits:0] count_q;  // samples in the memory
  logic                 stored_q;  // count_q != 0
  assign more  = count_q > (PlaceBits + 1)'(1);
  assign take  = valid_o && ready_i;
  assign fetch = stored_q && (!valid_o || ready_i);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      admit_q    <= 1'b0;
      take_q     <= 1'b0;
      admitted_q <= '0;
      room_o     <= 1'b0;
      valid_o    <= 1'b0;
      count_q    <= '0;
      stored_q   <= 1'b0;
    end else begin
      if (push_i && !fetch) count_q <= count_q + 1'b1;
      if (fetch && !push_i) count_q <= count_q - 1'b1;
      stored_q <= push_i || (fetch ? more : stored_q);
      admit_q  <= admit_i;
      take_q   <= take;
      if (admit_q && !take_q) admitted_q <= admitted_q + 1'b1;
      if (take_q && !admit_q) admitted_q <= admitted_q - 1'b1;
      // Three more may be admitted before this takes effect.
      room_o <= admitted_q < (PlaceBits + 1)'(Depth - 3);
      if (fetch) valid_o <= 1'b1;
      else if (ready_i) valid_o <= 1'b0;
    end
  end

  // The memory is not block RAM: its output is late in the clock, and samples leave from here.
  // Slices, each with its own places: a queue of many samples is wide and deep.
  localparam int Slice = 37;
  localparam int Slices = (Bits + Slice - 1) / Slice;
  always_comb begin
    next_read  = fetch ? read_q + 1'b1 : read_q;
    next_write = push_i ? write_q + 1'b1 : write_q;
    if (!rst_ni) begin
      next_read  = '0;
      next_write = '0;
    end
  end
  always_ff @(posedge clk_i) begin
    write_q <= next_write;
    read_q  <= next_read;
  end
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
    (* ram_style = "distributed" *) logic [Width-1:0] memory[Depth];
    always_ff @(posedge clk_i) begin
      if (push_i) memory[write] <= data_i[Low+:Width];
      if (fetch) data_o[Low+:Width] <= memory[read];
    end
  end

endmodule
`default_nettype wire
