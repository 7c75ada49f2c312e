// SPDX-License-Identifier: Apache-2.0
// Words of the motion from two sources: registers, one word a request, and streams, one a clock.
//
//   register_valid_i      1             1
//   stream_valid_i        1    1   1    1    1     segments, pieces alike
//   stream_ready_o             1   1         1
//   word_o                reg  st  st   reg  st
//
// A register's word goes first, since its request is answered at once; then segments of the stream,
// while their queue has room, then pieces. No word goes without words_i: then a stream's word
// waits, and a register's is an error.
`default_nettype none
module word_sources (
    input wire logic words_i,  // words may be taken

    // Registers: one word for both
    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic        profile_valid_i,
    output logic             profile_ready_o,
    input  wire logic [47:0] word_i,

    // Streams
    input  wire logic        segment_stream_valid_i,
    output logic             segment_stream_ready_o,
    input  wire logic [47:0] segment_stream_word_i,
    input  wire logic        profile_stream_valid_i,
    output logic             profile_stream_ready_o,
    input  wire logic [47:0] profile_stream_word_i,

    // To the motion
    output logic             segment_valid_o,
    input  wire logic        segment_ready_i,
    output logic             profile_valid_o,
    input  wire logic        profile_ready_i,
    output logic      [47:0] word_o
);

  logic by_register;
  assign by_register = segment_valid_i || profile_valid_i;
  assign segment_ready_o = words_i && segment_ready_i;
  assign profile_ready_o = words_i && profile_ready_i;
  assign segment_stream_ready_o = words_i && segment_ready_i && !by_register;
  assign profile_stream_ready_o = words_i && profile_ready_i && !by_register &&
      !(segment_stream_valid_i && segment_ready_i);
  assign segment_valid_o = words_i && (by_register ? segment_valid_i : segment_stream_valid_i);
  assign profile_valid_o = words_i && (by_register ? profile_valid_i :
      profile_stream_valid_i && !(segment_stream_valid_i && segment_ready_i));
  always_comb begin
    if (by_register) word_o = word_i;
    else if (segment_stream_valid_i && segment_ready_i) word_o = segment_stream_word_i;
    else word_o = profile_stream_word_i;
  end

endmodule
`default_nettype wire
