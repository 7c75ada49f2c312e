// SPDX-License-Identifier: Apache-2.0
// The words that rtl/path/time_sequencer.sv sends to rtl/path/time_datapath.sv, one a clock.
`default_nettype none
package time_control_pkg;

  localparam int Bits = 11;

  localparam int Read = 0;  // 3 bits: the operand
  localparam int OfPorts = 3;  // from a port: acceleration, slope, goal, change
  localparam int Write = 4;  // 3 bits: where the sum is written
  localparam int Store = 7;  // it is
  localparam int Clear = 8;  // the sum
  localparam int Add = 9;  // the operand to it
  localparam int Minus = 10;  // subtract it

endpackage
`default_nettype wire
