// SPDX-License-Identifier: Apache-2.0
// Settings of the motion: taken from the ports while nothing is under way, checked, and kept.
//
//   clock       0          1    2          3          4
//   .._i        new word
//   quiet_i                1    1
//   pause_o                1    1          0
//   restart_o                   1          1          0
//   .._o        old             new word
//   good_o      of the old                 of the new
//
// pause_o: no tick may start, until all is quiet. quiet_i: no sample is on its way, and no tick has
// begun. restart_o: the time scaler begins anew. good_o: time may run.
//
// settings_fault_o, sticky: a program waits while the settings are outside their ranges, or they
// changed while one is under way; that one keeps the settings of its start.
`default_nettype none
module motion_settings (
    input wire logic clk_i,
    input wire logic rst_ni,

    // The ports
    input wire logic [ 3:0] samples_per_tick_log2_i,
    input wire logic [31:0] hold_acceleration_i,      // [8, 2^31]
    input wire logic [32:0] hold_slope_i,             // [hold_acceleration_i, 2^32]
    input wire logic [31:0] stop_ticks_i,             // [1, 2^29)

    // The path side
    input wire logic active_i,  // a program is under way
    input wire logic queued_i,  // a piece of one is queued
    input wire logic quiet_i,

    output logic        pause_o,
    output logic        restart_o,
    output logic        good_o,
    output logic [ 3:0] samples_per_tick_log2_o,
    output logic [31:0] hold_acceleration_o,
    output logic [32:0] hold_slope_o,
    output logic [31:0] stop_ticks_o,
    output logic        settings_fault_o
);

  logic [100:0] asked;
  logic [100:0] taken_q;
  assign asked = {samples_per_tick_log2_i, hold_acceleration_i, hold_slope_i, stop_ticks_i};
  assign {samples_per_tick_log2_o, hold_acceleration_o, hold_slope_o, stop_ticks_o} = taken_q;

  logic same_q;
  logic take;
  assign pause_o = !same_q && !active_i;
  assign take    = pause_o && quiet_i;
  always_ff @(posedge clk_i) begin
    if (take) taken_q <= asked;
  end

  // Ranges that the counters of time can hold.
  logic acceleration_fits;
  logic slope_fits;
  logic stop_fits;
  assign acceleration_fits = hold_acceleration_o[31] ? hold_acceleration_o[30:0] == '0 :
      hold_acceleration_o[30:3] != '0;
  assign slope_fits = hold_slope_o >= {1'b0, hold_acceleration_o} &&
                      !(hold_slope_o[32] && hold_slope_o[31:0] != '0);
  assign stop_fits = stop_ticks_o[31:29] == '0 && stop_ticks_o[28:0] != '0;
  always_ff @(posedge clk_i) good_o <= acceleration_fits && slope_fits && stop_fits;

  logic changed;
  logic unfit;
  assign changed = active_i && !same_q;
  assign unfit   = queued_i && !active_i && same_q && !good_o;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      same_q           <= 1'b0;
      restart_o        <= 1'b1;
      settings_fault_o <= 1'b0;
    end else begin
      same_q    <= asked == taken_q;
      restart_o <= take;
      if (changed || unfit) settings_fault_o <= 1'b1;
    end
  end

endmodule
`default_nettype wire
