// SPDX-License-Identifier: Apache-2.0
// A core's reset, a clock longer than its input: registers beside the nodes pass it on a clock
// late, so it takes two.
//
//   clock      0    1    2    3
//   rst_ni     1    0    1    1
//   rst_no     1    0    0    1
//
// Sources of words see ready_o = 0 as long as rst_no is 0.
`default_nettype none
module reset_stretcher (
    input  wire logic clk_i,
    input  wire logic rst_ni,
    output logic      rst_no
);

  logic late_q;
  always_ff @(posedge clk_i) late_q <= rst_ni;
  assign rst_no = rst_ni && late_q;

endmodule
`default_nettype wire
