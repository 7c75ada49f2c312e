// SPDX-License-Identifier: Apache-2.0
// Stops time before the words run out.  It counts the covered ticks: by pieces, the waiting ones
// and the rest of the present one, less the ticks started and not yet taken from it; by segments,
// lead_i more.
//
//     hold      when either no longer exceeds the ticks that a stop takes
//     continue  when both exceed twice as many, or once with a full queue: it gets no more
//
// A stream whose program is complete covers it to its end: for a hold the program under way counts,
// for the next program's start (begin_o), if time could continue, the next one.  No hold when no
// piece is under way.  A full queue that does not cover a stop never will: fault_o.
//
// The counts are up to 10 clocks old, and a clock starts one tick at most: 10 ticks more are kept.
// A queue is full here once the frame that filled it is in all counts, and has room again at once.
`default_nettype none
module underrun_guard (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic [31:0] stop_ticks_i,  // ticks from full rate to a stop; constant

    // The queues
    input wire logic               pieces_full_i,
    input wire logic        [31:0] ticks_i,
    input wire logic               segments_full_i,
    input wire logic signed [31:0] lead_i,

    // Segments and pieces: for the program under way, and for the one that begins next
    input wire logic [1:0] complete_i,
    input wire logic [1:0] next_complete_i,

    // The present piece
    input wire logic               active_i,
    input wire logic signed [21:0] present_ticks_i,

    input wire logic [4:0] started_i,  // ticks on their way to it

    output logic hold_o,
    output logic begin_o,
    output logic underrun_o,  // there was a hold
    output logic fault_o      // a full queue did not cover a stop
);

  localparam logic [5:0] Age = 6'd10;
  localparam int Counted = 6;  // clocks until a frame that has come in is counted

  // Ticks that are kept back count as started.
  logic signed [33:0] stop;
  logic signed [33:0] go;
  logic [5:0] gone;
  logic signed [22:0] present_q;
  logic signed [33:0] pieces_q;
  logic signed [33:0] segments_q;
  logic signed [31:0] lead_q;
  logic signed [33:0] pieces_over_stop;
  logic signed [33:0] pieces_over_go;
  logic signed [33:0] segments_over_stop;
  logic signed [33:0] segments_over_go;
  assign stop               = {2'b0, stop_ticks_i};
  assign go                 = {1'b0, stop_ticks_i, 1'b0};
  assign gone               = {1'b0, started_i} + Age;
  assign pieces_over_stop   = stop - pieces_q;
  assign pieces_over_go     = go - pieces_q;
  assign segments_over_stop = stop - segments_q;
  assign segments_over_go   = go - segments_q;

  logic [1:0] complete_q[2];
  logic [1:0] next_complete_q[2];
  logic [Counted:0] pieces_full_q;
  logic [Counted:0] segments_full_q;
  logic [1:0] full;
  logic [1:0] low;
  logic [1:0] enough;
  always_ff @(posedge clk_i) begin
    present_q          <= 23'(present_ticks_i) - $signed({17'b0, gone});
    pieces_q           <= $signed({2'b0, ticks_i}) + 34'(present_q);
    lead_q             <= lead_i;  // as old as the ticks in pieces_q
    segments_q         <= pieces_q + 34'(lead_q);
    complete_q[0]      <= complete_i;
    complete_q[1]      <= complete_q[0];
    next_complete_q[0] <= next_complete_i;
    next_complete_q[1] <= next_complete_q[0];
    pieces_full_q      <= rst_ni ? {pieces_full_q[Counted-1:0], pieces_full_i} : '0;
    segments_full_q    <= rst_ni ? {segments_full_q[Counted-1:0], segments_full_i} : '0;
    low                <= {!segments_over_stop[33], !pieces_over_stop[33]};
    enough             <= {segments_over_go[33], pieces_over_go[33]};
  end

  // Either stream, both streams
  logic [1:0] ample;
  logic runs_low;
  logic covered;
  logic next_covered;
  logic short_queue;
  assign full         = {&segments_full_q[Counted:1], &pieces_full_q[Counted:1]};
  assign ample        = enough | (full & ~low);
  assign runs_low     = (low & ~complete_q[1]) != 2'b00;
  assign covered      = (complete_q[1] | ample) == 2'b11;
  assign next_covered = (next_complete_q[1] | ample) == 2'b11;
  assign short_queue  = (low & full & ~complete_q[1]) != 2'b00;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      hold_o     <= 1'b0;
      begin_o    <= 1'b0;
      underrun_o <= 1'b0;
      fault_o    <= 1'b0;
    end else begin
      begin_o <= next_covered;
      if (short_queue) fault_o <= 1'b1;
      if (!active_i || covered) hold_o <= 1'b0;
      else if (runs_low) begin
        hold_o     <= 1'b1;
        underrun_o <= 1'b1;
      end
    end
  end

endmodule
`default_nettype wire
