// SPDX-License-Identifier: Apache-2.0
// Words of the spline network: positions of their fields.
package spline_pkg;
  // Initial conditions, from spline_anchor, one after the other X Y Z
  localparam int SixA = 0;
  localparam int V = 3;
  localparam int W = 6;
  localparam int Phi = 9;
  localparam int Q = 10;
  localparam int R = 11;
  localparam int Again = 12;  // all but 6a' continue from the step before
  localparam int LoadBits = 13;

  // Orders, from spline_sequencer
  localparam int Order = 0;  // four bits
  localparam int StartV = 4;
  localparam int StartX = 5;
  localparam int StartP = 6;
  localparam int StartPhi = 7;
  localparam int ControlBits = 8;
endpackage
