// SPDX-License-Identifier: Apache-2.0
// The word at hand for the engine, of one of two streams, and its check over all words before it
// (hls/word_check.hpp).
//
//   clock      0        1       2        3
//   ask_i      1
//   limb_i     l
//   limb_o              limb l of the word
//   select_i   1
//   profile_o           whose word it is
//   word_i                      its
//   tag_o                                its
//   check_i    1
//   check_o                     behind the word at hand
//   holds_o                              its
//
//   limb | bits of the word
//   0, 1 | 14:0, 29:15
//   2, 3 | 45:30, 47:46
`default_nettype none
module engine_words (
    input wire logic clk_i,

    input wire logic [47:0] word_i,

    input  wire logic        select_i,  // data_i: bit 0 stream, 1 no bits 43:36, 5:2 tag
    input  wire logic        check_i,   // data_i is the check before the word
    input  wire logic [15:0] data_i,
    output logic             profile_o, // the stream

    input  wire logic [ 1:0] limb_i,
    output logic      [15:0] limb_o,
    output logic      [15:0] check_o,
    output logic             holds_o,
    output logic             tag_o     // the word has the tag
);

  logic without_q;
  logic [3:0] tag_q;
  logic [15:0] before_q;
  logic [words_pkg::CheckBits-1:0] above;  // the check or number in the word
  always_ff @(posedge clk_i) begin
    if (select_i) {tag_q, without_q, profile_o} <= data_i[5:0];
    if (check_i) before_q <= data_i;
  end

  // What the engine branches on comes from registers: the word's memory is slow.
  always_ff @(posedge clk_i) begin
    tag_o   <= word_i[words_pkg::TagLow+:words_pkg::TagBits] == tag_q;
    holds_o <= above == (check_o[15:8] ^ check_o[7:0]);
  end

  always_ff @(posedge clk_i) begin
    case (limb_i)
      2'd0: limb_o <= {1'b0, word_i[14:0]};
      2'd1: limb_o <= {1'b0, word_i[29:15]};
      2'd2: limb_o <= word_i[45:30];
      default: limb_o <= {14'd0, word_i[47:46]};
    endcase
  end

  // Its check: 2^8 times the one before, modulo x^16 + x^3 + 1, and the word
  localparam int Low = words_pkg::CheckLow;
  localparam int Bits = words_pkg::CheckBits;
  logic [ 7:0] top;
  logic [43:0] counted;
  assign top   = before_q[15:8];
  assign above = word_i[Low+:Bits];
  always_comb begin
    counted = word_i[words_pkg::TagLow-1:0];
    if (without_q) counted[Low+:Bits] = '0;
  end
  always_ff @(posedge clk_i) begin
    check_o <= {before_q[7:0], top} ^ {5'd0, top, 3'd0} ^ {4'd0, counted[43:32]} ^ counted[31:16] ^
        counted[15:0];
  end

endmodule
`default_nettype wire
