// SPDX-License-Identifier: Apache-2.0
// Words of the program of rtl/path/path_program.sv.
`default_nettype none
package path_control_pkg;

  // For rtl/path/path_datapath.sv
  localparam int Read = 0;  // 4 bits: the operand; of the present piece: 8 a coefficient, 11 ds
  localparam int Write = 4;  // 4 bits: what is written
  localparam int Store = 8;  // it is: the sum,
  localparam int OfRate = 9;  // the rate in place of its low bits, the sum being 0
  localparam int OfTicks = 10;  // the ticks of the next piece, the same
  localparam int Clear = 11;  // the sum
  localparam int Add = 12;  // the operand to it
  localparam int Invert = 13;  // the bits of what Add gives
  localparam int Halve = 14;  // what Add gives
  localparam int Multiply = 15;  // to the factor's next bit
  localparam int Round = 16;  // add the bit that Halve dropped in the clock before
  localparam int Load = 17;  // the sum is the factor
  localparam int Choose = 18;  // read 2, if the factor's next bit is 1; with Read 0 only
  localparam int Bits = 19;

  // For rtl/path/path_sequencer.sv
  localparam int Target = 19;  // 6 bits: where it jumps to
  localparam int Condition = 25;  // 4 bits: if
  localparam int Stay = 29;  // or else: to be obeyed again
  localparam int Ready = 30;  // for a tick
  localparam int Take = 31;  // the next piece
  localparam int Send = 32;  // the sum is an increment
  localparam int Next = 33;  // coefficient
  localparam int WordBits = 34;

  // Conditions
  localparam logic [3:0] Never = 4'd0;
  localparam logic [3:0] Always = 4'd1;
  localparam logic [3:0] NoRate = 4'd2;
  localparam logic [3:0] Runs = 4'd3;
  localparam logic [3:0] Stops = 4'd4;
  localparam logic [3:0] NotLoaded = 4'd5;
  localparam logic [3:0] NotActive = 4'd6;
  localparam logic [3:0] WasNotActive = 4'd7;
  localparam logic [3:0] MoreBits = 4'd8;
  localparam logic [3:0] LastPass = 4'd9;
  localparam logic [3:0] IsAbove = 4'd10;
  localparam logic [3:0] IsExact = 4'd11;
  localparam logic [3:0] MoreHalves = 4'd12;
  localparam logic [3:0] MoreDoubles = 4'd13;
  localparam logic [3:0] Negative = 4'd14;
  localparam logic [3:0] NotSent = 4'd15;

endpackage
`default_nettype wire
