// SPDX-License-Identifier: Apache-2.0
// Words of scaler: positions of their fields.
package scaler_pkg;
  // The digits of a term, above those of digits_pkg
  localparam int Done = 6;
  localparam int Negative = 7;
  localparam int Order = 8;  // four bits
  localparam int DigitsBits = 12;

  // Initial conditions, above series_state's (series_pkg)
  localparam int Gain = 2;
  localparam int LoadBits = 3;
endpackage
