// SPDX-License-Identifier: Apache-2.0
// The number of steps that an axis has given since the reset.
`default_nettype none
module step_counter (
    input  wire logic        clk_i,
    input  wire logic        rst_ni,
    input  wire logic        rise_i,  // a step
    input  wire logic        back_i,  // its direction
    output logic      [31:0] count_o
);

  logic [31:0] change;
  assign change = {{31{back_i}}, 1'b1};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) count_o <= '0;
    else if (rise_i) count_o <= count_o + change;
  end

endmodule
`default_nettype wire
