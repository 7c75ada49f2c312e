// SPDX-License-Identifier: Apache-2.0
// SPI port of the registers (mode 0, most significant bit first). sclk_i is sampled: at least 16
// clocks a bit.
//
//   cs_ni    ^^\__________________________________________________________/^^
//   mosi_i      | write, word | -      | data   | -      | data   | ..
//   miso_o      | -           | status | data   | status | data   | ..
//                 1, 7 bits     8 bits   32 bits
//
// Words follow each other while cs_ni is low. A word is read in the last bit of the status before
// it, and written in its own last bit. Status: 0xA0, plus 1 if the last access, of this frame or
// the one before, was an error.
`default_nettype none
module spi_port (
    input wire logic clk_i,
    input wire logic rst_ni,

    // SPI
    input  wire logic cs_ni,
    input  wire logic sclk_i,
    input  wire logic mosi_i,
    output logic      miso_o,

    // Requests: rtl/bus/register_file.sv
    output logic             valid_o,
    output logic             write_o,
    output logic      [ 6:0] word_o,
    output logic      [31:0] data_o,
    input  wire logic        done_i,
    input  wire logic        error_i,
    input  wire logic [31:0] data_i
);

  logic cs_n;
  logic sclk;
  logic mosi;
  synchroniser #(
      .Bits(3)
  ) u_synchroniser (
      .clk_i,
      .rst_ni,
      .input_i ({cs_ni, sclk_i, mosi_i}),
      .output_o({cs_n, sclk, mosi})
  );
  logic sclk_q;
  logic rises;
  logic falls;
  always_ff @(posedge clk_i) sclk_q <= sclk;
  assign rises = !cs_n && sclk && !sclk_q;
  assign falls = !cs_n && !sclk && sclk_q;

  // Bits: 32 to 39 of a command, then 0 to 7 of a status and 8 to 39 of a word, again and again
  localparam logic [5:0] FirstOfCommand = 6'd32;
  localparam logic [5:0] LastOfStatus = 6'd7;
  localparam logic [5:0] Last = 6'd39;
  logic [5:0] bit_q;
  logic command_q;
  logic ends;
  logic asks;
  assign ends = rises && bit_q == Last;
  assign asks = write_o ? ends && !command_q : rises && !command_q && bit_q == LastOfStatus;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || cs_n) begin
      bit_q     <= FirstOfCommand;
      command_q <= 1'b1;
    end else if (rises) begin
      bit_q <= ends ? 6'd0 : bit_q + 1'b1;
      if (ends) command_q <= 1'b0;
    end
  end

  // The access
  logic [31:0] in_q;
  always_ff @(posedge clk_i) begin
    if (rises) in_q <= {in_q[30:0], mosi};
    if (!rst_ni) valid_o <= 1'b0;
    else if (asks) valid_o <= 1'b1;
    else if (done_i) valid_o <= 1'b0;
    if (ends && command_q) {write_o, word_o} <= {in_q[6:0], mosi};
    else if (done_i) word_o <= word_o + 1'b1;
  end
  assign data_o = in_q;

  // Output, from the next falling edge on
  logic error_q;
  logic [31:0] out_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) error_q <= 1'b0;
    else if (done_i) error_q <= error_i;
    if (cs_n) out_q <= '0;
    else if (ends) out_q <= {8'hA0, 24'd0};
    else if (done_i && !write_o) out_q <= data_i;
    else if (falls) out_q <= {out_q[30:0], 1'b0};
    if (cs_n) miso_o <= 1'b0;
    else if (falls) miso_o <= (bit_q == LastOfStatus && error_q) || out_q[31];
  end

endmodule
`default_nettype wire
