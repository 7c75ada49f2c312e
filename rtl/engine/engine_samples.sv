// SPDX-License-Identifier: Apache-2.0
// Samples of the engine on their way out, three limbs an axis: a ring of them in block RAM, and the
// oldest one in registers.
//
//   clock       0       1       2 .. 3 Axes + 2
//   limb_i      last
//   whole_i             1
//   valid_o                          1               until ready_i has taken it
//
// Samples are written only while there is a place: no more than Places of them are not taken.
`default_nettype none
module engine_samples #(
    parameter int Axes     = 3,   // [1, 9]
    parameter int FineBits = 42,  // [18, 44]
    parameter int Places   = 16   // [2, 16], a power of two
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic        limb_i,   // data_i is the sample's next limb: bits 14:0, 29:15, 45:30
    input wire logic        whole_i,  // it was the last one
    input wire logic [15:0] data_i,

    output logic                          valid_o,
    input  wire logic                     ready_i,
    output logic      [Axes*FineBits-1:0] data_o    // axis 0 in the low bits
);

  localparam int PlaceBits = $clog2(Places);
  localparam int Limbs = 3 * Axes;
  localparam int LimbBits = $clog2(Limbs);

  logic [LimbBits-1:0] write_q, read_q, loaded_q;
  logic [PlaceBits:0] put_q, take_q;  // one bit more: full and empty differ in it
  logic reads, last, loads_q;
  logic full_q;  // the registers' sample is chosen
  assign reads = put_q != take_q && !full_q;
  assign last  = read_q == LimbBits'(Limbs - 1);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      write_q <= '0;
      read_q  <= '0;
      put_q   <= '0;
      take_q  <= '0;
      loads_q <= 1'b0;
      full_q  <= 1'b0;
      valid_o <= 1'b0;
    end else begin
      if (whole_i) write_q <= '0;
      else if (limb_i) write_q <= write_q + 1'b1;
      if (whole_i) put_q <= put_q + 1'b1;
      if (reads) read_q <= last ? '0 : read_q + 1'b1;
      if (reads && last) take_q <= take_q + 1'b1;
      loads_q <= reads;
      if (reads && last) full_q <= 1'b1;
      else if (valid_o && ready_i) full_q <= 1'b0;
      valid_o <= full_q && !(valid_o && ready_i);
    end
    loaded_q <= read_q;
  end

  logic [15:0] limb;
  (* no_rw_check *)
  logic [15:0] memory[2**(PlaceBits+LimbBits)];
  always_ff @(posedge clk_i) begin
    if (limb_i) memory[{put_q[PlaceBits-1:0], write_q}] <= data_i;
    limb <= memory[{take_q[PlaceBits-1:0], read_q}];
  end

  for (genvar n = 0; n < Limbs; n++) begin : g_limb
    localparam int Low = 15 * (n % 3);
    localparam int Rest = (FineBits > Low) ? FineBits - Low : 0;
    localparam int Width = (n % 3 != 2 && Rest > 15) ? 15 : Rest;
    if (Width != 0) begin : g_bits
      always_ff @(posedge clk_i) begin
        if (loads_q && loaded_q == LimbBits'(n)) begin
          data_o[n/3*FineBits+Low+:Width] <= limb[Width-1:0];
        end
      end
    end
  end
  logic unused_bits;
  assign unused_bits = &{1'b0, limb};

endmodule
`default_nettype wire
