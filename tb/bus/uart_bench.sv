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
  logic in_ready;
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
  logic valid;
  logic write;
  logic [6:0] word;
  logic [31:0] data;
  logic done;
  logic [31:0] answer;
  frame_port u_port (
      .clk_i       (clk),
      .rst_ni      (rst_n),
      .byte_valid_i(in_valid),
      .byte_ready_o(in_ready),
      .byte_i      (in),
      .byte_valid_o(out_valid),
      .byte_ready_i(out_ready),
      .byte_o      (out),
      .valid_o     (valid),
      .write_o     (write),
      .word_o      (word),
      .data_o      (data),
      .done_i      (done),
      .data_i      (answer)
  );
  logic error;
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

  // Bytes of a UART cannot wait.
  always_ff @(posedge clk) if (rst_n && in_valid && !in_ready) $fatal(1, "a byte was lost");

endmodule
`default_nettype wire
