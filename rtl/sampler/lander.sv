// SPDX-License-Identifier: Apache-2.0
// One axis of a sample: the step's origin plus the displacement, or the segment's end exactly.
//
//     fine = land ? end : origin + floor(d 2^k 2^GuardBits + 1/2)
//
//   clock           0      1                2      3
//                   d      place_i, land_i         fine_o
`default_nettype none
module lander #(
    parameter int CoefBits  = 36,  // [18, 36]
    parameter int FineBits  = 42,  // [18, 44]
    parameter int GuardBits = 10,  // [2, 12]
    parameter int PlaceBits = 2    // bank, or axis and bank
) (
    input wire logic clk_i,

    // Origin and end of a step
    input wire logic                        write_i,
    input wire logic        [PlaceBits-1:0] write_place_i,
    input wire logic signed [ FineBits-1:0] write_origin_i,
    input wire logic signed [ FineBits-1:0] write_end_i,

    input  wire logic signed [ CoefBits-1:0] d_i,
    input  wire logic        [          4:0] down_i,
    input  wire logic        [PlaceBits-1:0] place_i,
    input  wire logic                        land_i,
    output logic signed      [ FineBits-1:0] fine_o
);

  logic signed [FineBits-1:0] origin_memory[1<<PlaceBits];
  logic signed [FineBits-1:0] end_memory   [1<<PlaceBits];
  always_ff @(posedge clk_i) begin
    if (write_i) begin
      origin_memory[write_place_i] <= write_origin_i;
      end_memory[write_place_i]    <= write_end_i;
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
      .none_i(land_i),
      .doubled_o(doubled)
  );

  logic signed [FineBits-1:0] base_q;
  logic signed [  FineBits:0] base_half;
  logic signed [  FineBits:0] twice;
  assign base_half = {base_q, 1'b1};
  assign twice     = base_half + doubled;
  always_ff @(posedge clk_i) begin
    base_q <= land_i ? end_memory[place_i] : origin_memory[place_i];
    fine_o <= twice[FineBits:1];
  end

endmodule
`default_nettype wire
