// SPDX-License-Identifier: Apache-2.0
// Prints the first Samples positions of part_player, a line each: by default for part.ngc, whose
// words are in this folder.
`timescale 1ns / 1ns
`default_nettype none
module part_player_bench #(
    parameter int Samples            = 264,
    parameter int SegmentWords       = 102,
    parameter int ProfileWords       = 100,
    parameter int SamplesPerTickLog2 = 0,
    parameter int HoldAcceleration   = 2584072,
    parameter int HoldSlope          = 28424792,
    parameter int StopTicks          = 264,
    parameter int Digest             = 12572
);

  logic clk = 1'b0;
  logic rst_n = 1'b0;
  logic valid;
  logic [95:0] position;
  int count = 0;
  always #5 clk = !clk;
  initial #100 rst_n = 1'b1;

  part_player #(
      .SegmentWords(SegmentWords),
      .ProfileWords(ProfileWords),
      .SampleClocks(8),
      .SamplesPerTickLog2(SamplesPerTickLog2),
      .HoldAcceleration(HoldAcceleration),
      .HoldSlope(HoldSlope),
      .StopTicks(StopTicks),
      .Digest(Digest)
  ) u_player (
      .clk_i(clk),
      .rst_ni(rst_n),
      .valid_o(valid),
      .position_o(position)
  );

  always @(posedge clk) begin
    if (valid) begin
      $display("%0d,%0d,%0d", $signed(position[31:0]), $signed(position[63:32]),
               $signed(position[95:64]));
      count <= count + 1;
      if (count == Samples - 1) $finish;
    end
  end

endmodule
