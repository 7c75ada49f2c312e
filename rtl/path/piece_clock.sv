// SPDX-License-Identifier: Apache-2.0
// Time within profile pieces: the piece and the place in it where each tick ends. Twin:
// PathKernel::tick of hls/path_kernel.hpp.
//
// A tick of rate r moves time by r / 2^16 ticks; the time beyond a piece's end belongs to the next
// piece. Time waits at the end of the last piece there is. A tick waits while its piece is queued
// but not loaded. No program begins in a tick that is held.
//
//   clock          0     3     6
//   rate_valid_i   1
//   rate_ready_o   1
//   slot_i               1
//   tick_taken_o         1              at the earliest
//   next_take_o          piece's end
//   valid_o                    1
//   time_o, ..                 of the tick
//
// An event, valid_o, states the place of the path in piece bank_o at the end of the tick:
//   begin_o    the piece before is over, this one begins
//   still_o    nowhere: no piece is under way
//   end_o      at the piece's end
//   else       at time_o, below 2^(time_exponent_o + 16)
`default_nettype none
module piece_clock #(
    parameter int BankBits = 3  // [1, 5]
) (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic slot_i,  // a tick may be taken

    // Pieces; next_ticks_i is stable from 2 clocks before next_valid_i
    input  wire logic                queued_i,              // complete ones, the next included
    input  wire logic                next_valid_i,
    output logic                     next_take_o,
    input  wire logic [        19:0] next_ticks_i,
    input  wire logic [         4:0] next_time_exponent_i,
    input  wire logic                next_final_i,
    input  wire logic [BankBits-1:0] next_bank_i,

    // Ticks
    input  wire logic        rate_valid_i,
    output logic             rate_ready_o,
    input  wire logic [16:0] rate_i,
    input  wire logic        held_i,        // its target is 0
    output logic             tick_taken_o,

    // Events
    output logic                valid_o,
    output logic                begin_o,
    output logic                still_o,
    output logic                end_o,
    output logic [        35:0] time_o,
    output logic [         4:0] time_exponent_o,
    output logic [BankBits-1:0] bank_o,
    output logic [        16:0] rate_o,

    // The present piece
    output logic               active_o,
    output logic               last_o,       // it is final
    output logic signed [21:0] ticks_left_o  // a lower bound, less 2
);

  initial if (BankBits < 1 || BankBits > 5) $fatal(1, "BankBits must be in [1, 5]");

  // The present tick and the two after it; no tick is a tick of rate 0.
  logic head_valid_q;
  logic [16:0] head_q;
  logic after_valid_q;
  logic [16:0] after_q;
  logic third_valid_q;
  logic [16:0] third_q;
  logic after_held_q;
  logic third_held_q;

  // Rest of the piece after the present tick, less one: negative when the tick passes its end.
  // Counted in ticks with 16 fraction bits.
  logic signed [37:0] left_q;
  assign ticks_left_o = left_q[37:16];
  logic over;
  logic active_d;
  assign over = left_q[37];

  // Next piece, less the tick after the present one.
  logic signed [37:0] gain_q;
  logic signed [37:0] next_ticks;
  assign next_ticks = {2'b0, next_ticks_i, 16'b0};

  logic may;
  logic runs;
  logic barred_q;  // the present tick is held and no program is under way
  logic ends;  // nothing follows, even if queued
  logic passes;
  logic stops;
  logic advance;
  assign may          = slot_i && head_valid_q;
  assign runs         = may && !over;
  assign ends         = last_o || barred_q;
  assign passes       = may && over && !ends && next_valid_i;
  assign stops        = may && over && (ends || !queued_i);
  assign advance      = !head_valid_q || runs || passes || stops;

  assign next_take_o  = passes;
  assign tick_taken_o = runs || passes || stops;
  assign rate_ready_o = advance;

  logic signed [37:0] after;
  assign after = {21'b0, after_q};
  logic signed [37:0] left_run;
  logic signed [37:0] left_pass;
  assign left_run  = left_q - after;
  assign left_pass = left_q + gain_q;
  logic signed [37:0] gain_moved;
  logic signed [37:0] gain_kept;
  assign gain_moved = next_ticks - $signed({21'b0, third_q});
  assign gain_kept  = next_ticks - after;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      head_valid_q  <= 1'b0;
      after_valid_q <= 1'b0;
      after_q       <= '0;
      third_valid_q <= 1'b0;
      third_q       <= '0;
      left_q        <= -38'sd1;
    end else if (advance) begin
      head_valid_q  <= after_valid_q;
      after_valid_q <= third_valid_q;
      after_q       <= third_q;
      third_valid_q <= rate_valid_i;
      third_q       <= rate_valid_i ? rate_i : '0;
      if (passes) left_q <= left_pass;
      else if (stops) left_q <= ~after;
      else left_q <= left_run;
    end
  end
  always_ff @(posedge clk_i) begin
    if (advance) begin
      head_q       <= after_q;
      barred_q     <= after_held_q && !active_d;
      after_held_q <= third_held_q;
      third_held_q <= held_i;
    end
    gain_q <= advance ? gain_moved : gain_kept;
  end

  // The present piece.  It is at its end when time has waited there, or when it is one tick long
  // and a whole tick waited for it.
  logic waits_q;
  logic whole;
  assign active_d = passes || (active_o && !(stops && last_o));
  assign whole = waits_q && head_q[16] && next_ticks_i == 20'd1;
  logic [19:0] ticks_q;
  logic [4:0] time_exponent_q;
  logic [BankBits-1:0] bank_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      active_o <= 1'b0;
      last_o   <= 1'b0;
      waits_q  <= 1'b1;
    end else begin
      active_o <= active_d;
      if (passes) last_o <= next_final_i;
      else if (stops) last_o <= 1'b0;
      if (passes) waits_q <= whole;
      else if (stops) waits_q <= 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (passes) begin
      ticks_q         <= next_ticks_i;
      time_exponent_q <= next_time_exponent_i;
      bank_q          <= next_bank_i;
    end
  end

  // Events: time = ticks - (left + 1 + the present tick).
  logic [2:1] valid_q;
  logic [2:1] begin_q;
  logic [2:1] still_q;
  logic [2:1] end_q;
  logic [16:0] rate_1_q;
  logic [16:0] rate_2_q;
  logic [35:0] elapsed_q;
  logic [35:0] beyond_q;
  logic [4:0] time_exponent_2_q;
  logic [BankBits-1:0] bank_2_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q <= '0;
      valid_o <= 1'b0;
    end else begin
      valid_q <= {valid_q[1], tick_taken_o};
      valid_o <= valid_q[2];
    end
  end
  always_ff @(posedge clk_i) begin
    begin_q           <= {begin_q[1], passes};
    still_q           <= {still_q[1], stops && !active_o};
    end_q             <= {end_q[1], stops || (passes && whole)};
    begin_o           <= begin_q[2];
    still_o           <= still_q[2];
    end_o             <= end_q[2];

    rate_1_q          <= head_q;
    rate_2_q          <= rate_1_q;
    rate_o            <= rate_2_q;

    elapsed_q         <= {ticks_q, 16'b0} - {19'b0, head_q};
    beyond_q          <= ~left_q[35:0];
    time_o            <= elapsed_q + beyond_q;

    time_exponent_2_q <= time_exponent_q;
    bank_2_q          <= bank_q;
    time_exponent_o   <= time_exponent_2_q;
    bank_o            <= bank_2_q;
  end

endmodule
`default_nettype wire
