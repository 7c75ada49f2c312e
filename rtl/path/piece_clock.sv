// SPDX-License-Identifier: Apache-2.0
// Time within profile pieces: where in which piece each tick ends. Twin: PathKernel::tick of
// hls/path_kernel.hpp.
//
// A tick of rate r moves time by r / 2^16 ticks; what goes beyond a piece's end is time in the next
// piece. Time waits at the end of the last piece there is. A tick waits while its piece is queued
// but not loaded. The clock in which a program's first piece begins takes no tick.
//
//   clock          0          1        2
//   slot_i         1
//   rate_valid_i   1
//   rate_ready_o   1
//   next_take_o    piece's end
//   valid_o                            1
//   time_o, ..                         of the tick
//
// An event, valid_o, says how far the path is in piece bank_o when the tick (or begin) is over:
//   begin_o    the piece before is over, this one begins
//   still_o    nowhere: no piece is under way, or begin without a tick
//   end_o      at the piece's end
//   else       at time_o, below 2^(time_exponent_o + 16)
`default_nettype none
module piece_clock #(
    parameter int BankBits = 3  // [1, 5]
) (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic slot_i,  // an event may start

    // Pieces
    input  wire logic                queued_i,              // complete ones, next_valid_i included
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

    // Events
    output logic                valid_o,
    output logic                tick_o,
    output logic                begin_o,
    output logic                still_o,
    output logic                end_o,
    output logic [        35:0] time_o,
    output logic [         4:0] time_exponent_o,
    output logic [BankBits-1:0] bank_o,
    output logic [        16:0] rate_o,

    // The present piece
    output logic        active_o,
    output logic        final_o,
    output logic [19:0] ticks_left_o  // rounded down
);

  initial if (BankBits < 1 || BankBits > 5) $fatal(1, "BankBits must be in [1, 5]");

  logic signed [37:0] left_q;  // to the piece's end, ticks with 16 fraction bits
  logic [19:0] ticks_q;
  logic [4:0] time_exponent_q;
  logic [BankBits-1:0] bank_q;
  assign ticks_left_o = left_q[35:16];

  logic signed [37:0] rate;
  assign rate = {21'b0, rate_i};
  logic signed [37:0] left;
  assign left = left_q - rate;
  logic over;
  assign over = left_q <= rate;
  logic signed [37:0] next_left;
  assign next_left = left + $signed({2'b0, next_ticks_i, 16'b0});

  logic starts;
  logic stops;
  logic runs;
  logic idles;
  logic passes;
  always_comb begin
    starts = 1'b0;
    idles  = 1'b0;
    runs   = 1'b0;
    passes = 1'b0;
    stops  = 1'b0;
    if (slot_i && rate_valid_i) begin
      if (!active_o) begin
        starts = next_valid_i;
        idles  = !queued_i;
      end else if (!over) begin
        runs = 1'b1;
      end else if (final_o) begin
        stops = 1'b1;
      end else begin
        passes = next_valid_i;
        stops  = !queued_i;
      end
    end
  end
  assign next_take_o  = starts || passes;
  assign rate_ready_o = idles || runs || passes || stops;

  logic valid_q;
  logic tick_q;
  logic begin_q;
  logic still_q;
  logic end_q;
  logic [16:0] rate_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      active_o <= 1'b0;
      valid_q  <= 1'b0;
      valid_o  <= 1'b0;
    end else begin
      if (starts) active_o <= 1'b1;
      if (stops && final_o) active_o <= 1'b0;
      valid_q <= starts || rate_ready_o;
      valid_o <= valid_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (next_take_o) begin
      ticks_q         <= next_ticks_i;
      time_exponent_q <= next_time_exponent_i;
      final_o         <= next_final_i;
      bank_q          <= next_bank_i;
    end
    if (starts) left_q <= {2'b0, next_ticks_i, 16'b0};
    else if (passes) left_q <= next_left;
    else if (stops) left_q <= '0;
    else if (runs) left_q <= left;
    tick_q  <= rate_ready_o;
    begin_q <= next_take_o;
    still_q <= starts || idles;
    end_q   <= stops || (passes && next_left == 38'sd0);
    rate_q  <= rate_i;
  end

  always_ff @(posedge clk_i) begin
    tick_o <= tick_q;
    begin_o <= begin_q;
    still_o <= still_q;
    end_o <= end_q;
    time_o <= {ticks_q, 16'b0} - left_q[35:0];
    rate_o <= rate_q;
    bank_o <= bank_q;
    time_exponent_o <= time_exponent_q;
  end

endmodule
`default_nettype wire
