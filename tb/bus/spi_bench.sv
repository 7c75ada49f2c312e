// SPDX-License-Identifier: Apache-2.0
// Registers behind SPI, with the signal names that cocotbext-spi looks for.
`default_nettype none
module spi_bench (
    input  wire logic clk,
    input  wire logic rst_n,
    input  wire logic spi_cs,
    input  wire logic spi_sclk,
    input  wire logic spi_mosi,
    output logic      spi_miso
);

  logic valid;
  logic write;
  logic [6:0] word;
  logic [31:0] data;
  logic done;
  logic error;
  logic [31:0] answer;
  spi_port u_port (
      .clk_i  (clk),
      .rst_ni (rst_n),
      .cs_ni  (spi_cs),
      .sclk_i (spi_sclk),
      .mosi_i (spi_mosi),
      .miso_o (spi_miso),
      .valid_o(valid),
      .write_o(write),
      .word_o (word),
      .data_o (data),
      .done_i (done),
      .error_i(error),
      .data_i (answer)
  );
  bench_registers u_registers (
      .clk_i  (clk),
      .rst_ni (rst_n),
      .valid_i(valid),
      .write_i(write),
      .word_i (word),
      .data_i (data),
      .done_o (done),
      .error_o(error),
      .data_o (answer)
  );

endmodule
`default_nettype wire
