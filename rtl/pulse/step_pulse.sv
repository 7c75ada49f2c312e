// SPDX-License-Identifier: Apache-2.0
// One axis' steps as pulses that a drive can see.
//
//   step_o       ____/^^^^^^^^^\____________________________/^^^^^^^^^\__
//   direction_o  ______________________________/^^^^^^^^^^^^^^^^^^^^^^^^^
//                    | steplen |    dirhold    |  dirsetup  |
//                              | stepspace, at least        |
//
// Times are in clocks; 0 counts as 1. A step that is due (hit_i, in the direction back_i) goes out
// two clocks later when nothing is in its way, else as soon as it may. The pin turns as soon as
// back_i says so, before the first step back is due, when all steps before are out.
//
// Up to 7 steps wait in each direction, and one turn between them. A step beyond is dropped, and
// overrun_o tells; no step is set off against another.
//
// stop_i: the pulse ends at once, steps that wait are dropped, both pins stand still. If it cut a
// pulse short, nobody knows whether the drive saw it: uncertain_o. Both flags stay until clear_i.
// Twin: StepPulse of hls/step_axis.hpp.
`default_nettype none
module step_pulse #(
    parameter int TimeBits = 12  // [4, 16]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Settings, [1, 2^TimeBits - 2]
    input wire logic [TimeBits-1:0] steplen_i,
    input wire logic [TimeBits-1:0] stepspace_i,
    input wire logic [TimeBits-1:0] dirsetup_i,
    input wire logic [TimeBits-1:0] dirhold_i,

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

  typedef enum logic [1:0] {
    Ready,
    High,
    Space,
    Setup
  } state_t;
  state_t state_q;

  logic done_q;  // the time of the state is over
  logic [2:0] forth_q;  // steps that wait
  logic [2:0] back_q;
  logic here;  // some in the direction of the pin
  logic there;  // some in the other
  logic full;
  logic overrun;
  logic free;
  logic turn;
  logic fall;
  logic rests;  // from Space or Setup to Ready
  assign here = direction_o ? back_q != '0 : forth_q != '0;
  assign there = direction_o ? forth_q != '0 : back_q != '0;
  assign full = back_i ? back_q == '1 : forth_q == '1;
  assign overrun = hit_i && !stop_i && (full || (there && back_i == direction_o));
  assign free = state_q == Ready || (state_q != High && done_q);
  assign rise_o = free && here && !stop_i;
  assign turn = state_q == Ready && done_q && !here && (there || back_i != direction_o) && !stop_i;
  assign rests = state_q != Ready && free && !rise_o;
  assign fall = state_q == High && (done_q || stop_i);

  // Clocks since the last edge of a pin, as they will be after the next; a time of one clock is
  // over at once.
  logic [TimeBits-1:0] age_q;
  logic [TimeBits-1:0] least;
  logic more;
  always_comb begin
    case (state_q)
      High: least = steplen_i;
      Space: least = stepspace_i;
      Setup: least = dirsetup_i;
      default: least = dirhold_i;
    endcase
  end
  always_comb begin
    if (rise_o) more = steplen_i > TimeBits'(1);
    else if (fall) more = stepspace_i > TimeBits'(1);
    else if (turn) more = dirsetup_i > TimeBits'(1);
    else more = rests || age_q < least;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q     <= Ready;
      age_q       <= '0;
      done_q      <= 1'b0;
      step_o      <= 1'b0;
      direction_o <= 1'b0;
    end else begin
      if (rise_o) state_q <= High;
      else if (fall) state_q <= Space;
      else if (turn) state_q <= Setup;
      else if (rests) state_q <= Ready;
      if (rise_o || fall || turn) age_q <= TimeBits'(2);
      else if (!done_q) age_q <= age_q + 1'b1;
      done_q <= !more;
      if (rise_o) step_o <= 1'b1;
      else if (fall) step_o <= 1'b0;
      if (turn) direction_o <= !direction_o;
    end
  end

  logic in_forth;
  logic in_back;
  logic out_forth;
  logic out_back;
  assign in_forth  = hit_i && !overrun && !back_i;
  assign in_back   = hit_i && !overrun && back_i;
  assign out_forth = rise_o && !direction_o;
  assign out_back  = rise_o && direction_o;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || stop_i) begin
      forth_q <= '0;
      back_q  <= '0;
    end else begin
      if (in_forth && !out_forth) forth_q <= forth_q + 1'b1;
      if (out_forth && !in_forth) forth_q <= forth_q - 1'b1;
      if (in_back && !out_back) back_q <= back_q + 1'b1;
      if (out_back && !in_back) back_q <= back_q - 1'b1;
    end
    if (!rst_ni || clear_i) begin
      overrun_o   <= 1'b0;
      uncertain_o <= 1'b0;
    end else begin
      overrun_o   <= overrun_o || overrun;
      uncertain_o <= uncertain_o || (fall && !done_q);
    end
  end

endmodule
`default_nettype wire
