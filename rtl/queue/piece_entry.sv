// SPDX-License-Identifier: Apache-2.0
// Lets words into the queue of pieces: whole pieces of valid words, one after the other; a stop
// branch may stand before each, with steps or with those of the one before.
// Clocks: rtl/queue/frame_entry.sv; ticks_o and final_o with piece_o, a piece's last word, and
// until the clock after. ds_o: data_o passes, and is the path length; with turn_i only.
// Word format: hls/words.hpp.  Twin: PieceEntry of hls/word_entry.hpp.
`default_nettype none
module piece_entry (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic        valid_i,
    output logic             ready_o,
    input  wire logic [47:0] data_i,

    input  wire logic [15:0] digest_i,
    input  wire logic        cut_i,
    input  wire logic        wait_i,
    input  wire logic        turn_i,
    output logic             valid_o,
    input  wire logic        ready_i,
    output logic      [47:0] data_o,

    output logic        ds_o,
    output logic        piece_o,
    output logic [19:0] ticks_o,
    output logic        final_o,
    output logic [ 1:0] fault_o   // word, sequence
);

  // The next word
  logic [3:0] tag_q;
  logic [3:0] tag;
  logic [3:0] next_tag;
  logic stop_q;  // the piece has a branch
  logic known_q;  // one came whose steps another may have again
  logic again;
  logic stops;
  logic complete;
  logic ds;
  logic checked;
  logic can_be;
  logic pass;
  assign stops    = data_o[words_pkg::TagLow+:words_pkg::TagBits] == words_pkg::TagStop;
  assign tag      = (tag_q == words_pkg::TagPiece && !stop_q && stops) ? words_pkg::TagStop : tag_q;
  assign again    = data_o[words_pkg::StopAgainLow];
  assign complete = tag == words_pkg::TagC3;
  assign ds       = tag == words_pkg::TagDs;
  assign checked  = tag == words_pkg::TagC1 || tag == words_pkg::TagC2 || complete;
  assign ds_o     = pass && ds;
  always_comb begin
    next_tag = tag + 4'd1;
    if (complete || (tag == words_pkg::TagStop && again)) next_tag = words_pkg::TagPiece;
    if (tag == words_pkg::TagStep)
      next_tag = data_o[words_pkg::StepLastLow] ? words_pkg::TagPiece : words_pkg::TagStep;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      tag_q   <= words_pkg::TagPiece;
      stop_q  <= 1'b0;
      known_q <= 1'b0;
    end else if (pass) begin
      tag_q <= next_tag;
      if (tag == words_pkg::TagStop) stop_q <= 1'b1;
      if (tag == words_pkg::TagPiece) stop_q <= 1'b0;
      if (tag == words_pkg::TagStep) known_q <= 1'b1;
    end
  end

  frame_entry u_entry (
      .clk_i,
      .rst_ni,
      .valid_i,
      .ready_o,
      .data_i,
      .digest_i,
      .cut_i,
      .wait_i(wait_i || (ds && !turn_i)),
      .valid_o,
      .ready_i,
      .data_o,
      .tag_i(tag),
      .can_be_i(can_be),
      .numbered_i(tag == words_pkg::TagPiece),
      .checked_i(checked),
      .follows_i(1'b1),
      .complete_i(complete),
      .last_i(final_o),
      .pass_o(pass),
      .frame_o(piece_o),
      .fault_o
  );

  // Valid values: 1 <= ticks <= 2^m, in the form ticks - 1 < 2^m; subtracted on the way in
  localparam int FirstSpare = words_pkg::FinalLow + words_pkg::FinalBits;
  logic [words_pkg::PieceTicksBits-1:0] less_one_q;
  logic [words_pkg::TimeExponentBits-1:0] m;
  logic [words_pkg::ExponentBits-1:0] e;
  logic lasts;
  logic piece_word;
  always_ff @(posedge clk_i) begin
    if (ready_o) less_one_q <= data_i[words_pkg::PieceTicksLow+:words_pkg::PieceTicksBits] - 1'b1;
  end
  assign m = data_o[words_pkg::TimeExponentLow+:words_pkg::TimeExponentBits];
  assign e = data_o[words_pkg::ExponentLow+:words_pkg::ExponentBits];
  assign lasts = less_one_q >> m == '0;
  assign piece_word = m <= words_pkg::MostTimeExponent && e <= words_pkg::MostExponent && lasts &&
      data_o[words_pkg::SequenceLow-1:FirstSpare] == '0;
  logic wait_word;
  logic step_word;
  assign wait_word = data_o[words_pkg::StopWaitBits-1:0] != '0 &&
      data_o[words_pkg::TagLow-1:words_pkg::StopAgainLow+1] == '0 && (known_q || !again);
  assign step_word = data_o[words_pkg::StepTicksBits-1:0] != '0;
  always_comb begin
    case (tag)
      words_pkg::TagPiece: can_be = piece_word;
      words_pkg::TagStop:  can_be = wait_word;
      words_pkg::TagStep:  can_be = step_word;
      default:             can_be = 1'b1;
    endcase
  end

  // Outputs to the ledgers
  always_ff @(posedge clk_i) begin
    if (pass && tag == words_pkg::TagPiece) begin
      ticks_o <= data_o[words_pkg::PieceTicksLow+:words_pkg::PieceTicksBits];
      final_o <= data_o[words_pkg::FinalLow];
    end
  end

endmodule
`default_nettype wire
