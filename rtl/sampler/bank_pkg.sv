// SPDX-License-Identifier: Apache-2.0
// Words that a network writes into a bank of a sampler: `write` and beside it `words`, a word per
// lane.
package bank_pkg;
  // Lanes
  localparam int X = 0;  // X Y Z: a series or a cubic, a normal
  localparam int Own = 3;  // the step's own series: of the angle, of the spline's parameter
  localparam int F = 4;  // F G H: a tangent
  localparam int Lanes = 7;

  // Positions in `write`
  localparam int Bank = 0;  // two bits
  localparam int Place = 2;  // four bits: the order or power of X Y Z
  localparam int OwnPlace = 6;  // four bits: the order of the own series
  localparam int Lane = 10;  // a bit for each written lane
  localparam int Bits = 17;
endpackage
