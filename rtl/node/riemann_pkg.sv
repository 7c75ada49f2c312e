// SPDX-License-Identifier: Apache-2.0
// The control of riemann_integrator: positions in the word, above the digits (digits_pkg).
package riemann_pkg;
  localparam int Close = 6;
  localparam int Advance = 7;
  localparam int Zeroth = 8;
  localparam int Collect = 9;
  localparam int First = 10;
  localparam int ExpansionBits = 11;  // up to here from the sequencer, to all integrators alike
  localparam int Load = 11;
  localparam int Bits = 12;
endpackage
