// SPDX-License-Identifier: Apache-2.0
// The control word of a node of the spline network: positions of its fields.
package series_pkg;
  localparam int Again = 0;  // x[0] = the sum of the step before
  localparam int Load = 1;  // x[0] = initial_i
  localparam int ZerothBits = 2;
  localparam int Order = 2;  // four bits
  localparam int Start = 6;
  localparam int Bits = 7;
endpackage
