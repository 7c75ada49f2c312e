// SPDX-License-Identifier: Apache-2.0
// rtl/queue/program_ledger.sv: a stream whose program has ended waits until the other's has, too;
// then the two are apart exactly if path or ticks differ, and stay so. complete_o reports whether
// the last segment of the program under way is in, or of the next if there is none, next_complete_o
// the same of the one behind the final piece that is under way; lead_o is the ticks of all segments
// less those of all pieces, and never turns negative by overflow. Lengths and ticks are 0, 1 or
// 2^30.
// Frames come one at a time, those of a stream with a clock between; no program is over before its
// last segment is in.
// control: BLIND_TO_PATH s/(ticks_q != '0 || path_q != '0)/ticks_q != '0/
// control: BLIND_TO_TICKS s/(ticks_q != '0 || path_q != '0)/path_q != '0/
// control: TOO_EARLY s/if (both_q\[2\] /if (piece_i /
// control: WAITS_FOR_NONE s/wait_segments_o \&\& wait_pieces_o/wait_segments_o || wait_pieces_o/
// control: OLDEST s/newest  = {9'b0, wait_pieces_o}/newest = '0/
// control: NEXT_AS_PRESENT s/finals_i > newest;/finals_i + present > newest;/
// control: WRAPS s/far = !ticks_q\[47\] .*/far = 1'b0;/
// control: NO_RESET s/wait_pieces_o   <= 1'b0;//
`default_nettype none
module program_ledger_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic length_valid_i,
    input wire logic length_i,
    input wire logic segment_i,
    input wire logic segment_ticks_i,
    input wire logic large_i,
    input wire logic last_i,
    input wire logic ds_valid_i,
    input wire logic ds_i,
    input wire logic ds_turn_i,
    input wire logic piece_i,
    input wire logic piece_ticks_i,
    input wire logic final_i,
    input wire logic take_i,           // the final piece of the program under way, not present yet
    input wire logic over_i            // the program under way is over
);

  // As it should be, at once
  logic signed [2:0] path_q;
  logic signed [2:0] ticks_q;
  logic [1:0] large_q;
  logic [2:0] lasts_q;  // programs that are not over and have their last segment in
  logic [2:0] finals_q;  // or their final piece
  logic present_q;  // of one of them it is under way

  logic wait_segments;
  logic wait_pieces;
  logic complete;
  logic next_complete;
  logic signed [31:0] lead;
  logic apart;
  program_ledger u_dut (
      .clk_i,
      .rst_ni,
      .length_valid_i,
      .segment_i,
      .length_i({43'b0, length_i}),
      .segment_ticks_i({1'b0, large_i, 29'b0, segment_ticks_i}),
      .last_i,
      .ds_valid_i,
      .ds_turn_i,
      .piece_i,
      .ds_i({43'b0, ds_i}),
      .piece_ticks_i({19'b0, piece_ticks_i}),
      .final_i,
      .finals_i({7'b0, finals_q - {2'b0, present_q}}),
      .present_final_i(present_q),
      .wait_segments_o(wait_segments),
      .wait_pieces_o(wait_pieces),
      .complete_o(complete),
      .next_complete_o(next_complete),
      .lead_o(lead),
      .apart_o(apart)
  );

  logic started_q = 1'b0;
  logic ran_q;
  logic segment_q;
  logic piece_q;
  logic [3:0] both_q;  // clocks since both have ended their programs
  logic apart_q;
  logic complete_q;
  logic next_complete_q;
  logic segments_end;
  logic pieces_end;
  assign segments_end = segment_i && last_i;
  assign pieces_end   = piece_i && final_i;
  always_ff @(posedge clk_i) begin
    started_q       <= 1'b1;
    ran_q           <= rst_ni;
    segment_q       <= segment_i;
    piece_q         <= piece_i;
    complete_q      <= rst_ni && lasts_q != '0;
    next_complete_q <= rst_ni && lasts_q > {2'b0, present_q};
    if (!rst_ni) begin
      path_q <= '0;
      ticks_q <= '0;
      large_q <= '0;
      lasts_q <= '0;
      finals_q <= '0;
      present_q <= 1'b0;
      both_q <= '0;
      apart_q <= 1'b0;
    end else begin
      path_q  <= path_q + {2'b0, length_valid_i && length_i} - {2'b0, ds_valid_i && ds_i};
      ticks_q <= ticks_q + {2'b0, segment_i && segment_ticks_i} - {2'b0, piece_i && piece_ticks_i};
      if (segment_i && large_i) large_q <= large_q + 2'd1;
      lasts_q <= lasts_q + {2'b0, segments_end} - {2'b0, over_i};
      finals_q <= finals_q + {2'b0, pieces_end} - {2'b0, over_i};
      present_q <= take_i || (present_q && !over_i);
      both_q <= {both_q[2:0], (segments_end || wait_segments) && (pieces_end || wait_pieces)};
      if (both_q[3]) both_q <= '0;
      if (both_q[3] && (path_q != '0 || ticks_q != '0 || large_q != '0)) apart_q <= 1'b1;
    end
  end

  logic far;
  logic signed [31:0] ahead;
  logic signed [31:0] ahead_q;
  assign far   = large_q == 2'd2 && ticks_q >= 0;
  assign ahead = far ? 32'sh7fff_ffff : {large_q, 30'b0} + {{29{ticks_q[2]}}, ticks_q};
  always_ff @(posedge clk_i) begin
    ahead_q <= rst_ni ? ahead : '0;
  end

  logic segments_ended_q;
  logic pieces_ended_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || both_q[3]) begin
      segments_ended_q <= 1'b0;
      pieces_ended_q   <= 1'b0;
    end else begin
      if (segments_end) segments_ended_q <= 1'b1;
      if (pieces_end) pieces_ended_q <= 1'b1;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (segment_q || wait_segments) assume (!segment_i);
      if (piece_q || wait_pieces || segment_i) assume (!piece_i);
      if (ds_turn_i)
        assume (!length_valid_i);
        else assume (!ds_valid_i);
      assume (path_q != -3'sd4 && path_q != 3'sd3);
      assume (ticks_q != -3'sd4 && ticks_q != 3'sd3);
      if (large_q == 2'd2) assume (!large_i);
      if (lasts_q == '0 || !present_q) assume (!over_i);
      if (finals_q == '0 || present_q) assume (!take_i);
      if (segments_ended_q && pieces_ended_q && lasts_q == 3'd1) assume (!over_i);
      assume (lasts_q < 3'd4 && finals_q < 3'd4);

      Waits : assert ({wait_segments, wait_pieces} == {segments_ended_q, pieces_ended_q});
      Apart : assert (apart == apart_q);
      if (ran_q) Complete : assert (complete == complete_q && next_complete == next_complete_q);
      Lead : assert (lead == ahead_q);

      NextProgram : cover (lasts_q == 3'd2 && finals_q == 3'd2 && !apart && path_q != '0);
      FoundOut : cover (apart && lasts_q == 3'd2);
      Many : cover (lead == 32'sh7fff_ffff && !apart);
    end
  end

endmodule
`default_nettype wire
