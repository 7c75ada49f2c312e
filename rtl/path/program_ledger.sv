// SPDX-License-Identifier: Apache-2.0
// Holds the two streams of a program against each other: segments and pieces end a program at the
// same path and after the same ticks, and a program's words enter before the next one's.
//
//   clock               0                  1       3       4, 5
//   segment_i, piece_i  1, last or final
//   wait_*_o                               1                       until both streams have ended
//   lead_o                                         pieces  segments: their ticks, less pieces'
//   apart_o                                                1       they end apart: stays
//
// complete_o: all segments of the program under way are in.
`default_nettype none
module program_ledger (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic        segment_i,
    input wire logic [43:0] length_i,
    input wire logic [31:0] segment_ticks_i,
    input wire logic        last_i,

    input wire logic        piece_i,
    input wire logic [43:0] ds_i,
    input wire logic [19:0] piece_ticks_i,
    input wire logic        final_i,

    // Final pieces that wait or are under way
    input wire logic [10:0] programs_i,

    output logic               wait_segments_o,
    output logic               wait_pieces_o,
    output logic               complete_o,
    output logic signed [31:0] lead_o,           // 2^31 - 1: so many or more
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

  // The newest program is complete when its last segment is in, those before it are.
  logic [10:0] newest;
  assign newest = {10'b0, wait_pieces_o};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) complete_o <= 1'b0;
    else complete_o <= wait_segments_o || programs_i > newest;
  end

  // A segment is counted after a piece that comes with it: so many ticks are there at least.
  logic waits_q;
  logic [43:0] length_q;
  logic [31:0] segment_ticks_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) waits_q <= 1'b0;
    else waits_q <= segment_i || (waits_q && piece_i);
    if (segment_i) begin
      length_q        <= length_i;
      segment_ticks_q <= segment_ticks_i;
    end
  end

  // What the segments are ahead of the pieces: ticks, path. What comes is a piece's with its bits
  // inverted, and the sum's carry, or a segment's.
  logic signed [47:0] ticks_q;
  logic signed [47:0] ticks_change_q;
  logic signed [59:0] path_q;
  logic signed [59:0] path_change_q;
  logic less_q;
  always_ff @(posedge clk_i) begin
    ticks_change_q <= piece_i ? ~{28'b0, piece_ticks_i} : {16'b0, segment_ticks_q};
    path_change_q  <= piece_i ? ~{16'b0, ds_i} : {16'b0, length_q};
    if (!rst_ni || !(piece_i || waits_q)) begin
      ticks_change_q <= '0;
      path_change_q  <= '0;
    end
    less_q <= rst_ni && piece_i;
    if (!rst_ni) begin
      ticks_q <= '0;
      path_q  <= '0;
      apart_o <= 1'b0;
    end else begin
      ticks_q <= ticks_q + ticks_change_q + 48'(less_q);
      path_q  <= path_q + path_change_q + 60'(less_q);
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
