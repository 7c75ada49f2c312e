// SPDX-License-Identifier: Apache-2.0
// Powers of two for a spline's scalings by 2^-s, s = lambda - k, as products (scaled_down in
// hls/curves/curve_steps.hpp): x 2^Lift / 2^shift is rounded with a shift by CoefBits - 1 of
// x 2^(CoefBits - 1 - e), e = shift - Lift, if that is a word, else with one by CoefBits - 6 of
// x 2^(CoefBits - 6 - e).  The unused power is 0, as are both for e >= CoefBits: no word is then as
// large as one half.
//
//   place_o    0, 1    2, 3    4, 5      6, 7
//   e          s - 1   s - 4   2 s - 1   2 s - 4      first the power for CoefBits - 1
//
//   cycle      0        1                          8        9
//   run_i      1        1                          1        (0)
//   write_o             1, place_o 0, word_o  ..   place_o 7, done_o
`default_nettype none
module scale_words #(
    parameter int CoefBits = 36  // [18, 36]
) (
    input wire logic clk_i,

    input  wire logic                run_i,
    input  wire logic [         4:0] k_i,
    input  wire logic [         4:0] lambda_i,
    output logic                     write_o,
    output logic      [         2:0] place_o,
    output logic      [CoefBits-1:0] word_o,
    output logic                     done_o
);

  logic [3:0] next_q;
  logic [4:0] s_q;
  logic [6:0] down;
  logic [6:0] offset;
  logic [6:0] place_q;  // place of the power's one
  logic       small_q;
  logic       there;
  assign down   = next_q[2] ? {1'b0, s_q, 1'b0} : {2'b00, s_q};
  assign offset = 7'(CoefBits) + (next_q[1] ? 7'd3 : 7'd0) - (next_q[0] ? 7'd5 : 7'd0);
  assign there  = place_q <= 7'(CoefBits - 2) && (!small_q || place_q >= 7'(CoefBits - 6));
  always_ff @(posedge clk_i) begin
    s_q     <= lambda_i - k_i;
    next_q  <= run_i ? next_q + 4'd1 : 4'd0;
    place_q <= offset - down;  // at least -41: too large as an unsigned number
    small_q <= next_q[0];
  end
  assign write_o = next_q != 4'd0;
  assign place_o = next_q[2:0] - 3'd1;
  assign done_o  = next_q == 4'd8;

  always_comb begin
    for (int n = 0; n < CoefBits; n = n + 1) word_o[n] = there && place_q == 7'(n);
  end

endmodule
`default_nettype wire
