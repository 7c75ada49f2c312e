// SPDX-License-Identifier: Apache-2.0
// All pins moved by samples: steps and directions with their counts; scan heads.
`default_nettype none
module motion_pins #(
    parameter int Axes       = 3,   // [3, 9]
    parameter int FineBits   = 42,  // [18, 44] bits of a position
    parameter int ScaleBits  = 44,  // [40, 56]
    parameter int PeriodLog2 = 13,  // [6, 20]
    parameter int TimeBits   = 12,  // [4, 16]
    parameter int Galvo      = 0,   // 0, 1
    parameter int Rates      = 0,   // 0, 1
    parameter int Shaper     = 0    // 0: none; [64, 512], a power of two
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // All of these: rtl/pulse/step_generator.sv
    // Scales: 2^-16 steps in 2^FineBits units of a position
    input wire logic                 scale_write_i,
    input wire logic [          3:0] scale_axis_i,
    input wire logic [ScaleBits-1:0] scale_i,

    // Times of the drives, in clocks, 0 counts as 1; steplen + stepspace and steplen + dirhold are
    // below 2^TimeBits. Levels of the pins
    input wire logic [TimeBits-1:0] steplen_i,
    input wire logic [TimeBits-1:0] stepspace_i,
    input wire logic [TimeBits-1:0] dirsetup_i,
    input wire logic [TimeBits-1:0] dirhold_i,
    input wire logic [    Axes-1:0] step_inverted_i,
    input wire logic [    Axes-1:0] direction_inverted_i,

    // Samples, axis 0 in the low bits
    input  wire logic                     sample_valid_i,
    output logic                          sample_ready_o,
    input  wire logic [Axes*FineBits-1:0] sample_i,
    input  wire logic                     begins_i,
    input  wire logic [         Axes-1:0] reference_i,

    // Positions axis by axis: rtl/pulse/place_scaler.sv
    input  wire logic                by_axis_i,
    output logic      [         3:0] axis_o,
    input  wire logic [FineBits-1:0] position_i,

    // Rates instead of samples, with Rates = 1
    output logic      [                                   4:0] rates_read_o,
    input  wire logic [pulse_pkg::StepFraction+PeriodLog2+3:0] rates_i,

    // Words of the shaper
    input  wire logic        shaper_write_i,
    input  wire logic [23:0] shaper_i,
    output logic             settled_o,

    // External inputs, and the same synchronised
    input  wire logic            estop_i,
    input  wire logic [Axes-1:0] limit_i,
    output logic                 estop_o,
    output logic      [Axes-1:0] limit_o,
    input  wire logic [Axes-1:0] limit_masked_i,  // limits to be ignored
    input  wire logic            stop_i,          // all axes, on this clock

    // Pins
    output logic [Axes-1:0] step_o,
    output logic [Axes-1:0] direction_o,
    output logic            galvo_clock_o,
    output logic            galvo_sync_o,
    output logic [     2:0] galvo_data_o,

    // Steps of an axis since the reset
    input  wire logic [       3:0] steps_axis_i,
    output logic      [      31:0] steps_o,
    output logic      [2*Axes-1:0] step_counts_o, // low bits of each axis' count

    // Events
    output logic            tick_o,
    output logic [Axes-1:0] referenced_o,
    output logic [Axes-1:0] uncertain_o,   // a pulse was cut: by one step
    output logic [Axes-1:0] overrun_o,     // a step was dropped
    output logic [Axes-1:0] refused_o,     // too fast
    output logic            late_o
);

  initial if (Rates == 1 && ScaleBits > 45) $fatal(1, "ScaleBits must be in [40, 45] with Build 2");
  initial
    if (Galvo == 1 && Shaper != 0)
      $fatal(1, "Galvo works without Shaper only: scan heads are not shaped");
  initial
    if (Galvo == 1 && Rates == 1)
      $fatal(1, "Galvo works with Build 0 only: with Build 2 samples have no positions");

  logic [Axes-1:0] rise;
  logic [Axes-1:0] back;
  step_generator #(
      .Axes(Axes),
      .FineBits(FineBits),
      .ScaleBits(ScaleBits),
      .PeriodLog2(PeriodLog2),
      .TimeBits(TimeBits),
      .Rates(Rates),
      .Shaper(Shaper)
  ) u_steps (
      .clk_i,
      .rst_ni,
      .scale_write_i,
      .scale_axis_i,
      .scale_i,
      .steplen_i,
      .stepspace_i,
      .dirsetup_i,
      .dirhold_i,
      .step_inverted_i,
      .direction_inverted_i,
      .sample_valid_i,
      .sample_ready_o,
      .sample_i,
      .begins_i,
      .reference_i,
      .by_axis_i,
      .axis_o,
      .position_i,
      .rates_read_o,
      .rates_i,
      .shaper_write_i,
      .shaper_i,
      .settled_o,
      .estop_i,
      .limit_i,
      .estop_o,
      .limit_o,
      .limit_masked_i,
      .stop_i,
      .step_o,
      .direction_o,
      .tick_o,
      .rise_o(rise),
      .back_o(back),
      .referenced_o,
      .uncertain_o,
      .overrun_o,
      .refused_o,
      .late_o
  );

  step_counters #(
      .Axes(Axes)
  ) u_counters (
      .clk_i,
      .rst_ni,
      .rise_i (rise),
      .back_i (back),
      .axis_i (steps_axis_i),
      .count_o(steps_o),
      .low_o  (step_counts_o)
  );

  galvo_pins #(
      .Galvo     (Galvo),
      .Axes      (Axes),
      .FineBits  (FineBits),
      .PeriodLog2(PeriodLog2)
  ) u_galvo (
      .clk_i,
      .rst_ni,
      .tick_i        (tick_o),
      .sample_taken_i(sample_valid_i && sample_ready_o),
      .sample_i,
      .by_axis_i,
      .axis_i        (axis_o),
      .position_i,
      .clock_o       (galvo_clock_o),
      .sync_o        (galvo_sync_o),
      .data_o        (galvo_data_o)
  );

endmodule
`default_nettype wire
