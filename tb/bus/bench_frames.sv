// SPDX-License-Identifier: Apache-2.0
// Registers behind frames of bytes that cannot wait.
`default_nettype none
module bench_frames (
    input  wire logic       clk_i,
    input  wire logic       rst_ni,
    input  wire logic       byte_valid_i,
    input  wire logic [7:0] byte_i,
    output logic            byte_valid_o,
    input  wire logic       byte_ready_i,
    output logic      [7:0] byte_o
);

  logic ready;
  logic valid;
  logic write;
  logic [6:0] word;
  logic [31:0] data;
  logic done;
  logic [31:0] answer;
  frame_port u_port (
      .clk_i,
      .rst_ni,
      .byte_valid_i,
      .byte_ready_o(ready),
      .byte_i,
      .byte_valid_o,
      .byte_ready_i,
      .byte_o,
      .valid_o(valid),
      .write_o(write),
      .word_o(word),
      .data_o(data),
      .done_i(done),
      .data_i(answer)
  );
  logic error;
  bench_registers u_registers (
      .clk_i,
      .rst_ni,
      .valid_i(valid),
      .write_i(write),
      .word_i (word),
      .data_i (data),
      .done_o (done),
      .error_o(error),
      .data_o (answer)
  );

  always_ff @(posedge clk_i) if (rst_ni && byte_valid_i && !ready) $fatal(1, "a byte was lost");

endmodule
`default_nettype wire
