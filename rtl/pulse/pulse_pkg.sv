// SPDX-License-Identifier: Apache-2.0
// Words of the step generator. Twins: hls/step_axis.hpp, hls/step_generator.hpp.
`default_nettype none
package pulse_pkg;

  localparam int StepFraction = 16;  // fraction bits of a place, in steps

endpackage
`default_nettype wire
