// SPDX-License-Identifier: Apache-2.0
// Places of the parts of the serial build's program, made by
// rtl/serial/program_generator.cpp: do not edit.
package serial_program_pkg;
  localparam logic [7:0] WeightsEntry = 8'd0;
  localparam logic [7:0] AngleEntry = 8'd11;
  localparam logic [7:0] ExpandEntry = 8'd40;
  localparam logic [7:0] StepEntry = 8'd69;
  localparam logic [7:0] SeriesEntry = 8'd87;
  localparam logic [7:0] PolynomialEntry = 8'd102;
  localparam logic [7:0] SplineLoadEntry = 8'd128;
  localparam logic [7:0] SplineStepEntry = 8'd148;
  localparam logic [7:0] SplineExpandEntry = 8'd158;
  localparam logic [7:0] SplineSeriesEntry = 8'd218;
  localparam logic [7:0] SplinePolynomialEntry = 8'd227;
  localparam logic [7:0] SplineKeepEntry = 8'd251;
endpackage
