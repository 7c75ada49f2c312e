// SPDX-License-Identifier: Apache-2.0
// Made by rtl/queue/words_generator.cpp from hls/words.hpp, which explains the fields.
`default_nettype none
package words_pkg;

  localparam int Version = 6;

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
  localparam logic [3:0] TagStop = 4'd13;
  localparam logic [3:0] TagStep = 4'd14;
  localparam logic [3:0] TagOutput = 4'd15;

  // Lowest bits, and how many
  localparam int TagLow = 44;
  localparam int TagBits = 4;
  localparam int PathLengthLow = 0;
  localparam int PathLengthBits = 44;
  localparam int PointLow = 0;
  localparam int PointBits = 44;
  localparam int CoefLow = 0;
  localparam int CoefBits = 36;
  localparam int KindLow = 36;
  localparam int KindBits = 2;
  localparam int StepExponentLow = 38;
  localparam int StepExponentBits = 5;
  localparam int LastLow = 43;
  localparam int LastBits = 1;
  localparam int SequenceLow = 36;
  localparam int SequenceBits = 8;
  localparam int CheckLow = 36;
  localparam int CheckBits = 8;
  localparam int LambdaLow = 36;
  localparam int LambdaBits = 6;
  localparam int OtherTurnLow = 42;
  localparam int OtherTurnBits = 1;
  localparam int TicksByteLow = 36;
  localparam int TicksByteBits = 8;
  localparam int PieceTicksLow = 0;
  localparam int PieceTicksBits = 20;
  localparam int TimeExponentLow = 20;
  localparam int TimeExponentBits = 5;
  localparam int ExponentLow = 25;
  localparam int ExponentBits = 6;
  localparam int FinalLow = 31;
  localparam int FinalBits = 1;
  localparam int StopWaitLow = 0;
  localparam int StopWaitBits = 20;
  localparam int StopAgainLow = 20;
  localparam int StopAgainBits = 1;
  localparam int StepTicksLow = 0;
  localparam int StepTicksBits = 11;
  localparam int StepChangeLow = 11;
  localparam int StepChangeBits = 32;
  localparam int StepLastLow = 43;
  localparam int StepLastBits = 1;
  localparam int OutputDistanceLow = 0;
  localparam int OutputDistanceBits = 26;
  localparam int OutputValueLow = 26;
  localparam int OutputValueBits = 12;
  localparam int OutputKindLow = 38;
  localparam int OutputKindBits = 2;
  localparam int OutputNumberLow = 40;
  localparam int OutputNumberBits = 4;

  // Largest values
  localparam logic [4:0] MostStepExponent = 5'd27;
  localparam logic [5:0] MostLambda = 6'd27;
  localparam logic [4:0] MostTimeExponent = 5'd19;
  localparam logic [5:0] MostExponent = 6'd46;

  // Words of a frame; of a segment without auxiliary axes, and what each adds
  localparam int SegmentWords = 17;
  localparam int AxisWords = 3;
  localparam int PieceWords = 5;

  // Sizes of stop branches: hls/stop_schedule.hpp
  localparam int StopLead = 32;
  localparam int StopSteps = 256;
  localparam int BranchRate = 36864;  // 16 fraction bits

  // Kinds of changes of outputs: hls/path_outputs.hpp
  localparam logic [1:0] OutputBits = 2'd0;
  localparam logic [1:0] OutputLevel = 2'd1;
  localparam logic [1:0] OutputFollow = 2'd2;

  // Ticks without a program behind which nothing is under way: rtl/time/idle_gate.sv
  localparam int IdleTicks = 16;

endpackage
`default_nettype wire
