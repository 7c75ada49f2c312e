// SPDX-License-Identifier: Apache-2.0
// Words of the program of rtl/path/path_program.sv.
`default_nettype none
package path_control_pkg;

  // For rtl/path/path_datapath.sv
  localparam int Read = 0;  // 4 bits: the operand; in the present piece 8 is a coefficient, 11 ds
  localparam int Write = 4;  // 4 bits: the word to write
  localparam int Store = 8;  // the word written is the sum,
  localparam int OfRate = 9;  // puts the rate in place of its low bits, the sum being 0
  localparam int OfTicks = 10;  // puts the ticks of the next piece, likewise
  localparam int Clear = 11;  // clears the sum
  localparam int Add = 12;  // adds the operand to it
  localparam int Invert = 13;  // inverts the bits of Add's result
  localparam int Halve = 14;  // halves Add's result
  localparam int Multiply = 15;  // moves to the factor's next bit
  localparam int Round = 16;  // adds the bit that Halve dropped in the clock before
  localparam int Load = 17;  // makes the sum the factor
  localparam int Choose = 18;  // reads 2 if the factor's next bit is 1; with Read 0 only
  localparam int Bits = 19;

  // For rtl/path/path_sequencer.sv
  localparam int Target = 19;  // 6 bits: target of the jump
  localparam int Condition = 25;  // 4 bits: its condition
  localparam int Stay = 29;  // otherwise the word is obeyed again
  localparam int Ready = 30;  // ready for a tick
  localparam int Take = 31;  // takes the next piece
  localparam int Send = 32;  // sends the sum as an increment
  localparam int Next = 33;  // next coefficient
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
