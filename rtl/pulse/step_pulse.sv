// SPDX-License-Identifier: Apache-2.0
// Steps of one axis as pulses that a drive can see.
//
//   step_o       ____/^^^^^^^^^\____________________________/^^^^^^^^^\__
//   direction_o  ______________________________/^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
//                    | steplen |    dirhold    |  dirsetup  |
//                              | stepspace, at least        |
//
// A due step (hit_i, in the direction back_i) goes out two clocks later, or else in the first clock
// that the times allow. The pin turns with back_i, before the first step back is due, when all
// earlier steps are out; not within stepspace.
//
// Up to 3 steps wait in each direction, and one turn between them. A step beyond is dropped and
// reported by overrun_o; steps never cancel each other.
//
// stop_i: the pulse ends at once, steps that wait are dropped, both pins stand still. If it cut a
// pulse short, the drive may or may not have seen it: uncertain_o. Both flags stay until clear_i.
// Twin: StepPulse of hls/step_axis.hpp.
`default_nettype none
module step_pulse #(
    parameter int TimeBits = 12  // [4, 16]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Times in clocks, from pulse_times
    input wire logic [TimeBits-1:0] length_i,
    input wire logic [TimeBits-1:0] setup_i,
    input wire logic [TimeBits-1:0] again_i,
    input wire logic [TimeBits-1:0] turn_i,
    input wire logic                length_1_i,
    input wire logic                setup_1_i,

    input wire logic hit_i,
    input wire logic back_i,
    input wire logic stop_i,
    input wire logic clear_i,

    output logic step_o,
    output logic direction_o,
    output logic rise_o,       // step_o rises after this clock
    output logic overrun_o,
    output logic uncertain_o
);

  // Waiting steps, as that many ones from below.
  logic [2:0] forth_q;
  logic [2:0] back_q;
  logic here;  // some in the direction of the pin
  logic there;  // some in the other
  assign here  = direction_o ? back_q[0] : forth_q[0];
  assign there = direction_o ? forth_q[0] : back_q[0];

  // Times that are over. age_q: clocks since the last pulse began or the pin turned, as they will
  // be after the next.
  logic [TimeBits-1:0] age_q;
  logic long_q;  // the pulse is long enough
  logic space_q;  // another one may follow
  logic hold_q;  // or a turn
  logic set_q;  // the direction is set up
  logic turn;
  logic fall;
  assign rise_o = here && space_q && set_q && !stop_i;
  assign turn = !here && (there || back_i != direction_o) && space_q && hold_q && set_q && !stop_i;
  assign fall = step_o && (long_q || stop_i);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q       <= '0;
      long_q      <= 1'b0;
      space_q     <= 1'b1;
      hold_q      <= 1'b1;
      set_q       <= 1'b1;
      step_o      <= 1'b0;
      direction_o <= 1'b0;
    end else begin
      age_q   <= rise_o || turn ? TimeBits'(2) : age_q + 1'b1;
      long_q  <= rise_o ? length_1_i : long_q || age_q == length_i;
      space_q <= !rise_o && (space_q || age_q == again_i);
      hold_q  <= !rise_o && (hold_q || age_q == turn_i);
      set_q   <= turn ? setup_1_i : set_q || age_q == setup_i;
      if (rise_o) step_o <= 1'b1;
      else if (fall) step_o <= 1'b0;
      if (turn) direction_o <= !direction_o;
    end
  end

  logic full;
  logic overrun;
  logic in_forth;
  logic in_back;
  logic out_forth;
  logic out_back;
  assign full = back_i ? back_q[2] : forth_q[2];
  assign overrun = hit_i && (full || (there && back_i == direction_o));
  assign in_forth = hit_i && !overrun && !back_i;
  assign in_back = hit_i && !overrun && back_i;
  assign out_forth = rise_o && !direction_o;
  assign out_back = rise_o && direction_o;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || stop_i) begin
      forth_q <= '0;
      back_q  <= '0;
    end else begin
      if (in_forth != out_forth) forth_q <= in_forth ? {forth_q[1:0], 1'b1} : {1'b0, forth_q[2:1]};
      if (in_back != out_back) back_q <= in_back ? {back_q[1:0], 1'b1} : {1'b0, back_q[2:1]};
    end
    if (!rst_ni || clear_i) begin
      overrun_o   <= 1'b0;
      uncertain_o <= 1'b0;
    end else begin
      overrun_o   <= overrun_o || (overrun && !stop_i);
      uncertain_o <= uncertain_o || (step_o && stop_i && !long_q);
    end
  end

endmodule
`default_nettype wire
