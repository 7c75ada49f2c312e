// SPDX-License-Identifier: Apache-2.0
// A weight's digits on their way to digit_multiplier: positions in the word.
package digits_pkg;
  localparam int Digit = 0;  // two bits
  localparam int Last = 2;
  localparam int Step = 3;
  localparam int Triple = 4;
  localparam int Take = 5;
  localparam int Bits = 6;
endpackage
