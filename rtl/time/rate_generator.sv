// SPDX-License-Identifier: Apache-2.0
// Rates of time from requests for samples, one per tick.
//
//   requests -> gate -> targets -> idle gate -> scaler -> rates
//                 ^ settings ^--------------------'
//
// A request for the first of 2^samples_per_tick_log2_i samples starts a tick. Its rate follows
// override_i, or goes to 0 for kill_i, hold_i and underrun_i; at once while nothing is under way.
// With refused settings it is 0. Twin: TimeScaler of hls/time_scaler.hpp.
`default_nettype none
module rate_generator #(
    parameter int Room = 64  // [8, 128] samples between request and sent_i
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Settings, ranges: rtl/time/motion_settings.sv; active_i, queued_i: of a program's pieces
    input  wire logic [ 3:0] samples_per_tick_log2_i,
    input  wire logic [31:0] hold_acceleration_i,
    input  wire logic [32:0] hold_slope_i,
    input  wire logic [31:0] stop_ticks_i,
    input  wire logic        active_i,
    input  wire logic        queued_i,
    output logic      [ 3:0] samples_per_tick_log2_o,
    output logic      [31:0] stop_ticks_o,
    output logic             settings_fault_o,

    // Requests
    input  wire logic        request_valid_i,
    output logic             request_ready_o,
    input  wire logic        kill_i,
    input  wire logic        hold_i,
    input  wire logic        underrun_i,
    input  wire logic [16:0] override_i,
    output logic             killed_o,
    output logic             standing_o,

    // Rates
    output logic             rate_valid_o,
    input  wire logic        rate_ready_i,
    output logic      [16:0] rate_o,
    output logic             held_o,        // the target is 0

    // Stop branches: rtl/time/stop_memory.sv
    output logic             scaled_o,      // a tick is taken
    output logic             steady_o,      // time rests in it
    output logic             passed_o,      // a tick of path time begins in it
    input  wire logic [20:0] due_i,         // begins, next_wait
    input  wire logic        step_valid_i,
    output logic             step_ready_o,
    input  wire logic [43:0] step_i,

    // Ticks and samples on their way
    input  wire logic       tick_taken_i,  // the path generator took one
    output logic      [4:0] started_o,     // ticks not yet taken, 16 at most
    input  wire logic       sent_i,        // a sample was sent to the curve core
    output logic            wanted_o,
    input  wire logic       leaves_i       // a sample left the core
);

  logic        pause;
  logic        restart;
  logic        good;
  logic        quiet;
  logic [31:0] hold_acceleration;
  logic [32:0] hold_slope;
  motion_settings u_settings (
      .clk_i,
      .rst_ni,
      .samples_per_tick_log2_i,
      .hold_acceleration_i,
      .hold_slope_i,
      .stop_ticks_i,
      .active_i,
      .queued_i,
      .quiet_i(quiet),
      .pause_o(pause),
      .restart_o(restart),
      .good_o(good),
      .samples_per_tick_log2_o,
      .hold_acceleration_o(hold_acceleration),
      .hold_slope_o(hold_slope),
      .stop_ticks_o,
      .settings_fault_o
  );

  // Ticks. The gate keeps room in the queues.
  logic tick;
  logic [16:0] target;
  sample_gate #(
      .Room(Room)
  ) u_gate (
      .clk_i,
      .rst_ni,
      .samples_per_tick_log2_i(samples_per_tick_log2_o),
      .pause_i(pause),
      .good_i(good),
      .quiet_o(quiet),
      .request_valid_i,
      .request_ready_o,
      .kill_i,
      .hold_i,
      .underrun_i,
      .override_i,
      .tick_o(tick),
      .target_o(target),
      .killed_o,
      .tick_taken_i,
      .started_o,
      .sent_i,
      .wanted_o
  );

  logic target_room;
  logic next_valid;
  logic next_ready;
  logic [16:0] next_target;
  logic next_differs;
  logic [16:0] target_q;  // target of the last tick
  always_ff @(posedge clk_i) if (tick) target_q <= target;
  word_queue #(
      .Bits (18),
      .Depth(16)
  ) u_target_queue (
      .clk_i,
      .rst_ni,
      .valid_i(tick),
      .ready_o(target_room),
      .data_i ({target != target_q, target}),
      .valid_o(next_valid),
      .ready_i(next_ready),
      .data_o ({next_differs, next_target})
  );

  logic free_valid;
  logic free_ready;
  logic land;
  logic stopping;
  idle_gate u_idle (
      .clk_i,
      .rst_ni(rst_ni && !restart),
      .valid_i(next_valid),
      .ready_o(next_ready),
      .differs_i(next_differs),
      .valid_o(free_valid),
      .ready_i(free_ready),
      .land_o(land),
      .stopping_i(stopping),
      .tick_taken_i,
      .active_i
  );

  logic scaled_valid;
  logic [16:0] scaled;
  logic scaled_held;
  logic scaled_still;
  time_scaler u_scaler (
      .clk_i,
      .rst_ni(rst_ni && !restart),
      .acceleration_i(hold_acceleration),
      .slope_i(hold_slope),
      .valid_i(free_valid),
      .ready_o(free_ready),
      .target_i(next_target),
      .land_i(land),
      .stopping_o(stopping),
      .steady_o,
      .passed_o,
      .next_wait_i(due_i[19:0]),
      .begins_i(due_i[20]),
      .step_valid_i,
      .step_ready_o,
      .step_ticks_i(step_i[words_pkg::StepTicksLow+:words_pkg::StepTicksBits]),
      .step_change_i(step_i[words_pkg::StepChangeLow+:words_pkg::StepChangeBits]),
      .step_last_i(step_i[words_pkg::StepLastLow]),
      .valid_o(scaled_valid),
      .rate_o(scaled),
      .held_o(scaled_held),
      .still_o(scaled_still)
  );

  logic rate_room;
  word_queue #(
      .Bits (18),
      .Depth(16)
  ) u_rate_queue (
      .clk_i,
      .rst_ni,
      .valid_i(scaled_valid),
      .ready_o(rate_room),
      .data_i ({scaled_held, scaled}),
      .valid_o(rate_valid_o),
      .ready_i(rate_ready_i),
      .data_o ({held_o, rate_o})
  );

  // This is a clock later, as the tick is reported too.
  logic asked_q;
  always_ff @(posedge clk_i) asked_q <= rst_ni && request_valid_i && request_ready_o;
  standstill u_standstill (
      .clk_i,
      .rst_ni,
      .tick_i(tick),
      .stops_i(target == '0),
      .scaled_i(scaled_valid),
      .held_i(scaled_held),
      .still_i(scaled_still),
      .started_i(started_o),
      .taken_i(tick_taken_i),
      .active_i,
      .asked_i(asked_q),
      .leaves_i,
      .standing_o
  );

  assign scaled_o = free_valid && free_ready;

  logic unused_room;
  assign unused_room = target_room && rate_room;

endmodule
`default_nettype wire
