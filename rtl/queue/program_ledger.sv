// SPDX-License-Identifier: Apache-2.0
// Compares the two streams of a program: segments and pieces end a program at the same path and
// after the same ticks, and a program's words enter before the next one's.
//
//   clock               0                  1       2       4
//   segment_i, piece_i  1, last or final         after their length_valid_i, ds_valid_i
//   wait_*_o                               1                       until both streams have ended
//   lead_o                                         segments' ticks, less pieces'
//   apart_o                                                1       they end apart: stays
//
// Segments and pieces come one at a time, and so do their lengths. All segments of a program are
// in: complete_o, for the program under way, and next_complete_o, for the one that begins once its
// final piece is under way. Without one under way both refer to the next.
`default_nettype none
module program_ledger (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic        length_valid_i,
    input wire logic [43:0] length_i,
    input wire logic        segment_i,
    input wire logic [31:0] segment_ticks_i,
    input wire logic        last_i,

    input wire logic        ds_valid_i,
    input wire logic [43:0] ds_i,
    input wire logic        ds_turn_i,      // 1: turn of ds_i, 0: of length_i
    input wire logic        piece_i,
    input wire logic [19:0] piece_ticks_i,
    input wire logic        final_i,

    // Final pieces: the waiting ones, and the one under way
    input wire logic [9:0] finals_i,
    input wire logic       present_final_i,

    output logic               wait_segments_o,
    output logic               wait_pieces_o,
    output logic               complete_o,
    output logic               next_complete_o,
    output logic signed [31:0] lead_o,           // 2^31 - 1: this number or more
    output logic               apart_o
);

  // Both ends are in: compared once the sums have them.
  logic both;
  logic [2:0] both_q;
  assign both = wait_segments_o && wait_pieces_o && both_q == 3'd0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      wait_segments_o <= 1'b0;
      wait_pieces_o   <= 1'b0;
      both_q          <= 3'd0;
    end else begin
      both_q <= {both_q[1:0], both};
      if (both_q[2]) begin
        wait_segments_o <= 1'b0;
        wait_pieces_o   <= 1'b0;
      end else begin
        if (segment_i && last_i) wait_segments_o <= 1'b1;
        if (piece_i && final_i) wait_pieces_o <= 1'b1;
      end
    end
  end

  // The newest program is complete when its last segment is in; earlier ones are. It has a final
  // piece, among those not over, while wait_pieces_o.
  logic [9:0] newest;
  logic [9:0] present;
  assign newest  = {9'b0, wait_pieces_o};
  assign present = {9'b0, present_final_i};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      complete_o      <= 1'b0;
      next_complete_o <= 1'b0;
    end else begin
      complete_o      <= wait_segments_o || finals_i + present > newest;
      next_complete_o <= wait_segments_o ? finals_i >= newest : finals_i > newest;
    end
  end

  // Lead of the segments over the pieces: ticks, path. The summand is a piece's with its bits
  // inverted, and the sum's carry, or a segment's.
  logic signed [47:0] ticks_q;
  logic signed [59:0] path_q;
  logic        [47:0] ticks;
  logic        [59:0] path;
  logic        [48:0] ticks_sum;
  logic        [60:0] path_sum;
  assign ticks     = piece_i ? ~{28'b0, piece_ticks_i} : {16'b0, segment_ticks_i};
  assign path      = ds_turn_i ? ~{16'b0, ds_i} : {16'b0, length_i};
  assign ticks_sum = {ticks_q, 1'b1} + {ticks, piece_i};
  assign path_sum  = {path_q, 1'b1} + {path, ds_turn_i};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ticks_q <= '0;
      path_q  <= '0;
      apart_o <= 1'b0;
    end else begin
      if (segment_i || piece_i) ticks_q <= ticks_sum[48:1];
      if (length_valid_i || ds_valid_i) path_q <= path_sum[60:1];
      if (both_q[2] && (ticks_q != '0 || path_q != '0)) apart_o <= 1'b1;
    end
  end

  logic far;
  assign far = !ticks_q[47] && ticks_q[46:31] != '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) lead_o <= '0;
    else lead_o <= far ? 32'sh7fff_ffff : ticks_q[31:0];
  end

endmodule
`default_nettype wire
