// SPDX-License-Identifier: Apache-2.0
// Stops time before the profile runs out. It counts the ticks that are queued: whole pieces and the
// rest of the present one, less the ticks that are started and not yet taken from it.
//
//     hold      when they no longer exceed the ticks that a stop takes
//     go on     when they exceed twice as many
//
// No hold when a final piece is queued or under way, when no piece is under way, and when the queue
// is three quarters full: it cannot get what does not fit.
//
// The counts are up to 8 clocks old, and a clock starts one tick at most: 8 ticks more are kept.
`default_nettype none
module underrun_guard (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic [31:0] stop_ticks_i,  // from full rate; stands still

    // The queue
    input wire logic        plenty_i,
    input wire logic        final_i,
    input wire logic [31:0] ticks_i,

    // The present piece
    input wire logic               active_i,
    input wire logic               present_final_i,
    input wire logic signed [21:0] present_ticks_i,

    input wire logic [4:0] started_i,  // ticks that are on their way to it

    output logic hold_o,
    output logic underrun_o  // there was a hold
);

  localparam logic [33:0] Age = 34'd8;

  logic signed [33:0] present_q;
  logic signed [33:0] left_q;
  logic low_q;
  logic enough_q;
  logic signed [33:0] stop_q;
  logic signed [33:0] go_q;
  logic signed [33:0] over_stop;
  logic signed [33:0] over_go;
  assign over_stop = stop_q - left_q;
  assign over_go   = go_q - left_q;
  always_ff @(posedge clk_i) begin
    stop_q    <= {2'b0, stop_ticks_i} + Age;
    go_q      <= {1'b0, stop_ticks_i, 1'b0} + Age;
    present_q <= 34'(present_ticks_i) - $signed({29'b0, started_i});
    left_q    <= $signed({2'b0, ticks_i}) + present_q;
    low_q     <= !over_stop[33];
    enough_q  <= over_go[33];
  end

  logic exempt_q;
  always_ff @(posedge clk_i) begin
    exempt_q <= !active_i || present_final_i || final_i || plenty_i;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      hold_o     <= 1'b0;
      underrun_o <= 1'b0;
    end else begin
      if (exempt_q || enough_q) hold_o <= 1'b0;
      else if (low_q) begin
        hold_o     <= 1'b1;
        underrun_o <= 1'b1;
      end
    end
  end

endmodule
`default_nettype wire
