// SPDX-License-Identifier: Apache-2.0
// Constants that several modules share.  Twin of the formats: hls/configuration.hpp.
package curvecore_pkg;
  // Clocks from a multiplier's operands to its product (rtl/multiplier/multiplier.sv).
  localparam int MultiplierLatency = 5;

  // Formats that no parameter changes.
  localparam int BusBits = 48;  // a word of the segment and profile streams
  localparam int PathFrac = 16;  // a path quantum is 2^-16 length unit
  localparam int MaxStepExponent = 27;  // an integration step is 2^k length units, k in [0, 27]
  localparam int StepBits = MaxStepExponent + PathFrac + 1;  // a step's length in quanta

  // Digits of two bits of a weight with `bits` - 1 fraction bits (arithmetic/digit_multiplier.sv).
  function automatic int weight_digits(input int bits);
    weight_digits = (bits + 1) / 2;
  endfunction

  // Enabled clocks of an evaluation (rtl/arithmetic/horner.sv).  Twin: hls/clocks.hpp.
  function automatic int horner_loop(input int interval);
    case (interval)
      1: horner_loop = MultiplierLatency + 1;
      2: horner_loop = MultiplierLatency + 2;
      default: horner_loop = MultiplierLatency + 4;
    endcase
  endfunction
  function automatic int horner_latency(input int passes, input int interval);
    horner_latency = passes * horner_loop(interval);
    if (interval == 1) horner_latency = horner_latency + 1;
  endfunction

  // Clocks from tau to a displacement (rtl/sampler/curve_sampler.sv).
  function automatic int sampler_latency(input int curves, input int mode, input int order,
                                         input int interval);
    if (mode == 0) sampler_latency = horner_latency(order, interval);
    else if (curves == 1)
      sampler_latency = horner_latency(order / 2, interval) + ((interval == 2) ? 19 : 18);
    else sampler_latency = horner_latency(order, interval) + horner_latency(3, interval);
    if (mode == 1 && curves == 3) sampler_latency = sampler_latency + 1;
  endfunction

  // round(2^frac / i), frac <= 35: the constants of Riemann's weights.
  function automatic logic [35:0] reciprocal(input int frac, input int i);
    logic [63:0] quotient;
    quotient   = (64'd1 << (frac + 1)) / 64'(i);
    quotient   = quotient + 64'd1;
    reciprocal = quotient[36:1];
  endfunction
endpackage
