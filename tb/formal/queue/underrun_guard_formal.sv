// SPDX-License-Identifier: Apache-2.0
// rtl/queue/underrun_guard.sv: hold comes exactly where the ticks that a stream covers, as they
// were some clocks before, do not exceed stop ticks + 10; it goes where those of both exceed twice
// as many + 10, or a full queue's exceed a stop, or nothing can run out; it stays otherwise. A
// program begins where a hold would go, if that program were under way; underrun and fault are
// sticky; after reset there is neither. Counts are small ones.
// control: LATE s/pieces_over_stop   = stop - pieces_q;/pieces_over_stop   = go - pieces_q;/
// control: NO_HYSTERESIS s/{1'b0, stop_ticks_i, 1'b0}/{2'b0, stop_ticks_i}/
// control: FORGETS_SEGMENTS s/pieces_q + 34'(lead_q)/pieces_q/
// control: HOLDS_COMPLETE s/(low \& ~complete_q\[1\]) != 2'b00/low != 2'b00/
// control: BEGINS_AS_BEFORE s/begin_o <= next_covered/begin_o <= covered/
// control: FORGETS_STARTED s/{1'b0, started_i} + Age/Age/
// control: TRUSTS_FULL s/(full \& ~low)/full/
// control: FULL_TOO_SOON s/pieces_full_q\[Counted:1\]/pieces_full_q[Counted-1:1]/
// control: NO_RESET s/underrun_o <= 1'b0;//
`default_nettype none
module underrun_guard_formal (
    input wire logic              clk_i,
    input wire logic              rst_ni,
    input wire logic        [2:0] stop_i,
    input wire logic        [1:0] full_i,
    input wire logic        [1:0] complete_i,
    input wire logic        [1:0] next_complete_i,
    input wire logic        [4:0] ticks_i,
    input wire logic signed [4:0] lead_i,
    input wire logic              active_i,
    input wire logic signed [4:0] present_i,
    input wire logic        [1:0] started_i
);

  logic hold;
  logic begins;
  logic underrun;
  logic fault;
  underrun_guard u_dut (
      .clk_i,
      .rst_ni,
      .stop_ticks_i({29'b0, stop_i}),
      .pieces_full_i(full_i[0]),
      .ticks_i({27'b0, ticks_i}),
      .segments_full_i(full_i[1]),
      .lead_i({{27{lead_i[4]}}, lead_i}),
      .complete_i,
      .next_complete_i,
      .active_i,
      .present_ticks_i({{17{present_i[4]}}, present_i}),
      .started_i({3'b0, started_i}),
      .hold_o(hold),
      .begin_o(begins),
      .underrun_o(underrun),
      .fault_o(fault)
  );

  // Ticks as they stood, clock by clock along the guard's registers.
  logic [2:0] age_q = 3'd0;
  logic [2:0] stop_q;
  logic signed [8:0] present_q;
  logic signed [8:0] pieces_q[2];
  logic signed [8:0] segments_q;
  logic signed [4:0] lead_q;
  logic signed [8:0] segments_before_q;
  logic [1:0] complete_q[2];
  logic [1:0] next_q[3];  // next_complete_i
  logic [1:0] full_q[7];
  logic [1:0] full;
  always_comb begin
    full = 2'b11;
    for (int n = 1; n < 7; n = n + 1) full = full & full_q[n];
  end
  logic active_q;
  logic ran_q;  // no reset in the clock before
  logic [2:0] ran_long_q;
  logic was_hold_q;
  logic ever_q;
  logic signed [8:0] low;
  logic signed [8:0] enough;
  assign low    = $signed({6'b0, stop_q}) + 9'sd10;
  assign enough = $signed({5'b0, stop_q, 1'b0}) + 9'sd10;
  always_ff @(posedge clk_i) begin
    if (age_q != '1) age_q <= age_q + 3'd1;
    stop_q            <= stop_i;
    present_q         <= {{4{present_i[4]}}, present_i} - $signed({7'b0, started_i});
    pieces_q[0]       <= $signed({4'b0, ticks_i}) + present_q;
    pieces_q[1]       <= pieces_q[0];
    lead_q            <= lead_i;
    segments_q        <= pieces_q[0] + {{4{lead_q[4]}}, lead_q};
    segments_before_q <= segments_q;
    complete_q[0]     <= complete_i;
    complete_q[1]     <= complete_q[0];
    next_q[0]         <= next_complete_i;
    next_q[1]         <= next_q[0];
    next_q[2]         <= next_q[1];
    full_q[0]         <= rst_ni ? full_i : 2'b00;
    for (int n = 1; n < 7; n = n + 1) full_q[n] <= rst_ni ? full_q[n-1] : 2'b00;
    active_q   <= active_i;
    ran_q      <= rst_ni;
    was_hold_q <= hold && rst_ni;
    ever_q     <= rst_ni && (hold || ever_q);
  end

  logic signed [8:0] pieces_before_q;
  logic [1:0] complete_before_q;
  logic [1:0] full_before_q;
  always_ff @(posedge clk_i) begin
    pieces_before_q   <= pieces_q[0];
    complete_before_q <= complete_q[1];
    full_before_q     <= full;
  end
  logic signed [8:0] pieces_then_q;
  logic signed [8:0] segments_then_q;
  always_ff @(posedge clk_i) begin
    pieces_then_q   <= pieces_before_q;
    segments_then_q <= segments_before_q;
  end

  logic [1:0] is_low;
  logic [1:0] is_enough;
  logic [1:0] is_ample;
  logic covered;
  assign is_low    = {segments_then_q <= low, pieces_then_q <= low};
  assign is_enough = {segments_then_q > enough, pieces_then_q > enough};
  assign is_ample  = is_enough | (full_before_q & ~is_low);
  assign covered   = (complete_before_q | is_ample) == 2'b11;

  always_comb begin
    if (age_q != '0) assume (stop_i == stop_q);
    if (age_q < 3'd6) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      Sticky : assert (underrun == (ever_q || hold));
      if (!ran_q) AfterReset : assert (!hold && !underrun && !fault && !begins);
      if (ran_q) begin
        Begins : assert (begins == ((next_q[2] | is_ample) == 2'b11));
        if (!active_q || covered)
          GoesOn :
          assert (!hold);
          else if ((is_low & ~complete_before_q) != 2'b00)
            Holds :
            assert (hold);
            else Stays : assert (hold == was_hold_q);
        if ((is_low & full_before_q & ~complete_before_q) != 2'b00) ShortQueue : assert (fault);
      end

      Recovers : cover (ran_q && was_hold_q && !hold && active_q);
      SegmentsHold : cover (hold && pieces_then_q > enough && !complete_before_q[1]);
      Faults : cover (fault && !full_before_q[0] && !full_before_q[1]);
    end
  end

endmodule
`default_nettype wire
