// SPDX-License-Identifier: Apache-2.0
// Bytes over SPI (mode 0, most significant bit first), both ways at once, for frames as a UART has
// them. sclk_i is sampled: 16 clocks a bit at least. Where there is nothing to say the byte that
// ends a frame goes out; a host that has nothing to say sends it too. What arrives has to be taken
// at once.
//
//   cs_ni         ^^\_________________________________________________/^^
//   mosi_i          | byte            | byte            | ..
//   miso_o          | byte            | byte            | ..
//   byte_ready_o      1                 1                   taken, if there was one
//   byte_valid_o                      1                 1     one has come
`default_nettype none
module spi_line (
    input wire logic clk_i,
    input wire logic rst_ni,

    // SPI
    input  wire logic cs_ni,
    input  wire logic sclk_i,
    input  wire logic mosi_i,
    output logic      miso_o,

    // Bytes
    output logic            byte_valid_o,
    output logic      [7:0] byte_o,
    input  wire logic       byte_valid_i,
    output logic            byte_ready_o,
    input  wire logic [7:0] byte_i
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
  logic cs_n_q;
  logic sclk_q;
  logic rises;
  logic falls;
  always_ff @(posedge clk_i) begin
    cs_n_q <= cs_n;
    sclk_q <= sclk;
  end
  assign rises = !cs_n && sclk && !sclk_q;
  assign falls = !cs_n && !sclk && sclk_q;

  logic [2:0] bit_q;
  always_ff @(posedge clk_i) begin
    byte_valid_o <= rst_ni && rises && bit_q == 3'd7;
    if (!rst_ni || cs_n) bit_q <= '0;
    else if (rises) bit_q <= bit_q + 1'b1;
    if (rises) byte_o <= {byte_o[6:0], mosi};
  end

  // A byte goes out from the falling edge before it on, and is gone when its first bit is read: a
  // host may end before that.
  logic [7:0] out_q;
  logic something_q;
  logic loads;
  assign loads = !cs_n && (cs_n_q || (falls && bit_q == '0));
  assign byte_ready_o = rises && bit_q == '0 && something_q;
  assign miso_o = out_q[7];
  always_ff @(posedge clk_i) begin
    if (loads) begin
      out_q       <= byte_valid_i ? byte_i : slip_pkg::End;
      something_q <= byte_valid_i;
    end else if (falls) begin
      out_q <= {out_q[6:0], 1'b0};
    end
  end

endmodule
`default_nettype wire
