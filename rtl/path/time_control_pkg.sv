// SPDX-License-Identifier: Apache-2.0
// Words of the program of rtl/path/time_program.sv.
`default_nettype none
package time_control_pkg;

  // For rtl/path/time_datapath.sv
  localparam int Read = 0;  // 3 bits: the operand
  localparam int OfPorts = 3;  // it is a port: acceleration, slope, goal, change
  localparam int Write = 4;  // 3 bits: place where the sum is written
  localparam int Store = 7;  // the sum is written
  localparam int Clear = 8;  // clears the sum
  localparam int Add = 9;  // adds the operand to it
  localparam int Minus = 10;  // subtracts it
  localparam int Bits = 11;

  // For rtl/path/time_sequencer.sv
  localparam int Target = 11;  // 6 bits: target of the jump
  localparam int Condition = 17;  // 4 bits: its condition
  localparam int Stay = 21;  // otherwise the word is obeyed again
  localparam int Turned = 22;  // subtracts it if the rate is falling
  localparam int Ready = 23;  // ready for a tick
  localparam int Send = 24;  // sends the sum as the rate
  localparam int Turn = 25;  // turns to falling, or to rising again; with Swap: to rising
  localparam int Moves = 26;  // the sum is the slope
  localparam int Settles = 27;  // the rate settles unless the sum is 0
  localparam int Settled = 28;
  localparam int Swap = 29;  // changes to the side of the target
  localparam int Coarse = 30;  // changes to the side below 7/8
  localparam int Border = 31;  // the goal is 7/8
  localparam int Rests = 32;  // the sum is the way left
  localparam int WordBits = 33;

  // Conditions
  localparam logic [3:0] Never = 4'd0;
  localparam logic [3:0] Always = 4'd1;
  localparam logic [3:0] NoTick = 4'd2;
  localparam logic [3:0] Stops = 4'd3;
  localparam logic [3:0] Follows = 4'd4;
  localparam logic [3:0] Moving = 4'd5;
  localparam logic [3:0] Positive = 4'd6;
  localparam logic [3:0] Settling = 4'd7;
  localparam logic [3:0] NoSwap = 4'd8;
  localparam logic [3:0] Negative = 4'd9;
  localparam logic [3:0] GoesOn = 4'd10;
  localparam logic [3:0] NotTaken = 4'd11;

endpackage
`default_nettype wire
