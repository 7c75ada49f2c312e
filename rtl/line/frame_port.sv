// SPDX-License-Identifier: Apache-2.0
// Registers behind a stream of bytes, each way: frames of LBP16 commands, guarded by a CRC. A
// broken frame changes nothing and has no answer; a repeated one is obeyed once.
//
//   bytes -> slip_receiver -> frame_buffer -> frame_reader -> requests
//   bytes <- slip_sender <-------- answers ------+
//
// A frame has at most 251 bytes without its CRC. Several may be under way: the buffer has 512
// bytes, and discards frames that do not fit. An answer has the words that its frame reads; without
// words there is no answer.
`default_nettype none
module frame_port (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Bytes
    input  wire logic       byte_valid_i,
    output logic            byte_ready_o,
    input  wire logic [7:0] byte_i,
    output logic            byte_valid_o,
    input  wire logic       byte_ready_i,
    output logic      [7:0] byte_o,

    // Requests: rtl/bus/register_file.sv
    output logic             valid_o,
    output logic             write_o,
    output logic      [ 6:0] word_o,
    output logic      [31:0] data_o,
    input  wire logic        done_i,
    input  wire logic [31:0] data_i
);

  logic data_valid;
  logic [7:0] data;
  logic end_valid;
  logic good;
  slip_receiver u_receiver (
      .clk_i,
      .rst_ni,
      .byte_valid_i,
      .byte_ready_o,
      .byte_i,
      .data_valid_o(data_valid),
      .data_o      (data),
      .end_valid_o (end_valid),
      .good_o      (good)
  );
  logic read_valid;
  logic [7:0] read;
  logic next;
  frame_buffer u_buffer (
      .clk_i,
      .rst_ni,
      .data_valid_i(data_valid),
      .data_i      (data),
      .end_valid_i (end_valid),
      .good_i      (good),
      .read_valid_o(read_valid),
      .read_o      (read),
      .next_i      (next)
  );
  logic answer_valid;
  logic [7:0] answer;
  logic close;
  logic ready;
  frame_reader u_reader (
      .clk_i,
      .rst_ni,
      .read_valid_i(read_valid),
      .read_i      (read),
      .next_o      (next),
      .data_valid_o(answer_valid),
      .data_o      (answer),
      .close_o     (close),
      .ready_i     (ready),
      .valid_o,
      .write_o,
      .word_o,
      .data32_o    (data_o),
      .done_i,
      .data32_i    (data_i)
  );
  slip_sender u_sender (
      .clk_i,
      .rst_ni,
      .data_valid_i(answer_valid),
      .data_i      (answer),
      .close_i     (close),
      .ready_o     (ready),
      .byte_valid_o,
      .byte_ready_i,
      .byte_o
  );

endmodule
`default_nettype wire
