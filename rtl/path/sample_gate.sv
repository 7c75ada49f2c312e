// SPDX-License-Identifier: Apache-2.0
// Admission of requests for samples, as many as the path side has room for. The first request of
// every 2^n starts a tick of time, and states its rate.
//
//   clock                    0           1
//   request_valid_i          1
//   request_ready_o          1
//   hold_i, override_i, ..   of the tick
//   tick_o                               1
//   target_o                             0 (kill, hold, underrun, !good) or override, 1 at most
//
// wanted_o: admitted samples remain that sent_i has not reported. Kill lasts until reset. No tick
// starts during pause_i; quiet_o: no sample is wanted, and no tick is half requested.
`default_nettype none
module sample_gate #(
    parameter int Room = 64  // [8, 128] samples between request and sent_i
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic [3:0] samples_per_tick_log2_i,  // n, changes only while quiet and paused
    input  wire logic       pause_i,
    input  wire logic       good_i,                   // the settings are valid
    output logic            quiet_o,

    input  wire logic request_valid_i,
    output logic      request_ready_o,

    // Rate of time
    input  wire logic        kill_i,
    input  wire logic        hold_i,
    input  wire logic        underrun_i,
    input  wire logic [16:0] override_i,
    output logic             tick_o,
    output logic      [16:0] target_o,
    output logic             killed_o,

    // On the way
    input  wire logic       tick_taken_i,  // ticks that the path generator takes of those started
    output logic      [4:0] started_o,     // ticks not yet taken, 16 at most
    input  wire logic       sent_i,        // a sample was sent
    output logic            wanted_o
);

  initial if (Room < 8 || Room > 128) $fatal(1, "Room must be in [8, 128]");

  logic [14:0] mask;
  assign mask = ~(15'h7fff << samples_per_tick_log2_i);

  logic [14:0] index_q;
  logic first;
  assign first = index_q == '0;

  // Both rooms are a clock old: two requests are kept back.
  logic [7:0] admitted_q;
  logic room_q;
  logic tick_room_q;
  assign request_ready_o = room_q && ((tick_room_q && !pause_i) || !first);
  assign quiet_o = admitted_q == '0 && first;
  logic admit;
  assign admit = request_valid_i && request_ready_o;
  logic tick;
  assign tick = admit && first;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      index_q     <= '0;
      admitted_q  <= '0;
      started_o   <= '0;
      room_q      <= 1'b0;
      tick_room_q <= 1'b0;
      wanted_o    <= 1'b0;
      tick_o      <= 1'b0;
      killed_o    <= 1'b0;
    end else begin
      if (admit) index_q <= (index_q + 1'b1) & mask;
      if (admit != sent_i) admitted_q <= admitted_q + {{7{sent_i}}, 1'b1};
      if (tick != tick_taken_i) started_o <= started_o + {{4{tick_taken_i}}, 1'b1};
      room_q      <= admitted_q <= 8'(Room - 2);
      tick_room_q <= started_o <= 5'd14;
      wanted_o    <= admit || admitted_q > {7'b0, sent_i};
      tick_o      <= tick;
      if (kill_i) killed_o <= 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (kill_i || killed_o || hold_i || underrun_i || !good_i) target_o <= '0;
    else if (override_i[16]) target_o <= 17'h1_0000;
    else target_o <= override_i;
  end

endmodule
`default_nettype wire
