// SPDX-License-Identifier: Apache-2.0
// Profile pieces tick by tick, in the serial build: the decisions in the program of
// rtl/path/path_datapath.sv, which is rtl/path/path_program.sv. Twin: PathKernel::tick of
// hls/path_kernel.hpp.
//
//   clock          0    6    7    16     n
//   rate_valid_i   1
//   rate_ready_o   1                     n + 1
//   tick_taken_o        1                        inside a piece
//   tick_taken_o             1                   no piece follows
//   tick_taken_o                  1              a program or a piece begins; at the earliest
//   ds_valid_o                           1       n < kSerialTickClocks of hls/clocks.hpp, + what it
//   ds_ready_i                           1       waited for a piece; until it is taken
//
// A tick of rate r moves time by r / 2^16 ticks; the time beyond a piece's end belongs to the next
// piece. Time waits at the end of the last piece there is. A tick waits while its piece is queued
// but not loaded. No program begins in a tick that is held. One tick is under way at a time.
`default_nettype none
module path_sequencer (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Pieces
    input  wire logic       queued_i,              // complete ones, the next included
    input  wire logic       next_valid_i,          // valid until next_take_o
    output logic            next_take_o,
    input  wire logic       next_final_i,
    input  wire logic [4:0] next_time_exponent_i,  // m
    input  wire logic [5:0] next_exponent_i,       // e

    // Ticks
    input  wire logic        rate_valid_i,
    output logic             rate_ready_o,
    input  wire logic [16:0] rate_i,
    input  wire logic        held_i,        // target 0
    output logic             tick_taken_o,
    output logic      [16:0] rate_o,        // rate of the tick under way

    // Datapath
    output logic      [path_control_pkg::Bits-1:0] control_o,
    output logic      [path_control_pkg::Bits-1:0] ahead_o,    // word of the next clock
    output logic      [                       1:0] pass_o,     // pass of the coefficient read
    input  wire logic                              negative_i, // the sum

    // Increments
    output logic      ds_valid_o,   // the sum is one
    input  wire logic ds_ready_i,
    output logic      ds_active_o,  // a program was under way
    output logic      look_o,       // the sum is time in the piece less its end

    // The present piece
    output logic active_o,
    output logic last_o
);

  // The program
  localparam int Bits = path_control_pkg::WordBits;
  logic [5:0] place;
  logic fetch;
  logic stay;
  logic jump;
  logic holds;
  logic [3:0] condition;
  logic [Bits-1:0] fetched;
  logic [Bits-1:0] word;
  path_program u_program (
      .clk_i,
      .en_i   (fetch),
      .place_i(place),
      .word_o (fetched)
  );
  program_fetch #(
      .Bits(Bits)
  ) u_fetch (
      .clk_i,
      .rst_ni,
      .stay_i   (stay),
      .jump_i   (jump),
      .target_i (word[path_control_pkg::Target+:6]),
      .place_o  (place),
      .fetch_o  (fetch),
      .fetched_i(fetched),
      .word_o   (word)
  );
  assign condition = word[path_control_pkg::Condition+:4];
  assign stay      = holds && word[path_control_pkg::Stay];
  assign jump      = holds && !word[path_control_pkg::Stay];
  assign control_o = word[path_control_pkg::Bits-1:0];
  assign ahead_o   = fetched[path_control_pkg::Bits-1:0];

  // Numbers of halves: 16 + m for a product, 34 - e for a result; below 0 it doubles
  logic held_q;
  logic [4:0] time_exponent_q;
  logic [5:0] exponent_q;
  logic [6:0] count_q;  // down from m to -15, from -1 - e to -34, or up to -36
  always_comb begin
    case (condition)
      path_control_pkg::Always:       holds = 1'b1;
      path_control_pkg::NoRate:       holds = !rate_valid_i;
      path_control_pkg::Runs:         holds = active_o && negative_i;
      path_control_pkg::Stops:        holds = last_o || (held_q && !active_o) || !queued_i;
      path_control_pkg::NotLoaded:    holds = !next_valid_i;
      path_control_pkg::NotActive:    holds = !active_o;
      path_control_pkg::WasNotActive: holds = !ds_active_o;
      path_control_pkg::MoreBits:     holds = count_q != -7'd15;
      path_control_pkg::LastPass:     holds = pass_o == 2'd3;
      path_control_pkg::IsAbove:      holds = exponent_q > 6'd34;
      path_control_pkg::IsExact:      holds = exponent_q == 6'd34;
      path_control_pkg::MoreHalves:   holds = count_q != -7'd34;
      path_control_pkg::MoreDoubles:  holds = count_q != -7'd36;
      path_control_pkg::Negative:     holds = negative_i;
      path_control_pkg::NotSent:      holds = !ds_ready_i;
      default:                        holds = 1'b0;
    endcase
  end

  logic runs;
  logic stops;
  assign runs         = condition == path_control_pkg::Runs && jump;
  assign stops        = condition == path_control_pkg::Stops && jump;
  assign rate_ready_o = word[path_control_pkg::Ready];
  assign next_take_o  = word[path_control_pkg::Take];
  assign ds_valid_o   = word[path_control_pkg::Send];
  assign tick_taken_o = runs || stops || next_take_o;
  assign look_o       = runs || next_take_o || (stops && active_o);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      active_o <= 1'b0;
      last_o   <= 1'b0;
    end else if (next_take_o) begin
      active_o <= 1'b1;
      last_o   <= next_final_i;
    end else if (stops) begin
      active_o <= active_o && !last_o;
      last_o   <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (rate_ready_o) begin
      rate_o <= rate_i;
      held_q <= held_i;
    end
    if (tick_taken_o) ds_active_o <= active_o || !stops;
    if (next_take_o) begin
      time_exponent_q <= next_time_exponent_i;
      exponent_q      <= next_exponent_i;
    end
    if (!rst_ni) pass_o <= 2'd0;
    else if (word[path_control_pkg::Next]) pass_o <= pass_o + 2'd1;
    if (control_o[path_control_pkg::Load]) count_q <= {2'b0, time_exponent_q};
    else if (control_o[path_control_pkg::Halve]) count_q <= count_q - 7'd1;
    else if (condition == path_control_pkg::IsAbove) count_q <= {1'b1, ~exponent_q};
    else if (condition == path_control_pkg::MoreDoubles) count_q <= count_q + 7'd1;
  end

endmodule
`default_nettype wire
