// SPDX-License-Identifier: Apache-2.0
// Made by rtl/queue/words_generator.cpp from hls/words.hpp, which explains the fields.
`default_nettype none
package words_pkg;

  localparam logic [3:0] TagLength = 4'd1;
  localparam logic [3:0] TagTheta = 4'd2;
  localparam logic [3:0] TagStart = 4'd3;
  localparam logic [3:0] TagEnd = 4'd4;
  localparam logic [3:0] TagTangent = 4'd5;
  localparam logic [3:0] TagNormal = 4'd6;
  localparam logic [3:0] TagAdvance = 4'd7;
  localparam logic [3:0] TagPiece = 4'd8;
  localparam logic [3:0] TagDs = 4'd9;
  localparam logic [3:0] TagC1 = 4'd10;
  localparam logic [3:0] TagC2 = 4'd11;
  localparam logic [3:0] TagC3 = 4'd12;

  // Lowest bits
  localparam int TagLow = 44;
  localparam int KindLow = 36;
  localparam int StepExponentLow = 38;
  localparam int LastLow = 43;
  localparam int SequenceLow = 36;
  localparam int LambdaLow = 36;
  localparam int TicksByteLow = 36;
  localparam int PieceTicksLow = 0;
  localparam int TimeExponentLow = 20;
  localparam int ExponentLow = 25;
  localparam int FinalLow = 31;
  localparam int PieceSequenceLow = 32;

endpackage
`default_nettype wire
