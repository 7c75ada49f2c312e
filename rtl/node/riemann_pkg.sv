// SPDX-License-Identifier: Apache-2.0
// The control word of riemann_integrator: positions above the digits (digits_pkg).
package riemann_pkg;
  localparam int Close = 6;
  localparam int Advance = 7;
  localparam int Zeroth = 8;
  localparam int Collect = 9;
  localparam int First = 10;
  localparam int ExpansionBits = 11;  // lower bits come from the sequencer, the same to all
  localparam int Load = 11;
  localparam int Bits = 12;
endpackage
