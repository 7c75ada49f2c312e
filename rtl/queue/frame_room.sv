// SPDX-License-Identifier: Apache-2.0
// Signals that a word_queue has no room for one more frame.
//
//   clock    0          1
//   put_i    a word enters
//   take_i   a word leaves
//   full_o              1 when fewer than Frame words would fit
`default_nettype none
module frame_room #(
    parameter int Depth = 512,  // [2, 65536] words of the queue
    parameter int Frame = 5     // [2, Depth] words
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic put_i,
    input  wire logic take_i,
    output logic      full_o
);

  initial if (Frame < 2 || Frame > Depth) $fatal(1, "Frame must be in [2, Depth]");

  // The number includes the two words in the queue's output registers
  localparam int CountBits = $clog2(Depth + 3);
  localparam int Most = Depth + 2 - Frame;

  logic [CountBits-1:0] words_q;
  assign full_o = words_q > CountBits'(Most);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) words_q <= '0;
    else if (put_i != take_i) words_q <= words_q + {{(CountBits - 1) {take_i}}, 1'b1};
  end

endmodule
`default_nettype wire
