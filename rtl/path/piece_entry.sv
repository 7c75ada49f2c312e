// SPDX-License-Identifier: Apache-2.0
// Lets words into the queue of pieces: whole pieces, one after the other, of words that can be.
// The first other word cuts the stream: it and all that follow are taken and dropped, until reset.
// Word format: hls/words.hpp.  Twin: hls/word_entry.hpp.
//
//   clock      0      1      2
//   valid_i    1
//   data_i     word
//   valid_o           1               until ready_i
//   data_o            word
//   piece_o                  1        it was a piece's last word; ticks_o, ds_o, final_o: of it
//   fault_o                  1        or it could not be: stays
//
// cut_i: the stream is cut for another's fault.  wait_i: no word is passed on.
`default_nettype none
module piece_entry (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic        valid_i,
    output logic             ready_o,
    input  wire logic [47:0] data_i,

    input  wire logic        cut_i,
    input  wire logic        wait_i,
    output logic             valid_o,
    input  wire logic        ready_i,
    output logic      [47:0] data_o,

    output logic        piece_o,
    output logic [19:0] ticks_o,
    output logic [43:0] ds_o,
    output logic        final_o,
    output logic [ 1:0] fault_o   // word, sequence
);

  // The word at hand
  logic held_q;
  logic cut;
  logic good;
  logic pass;
  assign cut     = cut_i || fault_o != 2'b00;
  assign valid_o = held_q && good && !cut && !wait_i;
  assign pass    = valid_o && ready_i;
  assign ready_o = !held_q || pass || cut;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) held_q <= 1'b0;
    else if (ready_o) held_q <= valid_i && !cut;
  end
  always_ff @(posedge clk_i) if (ready_o) data_o <= data_i;

  // Which word it has to be
  logic [3:0] tag_q;
  logic complete;
  assign complete = tag_q == words_pkg::TagC3;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) tag_q <= words_pkg::TagPiece;
    else if (pass) tag_q <= complete ? words_pkg::TagPiece : tag_q + 4'd1;
  end

  // What it may be: 1 <= ticks <= 2^m, in the form ticks - 1 < 2^m
  logic [7:0] sequence_q;
  logic [19:0] ticks_less_one;
  logic [19:0] beyond;
  logic [4:0] m;
  logic [5:0] e;
  logic piece_word;
  assign m              = data_o[words_pkg::TimeExponentLow+:5];
  assign e              = data_o[words_pkg::ExponentLow+:6];
  assign ticks_less_one = data_o[words_pkg::PieceTicksLow+:20] - 20'd1;
  assign beyond         = ticks_less_one >> m;
  assign piece_word     = m <= 5'd19 && e <= 6'd46 && beyond == 20'd0 && data_o[43:40] == 4'd0;

  logic no_rest;  // the bits above a coefficient
  logic tag_fits;
  logic can_be;
  logic in_order;
  assign no_rest = data_o[43:36] == 8'd0;
  assign tag_fits = data_o[words_pkg::TagLow+:4] == tag_q;
  assign in_order =
      tag_q != words_pkg::TagPiece || data_o[words_pkg::PieceSequenceLow+:8] == sequence_q;
  always_comb begin
    case (tag_q)
      words_pkg::TagPiece: can_be = piece_word;
      words_pkg::TagDs:    can_be = 1'b1;
      default:             can_be = no_rest;
    endcase
  end
  assign good = tag_fits && can_be && in_order;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fault_o    <= 2'b00;
      piece_o    <= 1'b0;
      sequence_q <= '0;
    end else begin
      if (held_q && !cut && !(tag_fits && can_be)) fault_o[0] <= 1'b1;
      if (held_q && !cut && tag_fits && !in_order) fault_o[1] <= 1'b1;
      piece_o <= pass && complete;
      if (pass && complete) sequence_q <= sequence_q + 8'd1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (pass && tag_q == words_pkg::TagPiece) begin
      ticks_o <= data_o[words_pkg::PieceTicksLow+:20];
      final_o <= data_o[words_pkg::FinalLow];
    end
    if (pass && tag_q == words_pkg::TagDs) ds_o <= data_o[43:0];
  end

endmodule
`default_nettype wire
