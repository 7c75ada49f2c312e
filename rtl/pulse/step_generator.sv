// SPDX-License-Identifier: Apache-2.0
// Steps from samples: an axis steps when its place, between two samples, is half-way between two
// whole steps.
//
//   samples -> place_scaler -> rates -> input_shaper -> step_axis -> step, direction, of each axis
//                 ^ scales       ^ sample_period
//
// A sample is wanted every 2^PeriodLog2 clocks. Between two samples the place is a straight line in
// time, rounded to 2^-16 step at its ends only. So the pins follow positions, not speeds: their
// count always equals the place, and no error adds up.
//
//   clock               0     Axes (FineBits + 6)
//   sample_valid_i      1     1
//   sample_ready_o            1                      at the earliest: when no rates wait
//
//   clock               0     a + 3          a + 6 + n
//   tick_o              1
//   axis a                    takes its rate
//   step_o                                   rises
//
// n, from 1 to 2^PeriodLog2, is the first clock of the period at whose end the place has crossed:
// one latency, and one clock more for each axis, unless the drive's times delay the step. These
// times, waiting steps and overruns: rtl/pulse/step_pulse.sv.
//
// reference_i: the axis stands at the next sample; before that it gives no steps. estop_i (all
// axes) and limit_i (each) are external: two clocks of a synchroniser and one more, and the step
// pin is low; with stop_i one clock. The axis then needs a reference, and so it does after a
// refused rate: half a step per clock or more, or a program that begins a step or more from where
// the axis stands.
//
// With Rates = 1 there are no samples here, but rates from outside (rtl/engine/engine_rates.sv),
// which count if the axis is referenced when they are loaded. With a shaper rates are taken
// 26 Axes + 1 clocks later, and axes go where it says; settled_o: they stand at their places.
//
// The flags of an axis stay until its next reference. late_o, for one clock: a sample was late
// while the axes were moving; stopped axes do not count.
`default_nettype none
module step_generator #(
    parameter int Axes       = 3,   // [1, 9]
    parameter int FineBits   = 42,  // [18, 44] bits of a position
    parameter int ScaleBits  = 44,  // [40, 56]
    parameter int PeriodLog2 = 13,  // [6, 20]
    parameter int TimeBits   = 12,  // [4, 16]
    parameter int Rates      = 0,   // 1: instead of samples
    parameter int Shaper     = 0    // 0: none; places that rtl/pulse/input_shaper.sv keeps
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Scales: 2^-16 steps in 2^FineBits units of a position; axis and scale stay for a clock more
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
    input  wire logic                     begins_i,        // a program's first sample
    input  wire logic [         Axes-1:0] reference_i,

    // Positions axis by axis: rtl/pulse/place_scaler.sv
    input  wire logic                by_axis_i,
    output logic      [         3:0] axis_o,
    input  wire logic [FineBits-1:0] position_i,

    // Rates: rtl/bus/paced_motion.sv
    output logic      [                                   4:0] rates_read_o,
    input  wire logic [pulse_pkg::StepFraction+PeriodLog2+3:0] rates_i,

    // Words of the shaper: rtl/pulse/input_shaper.sv
    input  wire logic        shaper_write_i,
    input  wire logic [23:0] shaper_i,        // {kind, axis, value}
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

    // Events
    output logic            tick_o,
    output logic [Axes-1:0] rise_o,        // the pulse begins after this clock
    output logic [Axes-1:0] back_o,        // its direction
    output logic [Axes-1:0] referenced_o,
    output logic [Axes-1:0] uncertain_o,   // a pulse was cut: by one step
    output logic [Axes-1:0] overrun_o,     // a step was dropped
    output logic [Axes-1:0] refused_o,     // too fast
    output logic            late_o
);

  initial if (Axes < 1 || Axes > 9) $fatal(1, "Axes must be in [1, 9]");
  initial if (FineBits < 18 || FineBits > 44) $fatal(1, "FineBits must be in [18, 44]");
  initial if (ScaleBits < 40 || ScaleBits > 56) $fatal(1, "ScaleBits must be in [40, 56]");
  initial if (PeriodLog2 < 6 || PeriodLog2 > 20) $fatal(1, "PeriodLog2 must be in [6, 20]");
  initial if (TimeBits < 4 || TimeBits > 16) $fatal(1, "TimeBits must be in [4, 16]");
  // Scaling, and loading before it.
  initial
    if (Rates == 0 && Axes * (FineBits + 7) + 4 > 2 ** PeriodLog2)
      $fatal(1, "Axes (FineBits + 7) + 4 clocks must fit in a period");

  // A sample is scaled when axes know that they are referenced by the one before.
  initial
    if (Shaper != 0 && Rates == 0 && FineBits < 24)
      $fatal(1, "FineBits must be at least 24 with a shaper");

  localparam int RateBits = pulse_pkg::StepFraction + PeriodLog2;

  logic late;
  logic rates_valid;
  logic taken;
  logic read;
  logic [3:0] read_axis;
  logic [RateBits-1:0] rate;
  logic moves;
  logic fresh;
  logic refused;
  logic [Axes-1:0] load;
  logic none;
  always_ff @(posedge clk_i) late_o <= rst_ni && late && referenced_o != '0;
  assign rates_read_o = {taken, read_axis};
  if (Rates == 1) begin : g_rates
    logic counts;
    logic refused_now;
    logic moves_now;
    logic unused;
    assign counts = (load & referenced_o) != '0;
    assign {rates_valid, refused_now, fresh, moves_now, rate} = rates_i;
    assign refused = refused_now && counts;
    assign moves = moves_now && counts;
    assign sample_ready_o = 1'b0;
    assign axis_o = '0;
    assign unused = &{1'b0, read, scale_write_i, scale_axis_i, scale_i, sample_valid_i, sample_i,
                      begins_i, reference_i, by_axis_i, position_i};
  end else begin : g_samples
    logic [Axes-1:0] fresh_q;  // to be referenced by the next sample
    logic [Axes-1:0] fresh_taken;
    logic unused;
    assign unused = &{1'b0, rates_i};
    always_ff @(posedge clk_i) begin
      if (!rst_ni) fresh_q <= '0;
      else fresh_q <= (fresh_q & ~fresh_taken) | reference_i;
    end
    place_scaler #(
        .Axes     (Axes),
        .FineBits (FineBits),
        .ScaleBits(ScaleBits),
        .RateBits (RateBits)
    ) u_scaler (
        .clk_i,
        .rst_ni,
        .scale_write_i,
        .scale_axis_i,
        .scale_i,
        .sample_valid_i,
        .sample_ready_o,
        .sample_i,
        .by_axis_i,
        .axis_o,
        .position_i,
        .begins_i,
        .fresh_i(fresh_q),
        .referenced_i(referenced_o),
        .fresh_taken_o(fresh_taken),
        .rates_valid_o(rates_valid),
        .rates_taken_i(taken),
        .read_i(read),
        .read_axis_i(read_axis),
        .rate_o(rate),
        .moves_o(moves),
        .fresh_o(fresh),
        .refused_o(refused)
    );
  end

  sample_period #(
      .Axes      (Axes),
      .PeriodLog2(PeriodLog2)
  ) u_period (
      .clk_i,
      .rst_ni,
      .valid_i(rates_valid),
      .moves_i(moves),
      .read_o(read),
      .read_axis_o(read_axis),
      .taken_o(taken),
      .tick_o,
      .late_o(late),
      .load_o(load),
      .none_o(none)
  );

  synchroniser #(
      .Bits(Axes + 1)
  ) u_synchroniser (
      .clk_i,
      .rst_ni,
      .input_i ({estop_i, limit_i}),
      .output_o({estop_o, limit_o})
  );

  logic [TimeBits-1:0] length;
  logic [TimeBits-1:0] setup;
  logic [TimeBits-1:0] again;
  logic [TimeBits-1:0] turn;
  logic length_1;
  logic setup_1;
  pulse_times #(
      .TimeBits(TimeBits)
  ) u_times (
      .clk_i,
      .steplen_i,
      .stepspace_i,
      .dirsetup_i,
      .dirhold_i,
      .length_o(length),
      .setup_o(setup),
      .again_o(again),
      .turn_o(turn),
      .length_1_o(length_1),
      .setup_1_o(setup_1)
  );

  logic [Axes-1:0] shaped_load;
  logic shaped_none, shaped_fresh, shaped_moves, shaped_refused;
  logic [RateBits-1:0] shaped_rate;
  if (Shaper != 0) begin : g_shaper
    assign shaped_none = 1'b0;
    input_shaper #(
        .Axes      (Axes),
        .PeriodLog2(PeriodLog2),
        .Places    (Shaper)
    ) u_shaper (
        .clk_i,
        .rst_ni,
        .off_i(stop_i),
        .write_i(shaper_write_i),
        .kind_i(shaper_i[registers_pkg::ShaperKindLow+:2]),
        .axis_i(shaper_i[registers_pkg::ShaperAxisLow+:4]),
        .value_i(shaper_i[registers_pkg::ShaperValueLow+:18]),
        .load_i(load),
        .none_i(none),
        .fresh_i(fresh),
        .moves_i(moves),
        .refused_i(refused),
        .rate_i(rate),
        .referenced_i(referenced_o),
        .load_o(shaped_load),
        .fresh_o(shaped_fresh),
        .moves_o(shaped_moves),
        .refused_o(shaped_refused),
        .rate_o(shaped_rate),
        .settled_o
    );
  end else begin : g_no_shaper
    logic unused;
    assign unused = &{1'b0, shaper_write_i, shaper_i};
    assign settled_o = 1'b1;
    assign {shaped_load, shaped_none, shaped_fresh} = {load, none, fresh};
    assign {shaped_moves, shaped_refused, shaped_rate} = {moves, refused, rate};
  end

  logic [Axes-1:0] step;
  assign step_o = step ^ step_inverted_i;
  assign direction_o = back_o ^ direction_inverted_i;
  for (genvar a = 0; a < Axes; a++) begin : gen_axes
    step_axis #(
        .RateBits(RateBits),
        .TimeBits(TimeBits)
    ) u_axis (
        .clk_i,
        .rst_ni,
        .length_i(length),
        .setup_i(setup),
        .again_i(again),
        .turn_i(turn),
        .length_1_i(length_1),
        .setup_1_i(setup_1),
        .load_i(shaped_load[a]),
        .none_i(shaped_none),
        .fresh_i(shaped_fresh),
        .moves_i(shaped_moves),
        .rate_i(shaped_rate),
        .stop_i(estop_o || stop_i || (limit_o[a] && !limit_masked_i[a])),
        .refused_i(shaped_refused),
        .step_o(step[a]),
        .direction_o(back_o[a]),
        .rise_o(rise_o[a]),
        .referenced_o(referenced_o[a]),
        .refused_o(refused_o[a]),
        .overrun_o(overrun_o[a]),
        .uncertain_o(uncertain_o[a])
    );
  end

endmodule
`default_nettype wire
