// SPDX-License-Identifier: Apache-2.0
// The gate between the queue of targets and the time scaler: a tick is on its target at once while
// nothing is under way. Twin: TimeScaler::lands of hls/time_scaler.hpp, PathKernel::idle of
// hls/path_kernel.hpp.
//
//   clock      0
//   valid_i    1
//   valid_o    1     or later, while it is unknown what is under way
//   land_o     of the tick: no program was under way in the IdleTicks ticks before it
//
// A tick waits only if it would land, that is if a target has changed since one did, and no program
// is under way, until the path generator has taken all ticks ahead of it: any of them may begin
// one. Those ahead are fewer than IdleTicks, so it need not wait while a program is under way.
`default_nettype none
module idle_gate (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Ticks
    input  wire logic valid_i,
    output logic      ready_o,
    input  wire logic differs_i,  // its target differs from the last tick's
    output logic      valid_o,
    input  wire logic ready_i,
    output logic      land_o,

    input wire logic stopping_i,    // a branch makes a stop, which goes on
    input wire logic tick_taken_i,  // the path generator took one
    input wire logic active_i       // a program is under way, in the ticks taken
);

  localparam int Idle = words_pkg::IdleTicks;
  localparam int Count = $clog2(Idle + 1);

  logic [Count-1:0] ahead_q;  // ticks that have passed and are not taken
  logic [Count-1:0] idle_q;  // last ticks taken without a program, Idle at most
  logic taken_q;  // one was taken in the last clock: idle_q lacks it
  logic unsettled_q;  // a target has changed since a tick landed
  logic may_land;
  logic known;
  logic waits;
  logic passes;
  assign may_land = (differs_i || unsettled_q) && !active_i;
  assign known    = ahead_q == '0 && !taken_q;
  assign waits    = may_land && !known;
  assign land_o   = may_land && idle_q == Count'(Idle) && !stopping_i;
  assign valid_o  = valid_i && !waits;
  assign ready_o  = ready_i && !waits;
  assign passes   = valid_o && ready_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ahead_q     <= '0;
      idle_q      <= Count'(Idle);
      taken_q     <= 1'b0;
      unsettled_q <= 1'b1;
    end else begin
      if (passes != tick_taken_i) ahead_q <= ahead_q + {{(Count - 1) {tick_taken_i}}, 1'b1};
      if (taken_q && active_i) idle_q <= '0;
      else if (taken_q && idle_q != Count'(Idle)) idle_q <= idle_q + 1'b1;
      taken_q <= tick_taken_i;
      if (passes) unsettled_q <= !land_o && (unsettled_q || differs_i);
    end
  end

endmodule
`default_nettype wire
