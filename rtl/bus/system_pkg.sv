// SPDX-License-Identifier: Apache-2.0
// Constants with the build of motion_system for the host: hls/registers/registers.rdl.
`default_nettype none
package system_pkg;

  function automatic int capability(input int axes, input int period_log2, input int build,
                                    input int splines, input int encoders, input int outputs);
    capability = (axes << registers_pkg::CapabilityAxesLow) +
        (period_log2 << registers_pkg::CapabilityPeriodLog2Low) +
        ((build & 1) << registers_pkg::CapabilityBuildLow) +
        ((build >> 1) << registers_pkg::CapabilityEngineLow) +
        (splines << registers_pkg::CapabilitySplinesLow) +
        ((encoders != 0 ? 1 : 0) << registers_pkg::CapabilityEncodersLow) +
        ($clog2(outputs) << registers_pkg::CapabilityOutputsLog2Low);
  endfunction

  // The rest of that register
  function automatic int memories(input int segment_words, input int profile_words,
                                  input int sample_words);
    memories = ($clog2(segment_words) << registers_pkg::CapabilitySegmentQueueLog2Low) +
        ($clog2(profile_words) << registers_pkg::CapabilityProfileQueueLog2Low) +
        ($clog2(sample_words) << registers_pkg::CapabilitySampleBufferLog2Low);
  endfunction

  function automatic int widths(input int time_bits, input int scale_bits, input int samples_ahead,
                                input int shaper);
    widths = (time_bits << registers_pkg::WidthsTimeBitsLow) +
        (scale_bits << registers_pkg::WidthsScaleBitsLow) +
        (samples_ahead << registers_pkg::WidthsSamplesAheadLow) +
        ($clog2(shaper) << registers_pkg::WidthsShaperLog2Low);
  endfunction

  function automatic logic [31:0] axes(input logic [8:0] referenced, input logic [8:0] uncertain,
                                       input logic [8:0] limit);
    axes = (32'(referenced) << registers_pkg::AxesReferencedLow) |
        (32'(uncertain) << registers_pkg::AxesUncertainLow) |
        (32'(limit) << registers_pkg::AxesLimitLow);
  endfunction

  function automatic int core(input int order, input int mode, input int coef_bits,
                              input int position_bits, input int guard_bits,
                              input int table_number);
    core = (order << registers_pkg::CoreOrderLow) + (mode << registers_pkg::CoreModeLow) +
        (coef_bits << registers_pkg::CoreCoefBitsLow) +
        (position_bits << registers_pkg::CorePositionBitsLow) +
        (guard_bits << registers_pkg::CoreGuardBitsLow) +
        (table_number << registers_pkg::CoreTableLow);
  endfunction

  // Adds the bytes of a word to a digest
  function automatic logic [15:0] digest_word(input logic [15:0] digest_before,
                                              input logic [31:0] word);
    logic [15:0] sum;
    sum = digest_before;
    for (int n = 0; n < 4; n = n + 1)
    sum = {sum[7:0], sum[15:8]} ^ {5'd0, sum[15:8], 3'd0} ^ {8'd0, word[8*n+:8]};
    digest_word = sum;
  endfunction

  // Returns the digest of words that are made for the board: hls/registers/board_facts.h
  function automatic logic [15:0] digest(input int capability_word, input int core_word,
                                         input int clock_hertz);
    int fields;
    int period;
    logic [15:0] sum;
    fields = capability_word & ((15 << registers_pkg::CapabilityAxesLow) |
                                (1 << registers_pkg::CapabilityBuildLow) |
                                (1 << registers_pkg::CapabilityEngineLow) |
                                (1 << registers_pkg::CapabilitySplinesLow));
    period = 1 << ((capability_word >> registers_pkg::CapabilityPeriodLog2Low) & 31);
    sum = digest_word(16'd0, 32'(fields));
    sum = digest_word(sum, 32'(core_word));
    sum = digest_word(sum, 32'(period));
    digest = digest_word(sum, 32'(clock_hertz));
  endfunction

endpackage
`default_nettype wire
