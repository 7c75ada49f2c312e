// SPDX-License-Identifier: Apache-2.0
// Words to the spline network: positions.
package spline_pkg;
  // Initial conditions, from spline_anchor: whose the word is, one after the other X Y Z
  localparam int SixA = 0;
  localparam int V = 3;
  localparam int W = 6;
  localparam int Phi = 9;
  localparam int Q = 10;
  localparam int R = 11;
  localparam int Again = 12;  // all but 6a' go on from the step before
  localparam int LoadBits = 13;

  // Orders, from spline_sequencer
  localparam int Order = 0;  // four bits
  localparam int StartV = 4;
  localparam int StartX = 5;
  localparam int StartP = 6;
  localparam int StartPhi = 7;
  localparam int ControlBits = 8;
endpackage
