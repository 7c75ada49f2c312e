// SPDX-License-Identifier: Apache-2.0
// Samples written by a host, position by position, until the step generator takes them.
//
//   positions, axis 0 first -> memory -> the position of the requested axis
//
//   clock          0       1       2
//   write_i        last
//   valid_o                1               until ready_i has taken the sample
//   axis_i         a
//   position_o                     of axis a
//
// With Holds = 0 position_o is there a clock earlier, and it is undefined in the clock behind a
// write.
//
// ready_o at a sample's first position decides whether the sample is taken. All positions of a
// refused sample are refused, so that axes are never mistaken for each other.
//
// ends_i: no further sample is offered. When none is, empty_i empties the buffer.
`default_nettype none
module position_buffer #(
    parameter int Axes = 3,  // [1, 9]
    parameter int Bits = 32,  // [16, 32]
    parameter int Words = 512,  // [32, 4096], a power of two
    parameter int Form = 0,  // 2: in SPRAM of UP5K
    parameter int Holds = 1  // 0, 1
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Positions in
    input  wire logic            write_i,
    output logic                 ready_o,
    input  wire logic [Bits-1:0] data_i,
    output logic      [    15:0] room_o,   // samples
    output logic      [    15:0] queued_o,

    // Samples out
    input  wire logic            ends_i,
    input  wire logic            empty_i,
    output logic                 valid_o,
    input  wire logic            ready_i,
    input  wire logic [     3:0] axis_i,
    output logic      [Bits-1:0] position_o
);

  initial if (Axes < 1 || Axes > 9) $fatal(1, "Axes must be in [1, 9]");
  initial if (Holds < 0 || Holds > 1) $fatal(1, "Holds must be 0 or 1");
  initial
    if (Words < 32 || Words > 4096 || 2 ** $clog2(Words) != Words)
      $fatal(1, "Words must be a power of two in [32, 4096]");

  localparam int AddressBits = $clog2(Words);
  localparam int CountBits = $clog2(Words / Axes + 1);

  logic [CountBits-1:0] room_q;
  // Next axis
  logic [3:0] axis_q;
  logic refused_q;
  logic first;
  logic last;
  logic write;
  assign first   = axis_q == '0;
  assign last    = axis_q == 4'(Axes - 1);
  assign ready_o = first ? room_q != '0 : !refused_q;
  assign write   = write_i && ready_o;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || empty_i) axis_q <= '0;
    else if (write_i) axis_q <= last ? '0 : axis_q + 1'b1;
    if (write_i && first) refused_q <= room_q == '0;
  end

  // Number of samples: a place is kept from the first position on.
  logic [CountBits-1:0] queued_q;
  logic reserves;
  logic comes;
  logic leaves;
  logic offered_q;
  assign reserves = write && first;
  assign comes = write && last;
  assign leaves = valid_o && ready_i;
  assign valid_o = queued_q != '0 && (offered_q || !ends_i);
  assign room_o = 16'(room_q);
  assign queued_o = 16'(queued_q);
  always_ff @(posedge clk_i) begin
    if (!rst_ni || empty_i) begin
      room_q    <= CountBits'(Words / Axes);
      queued_q  <= '0;
      offered_q <= 1'b0;
    end else begin
      if (reserves != leaves) room_q <= room_q + {{(CountBits - 1) {reserves}}, 1'b1};
      if (comes != leaves) queued_q <= queued_q + {{(CountBits - 1) {leaves}}, 1'b1};
      offered_q <= valid_o && !ready_i;
    end
  end

  logic [AddressBits-1:0] write_q;
  logic [AddressBits-1:0] read_q;  // axis 0 of the offered sample
  logic [AddressBits-1:0] read;
  assign read = read_q + AddressBits'(axis_i);
  always_ff @(posedge clk_i) begin
    if (!rst_ni || empty_i) begin
      write_q <= '0;
      read_q  <= '0;
    end else begin
      if (write) write_q <= write_q + 1'b1;
      if (leaves) read_q <= read_q + AddressBits'(Axes);
    end
  end
  if (Form == 2) begin : g_spram
    logic [Bits-1:0] word;
    single_port_memory #(
        .Bits (Bits),
        .Words(Words),
        .Form (Form)
    ) u_memory (
        .clk_i,
        .write_i(write),
        .place_i(write ? write_q : read),
        .word_i (data_i),
        .word_o (word)
    );
    if (Holds == 1) begin : g_holds
      logic written_q;
      logic [Bits-1:0] position_q;
      assign position_o = written_q ? position_q : word;
      always_ff @(posedge clk_i) begin
        written_q  <= write;
        position_q <= position_o;
      end
    end else begin : g_passes
      assign position_o = word;
    end
  end else begin : g_memory
    (* no_rw_check *)
    logic [Bits-1:0] memory [Words];
    logic [Bits-1:0] word_q;
    always_ff @(posedge clk_i) begin
      if (write) memory[write_q] <= data_i;
      word_q <= memory[read];
    end
    if (Holds == 1) begin : g_holds
      always_ff @(posedge clk_i) position_o <= word_q;  // block RAM is slow
    end else begin : g_passes
      assign position_o = word_q;
    end
  end

endmodule
`default_nettype wire
