// SPDX-License-Identifier: Apache-2.0
// Positions along splines at constant path speed, one per request: [Chikurov] Fig. 10.
// Twin: hls/interpolator_kernel.hpp with hls/curves/spline.hpp, bit for bit.
//
//   segment words -> starter -> anchor -> network (steps ahead) -> banks -> sampler -> lander ->
//   requests -------> step tracker -> offset ---------------------------------^         samples
//
// A request moves `ds` quanta (2^-16 length unit) along the path and yields the sample there, in
// order.  It waits until its step is ready.
//
//   clocks                            value
//   between samples                   SampleInterval
//   request to sample                 12 + 3 SampleInterval + that of spline_sampler, and up to
//                                     SampleInterval - 1 more; Axes more where SampleInterval is as
//                                     large
//   of an integration step            94 + those of spline_sequencer; with Networks 0 other ones
//                                     (hls/clocks.hpp)
//   to load a segment                 19 + 3 AuxAxes, while the one before is drawn
//
// Samples come at full rate as long as every step holds the samples of the larger of the last two.
// ParameterGuard: fraction bits below the words' in which the spline's parameter adds up from step
// to step (hls/curves/spline.hpp); the planner must know them.
// Segments of other kinds are not for this core.
// Formats: hls/words.hpp.
`default_nettype none
module spline_interpolator #(
    parameter int Order          = 6,   // [2, 12]
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int PositionBits   = 32,  // [16, 32]
    parameter int GuardBits      = 10,  // [2, 12]
    parameter int AuxAxes        = 0,   // [0, 6]
    parameter int Mode           = 1,   // 0 series, 1 polynomial
    parameter int Anchor         = 1,   // 0, 1
    parameter int ParameterGuard = 0,   // [0, 8]
    parameter int SampleInterval = 1,   // 1, 2, 4, 8 clocks
    parameter int Networks       = 1,   // 1 steps by the networks, 0 by their program
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Segments, 17 + 3 AuxAxes words each
    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic [47:0] segment_data_i,

    // Path increments
    input  wire logic        request_valid_i,
    output logic             request_ready_o,
    input  wire logic [47:0] request_ds_i,

    // Samples, axis 0 in the low bits
    output logic                                                 sample_valid_o,
    input  wire logic                                            sample_ready_i,
    output logic      [            (3+AuxAxes)*PositionBits-1:0] sample_position_o,
    output logic      [(3+AuxAxes)*(PositionBits+GuardBits)-1:0] sample_fine_o,

    output logic [15:0] empty_segments_o
);

  curve_interpolator #(
      .Curves(2),
      .Order(Order),
      .CoefBits(CoefBits),
      .PositionBits(PositionBits),
      .GuardBits(GuardBits),
      .AuxAxes(AuxAxes),
      .Mode(Mode),
      .Anchor(Anchor),
      .ParameterGuard(ParameterGuard),
      .SampleInterval(SampleInterval),
      .Networks(Networks),
      .MultiplierForm(MultiplierForm)
  ) u_curves (
      .clk_i,
      .rst_ni,
      .segment_valid_i,
      .segment_ready_o,
      .segment_data_i,
      .request_valid_i,
      .request_ready_o,
      .request_ds_i,
      .sample_valid_o,
      .sample_ready_i,
      .sample_position_o,
      .sample_fine_o,
      .empty_segments_o
  );

endmodule
`default_nettype wire
