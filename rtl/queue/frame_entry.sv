// SPDX-License-Identifier: Apache-2.0
// The word at the entry of a queue: it passes if it is the next one, is valid, and has the right
// check over itself and the words before it in its program, from the digest of its configuration on
// (hls/word_check.hpp).  The first other word cuts the stream: it and all that follow are taken and
// dropped, until reset. The stream defines the next word and its valid values:
// rtl/queue/segment_entry.sv, rtl/queue/piece_entry.sv.  Twin: FrameEntry of hls/word_entry.hpp.
//
//   clock        0      1      2
//   valid_i      1
//   data_i       word
//   data_o              word          tag_i to complete_i: of it
//   valid_o             1             until ready_i
//   pass_o              with ready_i
//   frame_o                    1      it was a frame's last
//   fault_o                    1      or it was invalid: stays
//
// cut_i: the stream is cut for another's fault.  wait_i: no word is passed on.  digest_i is read
// with a program's first word.
`default_nettype none
module frame_entry (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic        valid_i,
    output logic             ready_o,
    input  wire logic [47:0] data_i,

    input  wire logic [15:0] digest_i,
    input  wire logic        cut_i,
    input  wire logic        wait_i,
    output logic             valid_o,
    input  wire logic        ready_i,
    output logic      [47:0] data_o,

    input  wire logic [3:0] tag_i,       // tag that the word must have
    input  wire logic       can_be_i,
    input  wire logic       numbered_i,  // its frame's number stands above
    input  wire logic       checked_i,   // a check stands above
    input  wire logic       follows_i,   // it follows on the frame before
    input  wire logic       complete_i,  // it ends its frame
    input  wire logic       last_i,      // it ends its program
    output logic            pass_o,
    output logic            frame_o,
    output logic      [1:0] fault_o      // word, sequence
);

  localparam int Bits = words_pkg::SequenceBits;
  logic held_q;
  logic cut;
  logic can_be;
  logic in_order;
  logic [Bits-1:0] sequence_q;
  logic [words_pkg::CheckBits-1:0] above;
  logic holds;
  assign above    = data_o[words_pkg::CheckLow+:words_pkg::CheckBits];
  assign cut      = cut_i || fault_o != 2'b00;
  assign can_be   = can_be_i && data_o[words_pkg::TagLow+:words_pkg::TagBits] == tag_i && holds;
  assign in_order = follows_i && (!numbered_i || above == sequence_q);
  assign valid_o  = held_q && can_be && in_order && !cut && !wait_i;
  assign pass_o   = valid_o && ready_i;
  assign ready_o  = !held_q || pass_o || cut;
  always_ff @(posedge clk_i) if (ready_o) data_o <= data_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      held_q     <= 1'b0;
      fault_o    <= 2'b00;
      frame_o    <= 1'b0;
      sequence_q <= '0;
    end else begin
      if (ready_o) held_q <= valid_i && !cut;
      if (held_q && !cut) fault_o <= {can_be && !in_order, !can_be};
      frame_o <= pass_o && complete_i;
      if (pass_o && complete_i) sequence_q <= sequence_q + 1'b1;
    end
  end

  // The check: 2^8 times its last value, modulo x^16 + x^3 + 1, and the word
  logic begins_q;  // the next word is its program's first
  logic [15:0] check_q;
  logic [15:0] so_far;
  logic [15:0] check;
  logic [7:0] top;
  logic [43:0] counted;  // the word without its number, or its check
  assign so_far = begins_q ? digest_i : check_q;
  assign top = so_far[15:8];
  assign check = {so_far[7:0], top} ^ {5'd0, top, 3'd0} ^ {4'd0, counted[43:32]} ^
      counted[31:16] ^ counted[15:0];
  assign holds = !checked_i || above == (check[15:8] ^ check[7:0]);
  always_comb begin
    counted = data_o[words_pkg::TagLow-1:0];
    if (numbered_i || checked_i) counted[words_pkg::CheckLow+:words_pkg::CheckBits] = '0;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      begins_q <= 1'b1;
      check_q  <= '0;
    end else if (pass_o) begin
      begins_q <= complete_i && last_i;
      check_q  <= check;
    end
  end

endmodule
`default_nettype wire
