// SPDX-License-Identifier: Apache-2.0
// The words of a motion, from the bus to the generator and the core: checked at the entry, queued
// and counted; with the guard that stops time before they run out.
//
//   segment words -> entry -> queue -> segment_*_o                  hold_o, begin_o: of time
//   profile words -> entry -> queue -> piece_*_o                        ^
//                      whole frames -> ledgers -> ticks that are covered -> guard
//
// fault_o as in rtl/motion_interpolator.sv.
`default_nettype none
module word_streams #(
    parameter int CoefBits          = 36,    // [18, 36]
    parameter int FineBits          = 42,    // [18, 44]
    parameter int AuxAxes           = 0,     // [0, 6]
    parameter int Splines           = 0,     // 0, 1
    parameter int SegmentQueueWords = 4096,  // [64, 65536], a power of two
    parameter int ProfileQueueWords = 4096   // [16, 4096], a power of two
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic [15:0] digest_i,  // digest of the words' configuration

    // From the bus
    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic [47:0] segment_data_i,
    input  wire logic        profile_valid_i,
    output logic             profile_ready_o,
    input  wire logic [47:0] profile_data_i,

    // To the core
    output logic             segment_valid_o,
    input  wire logic        segment_ready_i,
    output logic      [47:0] segment_data_o,

    // To the path generator
    output logic             profile_valid_o,
    input  wire logic        profile_ready_i,
    output logic      [47:0] profile_data_o,
    output logic             queued_o,         // a whole piece is queued

    // The generator's pieces and ticks
    input wire logic               take_i,
    input wire logic        [19:0] take_ticks_i,
    input wire logic               take_final_i,
    input wire logic               active_i,
    input wire logic               present_final_i,
    input wire logic signed [21:0] present_ticks_i,
    input wire logic        [ 4:0] started_i,

    input  wire logic [31:0] stop_ticks_i,
    output logic             hold_o,
    output logic             begin_o,
    output logic             underrun_o,
    output logic      [ 5:0] fault_o
);

  // Words at the entry, in the queue, and counted. Lengths of either stream pass in every second
  // clock, so that one sum takes them from there.
  logic ds_turn_q;
  always_ff @(posedge clk_i) ds_turn_q <= rst_ni && !ds_turn_q;
  logic cut;
  logic wait_segments;
  logic wait_pieces;
  logic segment_pass;
  logic segment_room;
  logic [47:0] segment_word;
  logic segment_enters;
  logic length_enters;
  logic [31:0] segment_ticks;
  logic segment_last;
  logic segment_waits_q;
  segment_entry #(
      .CoefBits(CoefBits),
      .FineBits(FineBits),
      .AuxAxes (AuxAxes),
      .Splines (Splines)
  ) u_segment_entry (
      .clk_i,
      .rst_ni,
      .valid_i(segment_valid_i),
      .ready_o(segment_ready_o),
      .data_i(segment_data_i),
      .digest_i,
      .cut_i(cut),
      .wait_i(wait_segments || segment_enters || segment_waits_q),
      .turn_i(!ds_turn_q),
      .valid_o(segment_pass),
      .ready_i(segment_room),
      .data_o(segment_word),
      .length_o(length_enters),
      .segment_o(segment_enters),
      .ticks_o(segment_ticks),
      .last_o(segment_last),
      .fault_o(fault_o[1:0])
  );

  word_queue #(
      .Bits (48),
      .Depth(SegmentQueueWords)
  ) u_segment_queue (
      .clk_i,
      .rst_ni,
      .valid_i(segment_pass),
      .ready_o(segment_room),
      .data_i (segment_word),
      .valid_o(segment_valid_o),
      .ready_i(segment_ready_i),
      .data_o (segment_data_o)
  );
  logic segments_full;
  frame_room #(
      .Depth(SegmentQueueWords),
      .Frame(words_pkg::SegmentWords + words_pkg::AxisWords * AuxAxes)
  ) u_segment_room (
      .clk_i,
      .rst_ni,
      .put_i (segment_pass && segment_room),
      .take_i(segment_valid_o && segment_ready_i),
      .full_o(segments_full)
  );

  logic piece_pass;
  logic piece_room;
  logic [47:0] piece_word;
  logic piece_enters;
  logic [19:0] piece_ticks;
  logic ds_enters;
  logic piece_final;
  logic piece_waits_q;
  piece_entry u_piece_entry (
      .clk_i,
      .rst_ni,
      .valid_i(profile_valid_i),
      .ready_o(profile_ready_o),
      .data_i(profile_data_i),
      .digest_i,
      .cut_i(cut),
      .wait_i(wait_pieces || piece_enters || piece_waits_q),
      .turn_i(ds_turn_q),
      .valid_o(piece_pass),
      .ready_i(piece_room),
      .data_o(piece_word),
      .ds_o(ds_enters),
      .piece_o(piece_enters),
      .ticks_o(piece_ticks),
      .final_o(piece_final),
      .fault_o(fault_o[3:2])
  );

  word_queue #(
      .Bits (48),
      .Depth(ProfileQueueWords)
  ) u_profile_queue (
      .clk_i,
      .rst_ni,
      .valid_i(piece_pass),
      .ready_o(piece_room),
      .data_i (piece_word),
      .valid_o(profile_valid_o),
      .ready_i(profile_ready_i),
      .data_o (profile_data_o)
  );
  logic pieces_full;
  frame_room #(
      .Depth(ProfileQueueWords),
      .Frame(words_pkg::PieceWords)
  ) u_piece_room (
      .clk_i,
      .rst_ni,
      .put_i (piece_pass && piece_room),
      .take_i(profile_valid_o && profile_ready_i),
      .full_o(pieces_full)
  );

  // The ledgers count one at a time: a piece that begins, one that has entered, a segment. A
  // waiting one stays at its entry, at most a clock longer: no other word passes meanwhile.
  logic piece_counts;
  logic segment_counts;
  assign piece_counts   = (piece_enters || piece_waits_q) && !take_i;
  assign segment_counts = (segment_enters || segment_waits_q) && !piece_counts;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      piece_waits_q   <= 1'b0;
      segment_waits_q <= 1'b0;
    end else begin
      piece_waits_q   <= (piece_enters || piece_waits_q) && take_i;
      segment_waits_q <= (segment_enters || segment_waits_q) && piece_counts;
    end
  end

  logic [ 9:0] finals;
  logic [31:0] queued_ticks;
  piece_ledger #(
      .QueueWords(ProfileQueueWords)
  ) u_ledger (
      .clk_i,
      .rst_ni,
      .put_i(piece_counts),
      .put_ticks_i(piece_ticks),
      .put_final_i(piece_final),
      .take_i,
      .take_ticks_i,
      .take_final_i,
      .queued_o,
      .finals_o(finals),
      .ticks_o(queued_ticks)
  );

  logic segments_complete;
  logic next_segments_complete;
  logic waits_final;
  logic signed [31:0] lead;
  assign waits_final = finals != 10'd0;
  program_ledger u_programs (
      .clk_i,
      .rst_ni,
      .length_valid_i(length_enters),
      .length_i(segment_word[words_pkg::PathLengthLow+:words_pkg::PathLengthBits]),
      .segment_i(segment_counts),
      .segment_ticks_i(segment_ticks),
      .last_i(segment_last),
      .ds_valid_i(ds_enters),
      .ds_i(piece_word[words_pkg::PathLengthLow+:words_pkg::PathLengthBits]),
      .ds_turn_i(ds_turn_q),
      .piece_i(piece_counts),
      .piece_ticks_i(piece_ticks),
      .final_i(piece_final),
      .finals_i(finals),
      .present_final_i,
      .wait_segments_o(wait_segments),
      .wait_pieces_o(wait_pieces),
      .complete_o(segments_complete),
      .next_complete_o(next_segments_complete),
      .lead_o(lead),
      .apart_o(fault_o[4])
  );
  assign cut = fault_o[4:0] != 5'd0;

  underrun_guard u_guard (
      .clk_i,
      .rst_ni,
      .stop_ticks_i,
      .pieces_full_i(pieces_full),
      .ticks_i(queued_ticks),
      .segments_full_i(segments_full),
      .lead_i(lead),
      .complete_i({segments_complete, present_final_i || waits_final} & {2{!fault_o[4]}}),
      .next_complete_i({next_segments_complete, waits_final} & {2{!fault_o[4]}}),
      .active_i,
      .present_ticks_i,
      .started_i,
      .hold_o,
      .begin_o,
      .underrun_o,
      .fault_o(fault_o[5])
  );

endmodule
`default_nettype wire
