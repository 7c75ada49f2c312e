// SPDX-License-Identifier: Apache-2.0
// Bytes over SPI (mode 0, most significant bit first), both ways at once, for the frames of a UART.
// sclk_i is sampled: at least 12 clocks a bit, 6 of each level; miso_o changes 4 or 5 clocks after
// sclk_i has fallen. The idle byte is the one that ends a frame, in both directions. In a frame,
// whose next byte may wait for writes between its reads, it would end the frame: two escapes go
// out, which are no byte. Received bytes must be taken at once.
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

  // A byte goes out from the falling edge before it on, and is consumed when its first bit is read:
  // a host may end before that.
  logic [7:0] out_q;
  logic something_q;
  logic inside_q;  // a frame has begun and not ended
  logic half_q;  // the first one of two escapes is out
  logic takes;
  logic leaves;
  logic loads;
  assign loads = !cs_n && (cs_n_q || (falls && bit_q == '0));
  assign takes = byte_valid_i && !half_q;
  assign leaves = rises && bit_q == '0;
  assign byte_ready_o = leaves && something_q;
  assign miso_o = out_q[7];
  always_ff @(posedge clk_i) begin
    if (loads) begin
      out_q       <= takes ? byte_i : inside_q ? slip_pkg::Escape : slip_pkg::End;
      something_q <= takes;
    end else if (falls) begin
      out_q <= {out_q[6:0], 1'b0};
    end
    if (!rst_ni) {inside_q, half_q} <= '0;
    else if (byte_ready_o) inside_q <= byte_i != slip_pkg::End;
    else if (leaves) half_q <= inside_q && !half_q;
  end

endmodule
`default_nettype wire
