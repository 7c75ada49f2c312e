// SPDX-License-Identifier: Apache-2.0
// A word of one scale converted to another:
//
//     y = floor(x 2^(Lift - less) / 2^shift + 1/2)
//
//   cycle    0                   4
//   x_i, less_i, shift_i         y_o        shift + less in [0, 63]
`default_nettype none
module step_scale #(
    parameter int Bits    = 36,  // [18, 36]
    parameter int Lift    = 4,   // [4, 9]
    parameter int OutBits = 36   // [18, 44]
) (
    input  wire logic                      clk_i,
    input  wire logic signed [   Bits-1:0] x_i,
    input  wire logic        [        3:0] less_i,
    input  wire logic        [        5:0] shift_i,
    output logic signed      [OutBits-1:0] y_o
);

  // Doubled, and as long as the longest shift needs; a smaller lift is a longer shift.
  logic signed [Bits-1:0] x_q;
  logic        [     5:0] shift_q;
  logic signed [    63:0] lifted;
  logic        [     5:0] coarse;
  logic signed [    63:0] coarse_q;
  logic        [     2:0] fine_q;
  logic signed [    63:0] doubled;
  logic signed [    63:0] doubled_q;
  logic signed [    63:0] one;
  logic signed [    63:0] rounded;
  assign lifted = {{(63 - Lift - Bits) {x_q[Bits-1]}}, x_q, {(Lift + 1) {1'b0}}};
  assign coarse = {shift_q[5:3], 3'd0};
  assign doubled = coarse_q >>> fine_q;
  assign one = 64'sd1;
  assign rounded = doubled_q + one;
  always_ff @(posedge clk_i) begin
    x_q       <= x_i;
    shift_q   <= shift_i + {2'b00, less_i};
    coarse_q  <= lifted >>> coarse;
    fine_q    <= shift_q[2:0];
    doubled_q <= doubled;
    y_o       <= rounded[OutBits:1];
  end

endmodule
`default_nettype wire
