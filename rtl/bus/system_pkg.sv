// SPDX-License-Identifier: Apache-2.0
// Constants that tell a host how motion_system is built: hls/registers/registers.rdl.
`default_nettype none
package system_pkg;

  function automatic int capability(input int axes, input int period_log2, input int build,
                                    input int splines, input int segment_queue_words,
                                    input int profile_queue_words, input int sample_buffer_words,
                                    input int encoders);
    capability = (axes << registers_pkg::CapabilityAxesLow) +
        (period_log2 << registers_pkg::CapabilityPeriodLog2Low) +
        (build << registers_pkg::CapabilityBuildLow) +
        (splines << registers_pkg::CapabilitySplinesLow) +
        ($clog2(segment_queue_words) << registers_pkg::CapabilitySegmentQueueLog2Low) +
        ($clog2(profile_queue_words) << registers_pkg::CapabilityProfileQueueLog2Low) +
        ($clog2(sample_buffer_words) << registers_pkg::CapabilitySampleBufferLog2Low) +
        ((encoders != 0 ? 1 : 0) << registers_pkg::CapabilityEncodersLow);
  endfunction

  function automatic int widths(input int time_bits, input int scale_bits, input int samples_ahead);
    widths = (time_bits << registers_pkg::WidthsTimeBitsLow) +
        (scale_bits << registers_pkg::WidthsScaleBitsLow) +
        (samples_ahead << registers_pkg::WidthsSamplesAheadLow);
  endfunction

  function automatic int core(input int order, input int mode, input int coef_bits,
                              input int position_bits, input int guard_bits);
    core = (order << registers_pkg::CoreOrderLow) + (mode << registers_pkg::CoreModeLow) +
        (coef_bits << registers_pkg::CoreCoefBitsLow) +
        (position_bits << registers_pkg::CorePositionBitsLow) +
        (guard_bits << registers_pkg::CoreGuardBitsLow);
  endfunction

endpackage
`default_nettype wire
