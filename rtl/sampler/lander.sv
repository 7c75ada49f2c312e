// SPDX-License-Identifier: Apache-2.0
// One axis of a sample: the step's origin plus the displacement, or the segment's end exactly.
//
//     fine = land ? end : origin + floor(d 2^k 2^GuardBits + 1/2)
//     position = floor(fine / 2^GuardBits + 1/2)
//
//   clock           0      1               2      3                   4      5
//                   d      origin_bank_i          end_bank_i, land_i         fine_o, position_o
`default_nettype none
module lander #(
    parameter int CoefBits     = 36,  // [18, 36]
    parameter int PositionBits = 32,  // [16, 32]
    parameter int GuardBits    = 10   // [2, 12]
) (
    input wire logic clk_i,

    // Origin and end of the step in a bank
    input wire logic                                     write_i,
    input wire logic        [                       1:0] write_bank_i,
    input wire logic signed [PositionBits+GuardBits-1:0] write_origin_i,
    input wire logic signed [PositionBits+GuardBits-1:0] write_end_i,

    input  wire logic signed [              CoefBits-1:0] d_i,
    input  wire logic        [                       4:0] down_i,
    input  wire logic        [                       1:0] origin_bank_i,
    input  wire logic        [                       1:0] end_bank_i,
    input  wire logic                                     land_i,
    output logic signed      [PositionBits+GuardBits-1:0] fine_o,
    output logic signed      [          PositionBits-1:0] position_o
);

  localparam int FineBits = PositionBits + GuardBits;

  logic signed [FineBits-1:0] origin_memory[4];
  logic signed [FineBits-1:0] end_memory   [4];
  always_ff @(posedge clk_i) begin
    if (write_i) begin
      origin_memory[write_bank_i] <= write_origin_i;
      end_memory[write_bank_i]    <= write_end_i;
    end
  end

  logic signed [FineBits:0] doubled;
  fine_scale #(
      .CoefBits (CoefBits),
      .FineBits (FineBits),
      .GuardBits(GuardBits)
  ) u_scale (
      .clk_i,
      .en_i(1'b1),
      .d_i,
      .down_i,
      .none_i(1'b0),
      .doubled_o(doubled)
  );

  logic signed [FineBits-1:0] origin_q;
  logic signed [FineBits-1:0] sum_q;
  logic signed [FineBits-1:0] fine_q;
  logic signed [  FineBits:0] origin_half;
  logic signed [  FineBits:0] twice;
  logic signed [FineBits-1:0] half;
  logic signed [FineBits-1:0] rounded;
  assign origin_half = {origin_q, 1'b1};
  assign twice       = origin_half + doubled;
  assign half        = {{PositionBits{1'b0}}, 1'b1, {(GuardBits - 1) {1'b0}}};
  assign rounded     = fine_q + half;
  always_ff @(posedge clk_i) begin
    origin_q   <= origin_memory[origin_bank_i];
    sum_q      <= twice[FineBits:1];
    fine_q     <= land_i ? end_memory[end_bank_i] : sum_q;
    fine_o     <= fine_q;
    position_o <= rounded[FineBits-1:GuardBits];
  end

endmodule
`default_nettype wire
