// SPDX-License-Identifier: Apache-2.0
// A displacement d in units of 2^k (CoefBits - 2 fraction bits) as twice a fine position:
//
//     doubled = floor(2 d 2^(k + GuardBits - (CoefBits - 2)))
//     fine    = floor((doubled + 1) / 2)      the rounding, left to the adder that follows:
//               {origin, 1} + doubled = 2 (origin + fine) + (0 or 1)
//
//   enabled clock   0       1      2
//   d_i, down_i     d, MaxStepExponent - k
//   none_i                 1
//   doubled_o                      doubled, 0 with none_i
`default_nettype none
module fine_scale #(
    parameter int CoefBits  = 36,  // [18, 36]
    parameter int FineBits  = 42,  // [18, 44]
    parameter int GuardBits = 10   // [2, 12]
) (
    input  wire logic                       clk_i,
    input  wire logic                       en_i,
    input  wire logic signed [CoefBits-1:0] d_i,
    input  wire logic        [         4:0] down_i,
    input  wire logic                       none_i,
    output logic signed      [  FineBits:0] doubled_o
);

  localparam int Top = curvecore_pkg::MaxStepExponent + GuardBits - (CoefBits - 2);
  localparam int Left = (Top > 0) ? Top : 0;
  localparam int Right = (Top > 0) ? 0 : -Top;
  localparam int Bits = CoefBits + Left + 1;
  localparam int Wide = (Bits > FineBits + 1) ? Bits : FineBits + 1;

  logic        [     5:0] shift;
  logic signed [Bits-1:0] doubled;
  assign shift   = {1'b0, down_i} + 6'(Right);
  assign doubled = {d_i, {(Left + 1) {1'b0}}};

  logic        [     5:0] coarse;
  logic signed [Bits-1:0] coarse_q;
  logic        [     2:0] shift_q;
  logic signed [Bits-1:0] shifted;
  logic signed [Wide-1:0] wide;
  assign coarse  = {shift[5:3], 3'd0};
  assign shifted = coarse_q >>> shift_q;
  assign wide    = Wide'(shifted);
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      coarse_q  <= doubled >>> coarse;
      shift_q   <= shift[2:0];
      doubled_o <= none_i ? '0 : wide[FineBits:0];
    end
  end

endmodule
`default_nettype wire
