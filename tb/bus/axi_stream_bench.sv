// SPDX-License-Identifier: Apache-2.0
// Junction of motion_axi's streams and the words of registers, with the signal names that
// cocotbext-axi looks for.
`default_nettype none
module axi_stream_bench (
    input  wire logic        clk,
    input  wire logic        rst_n,
    input  wire logic        words,
    input  wire logic        segment_tvalid,
    output logic             segment_tready,
    input  wire logic [63:0] segment_tdata,
    input  wire logic        profile_tvalid,
    output logic             profile_tready,
    input  wire logic [63:0] profile_tdata,
    input  wire logic        segment_register,
    output logic             segment_register_ready,
    input  wire logic        profile_register,
    output logic             profile_register_ready,
    input  wire logic [47:0] register_word,
    output logic             segment_valid,
    input  wire logic        segment_ready,
    output logic             profile_valid,
    input  wire logic        profile_ready,
    output logic      [47:0] word
);

  word_sources u_sources (
      .words_i               (words),
      .segment_valid_i       (segment_register),
      .segment_ready_o       (segment_register_ready),
      .profile_valid_i       (profile_register),
      .profile_ready_o       (profile_register_ready),
      .word_i                (register_word),
      .segment_stream_valid_i(segment_tvalid),
      .segment_stream_ready_o(segment_tready),
      .segment_stream_word_i (segment_tdata[47:0]),
      .profile_stream_valid_i(profile_tvalid),
      .profile_stream_ready_o(profile_tready),
      .profile_stream_word_i (profile_tdata[47:0]),
      .segment_valid_o       (segment_valid),
      .segment_ready_i       (segment_ready),
      .profile_valid_o       (profile_valid),
      .profile_ready_i       (profile_ready),
      .word_o                (word)
  );

endmodule
`default_nettype wire
