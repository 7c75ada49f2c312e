// SPDX-License-Identifier: Apache-2.0
// The next word of a program: the one below, the target of a jump, or the same again.
//
//   clock       0            1         2
//   place_o     n + 1        n + 2     n + 3
//   fetched_i   word n       n + 1     n + 2     at the place of the clock before
//   word_o      word n - 1   n         n + 1     is obeyed
//   stay_i      of word_o: fetched_i stays, too
//   jump_i      of word_o: place_o is its target; the next word_o is 0, which does nothing
//
// Reset: place 0.
`default_nettype none
module program_fetch #(
    parameter int Bits = 36
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic            stay_i,
    input  wire logic            jump_i,
    input  wire logic [     5:0] target_i,
    output logic      [     5:0] place_o,
    output logic                 fetch_o,    // the word of place_o
    input  wire logic [Bits-1:0] fetched_i,
    output logic      [Bits-1:0] word_o
);

  logic fresh_q;  // the fetched word is not of the program
  logic [5:0] place_q;
  assign place_o = jump_i ? target_i : place_q + 6'd1;
  assign fetch_o = !stay_i;
  always_ff @(posedge clk_i) begin
    fresh_q <= !rst_ni;
    if (!rst_ni) place_q <= '1;
    else if (fetch_o) place_q <= place_o;
    if (!rst_ni || fresh_q || jump_i) word_o <= '0;
    else if (fetch_o) word_o <= fetched_i;
  end

endmodule
`default_nettype wire
