// SPDX-License-Identifier: Apache-2.0
// The words that rtl/path/path_sequencer.sv sends to rtl/path/path_datapath.sv, one a clock.
`default_nettype none
package path_control_pkg;

  localparam int Bits = 18;

  localparam int Read = 0;  // 4 bits: the operand; from 8 on of the present piece
  localparam int Write = 4;  // 4 bits: what is written
  localparam int Store = 8;  // it is: the sum,
  localparam int OfRate = 9;  // the rate in place of its low bits, the sum being 0
  localparam int OfTicks = 10;  // the ticks of the next piece, the same
  localparam int Clear = 11;  // the sum
  localparam int Add = 12;  // the operand to it
  localparam int Minus = 13;  // subtract it
  localparam int Halve = 14;  // what Add gives
  localparam int Multiply = 15;  // add it only if the factor's next bit is 1; operand 2, no other
  localparam int Round = 16;  // add the bit that Halve dropped in the clock before
  localparam int Load = 17;  // the sum is the factor

endpackage
`default_nettype wire
