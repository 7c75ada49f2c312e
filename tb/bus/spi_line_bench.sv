// SPDX-License-Identifier: Apache-2.0
// Registers behind frames on SPI, with the signal names that cocotbext-spi looks for.
`default_nettype none
module spi_line_bench (
    input  wire logic clk,
    input  wire logic rst_n,
    input  wire logic spi_cs,
    input  wire logic spi_sclk,
    input  wire logic spi_mosi,
    output logic      spi_miso
);

  logic in_valid;
  logic [7:0] in;
  logic out_valid;
  logic [7:0] out;
  logic out_ready;
  spi_line u_line (
      .clk_i       (clk),
      .rst_ni      (rst_n),
      .cs_ni       (spi_cs),
      .sclk_i      (spi_sclk),
      .mosi_i      (spi_mosi),
      .miso_o      (spi_miso),
      .byte_valid_o(in_valid),
      .byte_o      (in),
      .byte_valid_i(out_valid),
      .byte_ready_o(out_ready),
      .byte_i      (out)
  );
  bench_frames u_frames (
      .clk_i       (clk),
      .rst_ni      (rst_n),
      .byte_valid_i(in_valid),
      .byte_i      (in),
      .byte_valid_o(out_valid),
      .byte_ready_i(out_ready),
      .byte_o      (out)
  );

endmodule
`default_nettype wire
