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

  // Widths of the pass of order `i` in an arc's series whose steps turn by at most 2^-turn rad,
  // turn >= 1; turn = 0: all orders alike.  Twin: ref/format/order_words.hpp, with the reason.
  function automatic int factorial_bits(input int i);  // ceil(log2 i!)
    case (i)
      2: factorial_bits = 1;
      3: factorial_bits = 3;
      4: factorial_bits = 5;
      5: factorial_bits = 7;
      6: factorial_bits = 10;
      7: factorial_bits = 13;
      8: factorial_bits = 16;
      9: factorial_bits = 19;
      10: factorial_bits = 22;
      11: factorial_bits = 26;
      12: factorial_bits = 29;
      default: factorial_bits = 0;
    endcase
  endfunction
  function automatic int sign_copies(input int turn, input int i);
    sign_copies = (turn > 0 && i > 1) ? turn * (i - 1) + factorial_bits(i) : 0;
  endfunction
  function automatic int sum_bits(input int coef_bits, input int turn, input int i);
    sum_bits = coef_bits - sign_copies(turn, i);
    if (turn > 0 && sum_bits < 18) sum_bits = 18;
  endfunction
  function automatic int tau_bits(input int coef_bits, input int turn, input int i);
    tau_bits = coef_bits;
    if (turn > 0 && i > 1) tau_bits = coef_bits - sign_copies(turn, i) + 1;
    if (turn > 0 && tau_bits < 18) tau_bits = 18;
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
