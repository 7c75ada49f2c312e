// SPDX-License-Identifier: Apache-2.0
// Registers behind frames on a UART of 8 clocks a bit.
`default_nettype none
module uart_bench (
    input  wire logic clk,
    input  wire logic rst_n,
    input  wire logic rx,
    output logic      tx
);

  logic in_valid;
  logic [7:0] in;
  logic out_valid;
  logic [7:0] out;
  logic out_ready;
  uart_line #(
      .BitClocks(8)
  ) u_line (
      .clk_i       (clk),
      .rst_ni      (rst_n),
      .rx_i        (rx),
      .tx_o        (tx),
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
