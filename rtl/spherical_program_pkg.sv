// SPDX-License-Identifier: Apache-2.0
// Where the parts of the serial build's program begin, made by
// rtl/serial/program_generator.cpp: do not edit.
package spherical_program_pkg;
  localparam logic [6:0] WeightsEntry = 7'd0;
  localparam logic [6:0] AngleEntry = 7'd11;
  localparam logic [6:0] ExpandEntry = 7'd40;
  localparam logic [6:0] StepEntry = 7'd69;
  localparam logic [6:0] SeriesEntry = 7'd87;
  localparam logic [6:0] PolynomialEntry = 7'd102;
endpackage
