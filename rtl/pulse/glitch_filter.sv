// SPDX-License-Identifier: Apache-2.0
// Levels of pins, sampled every Clocks clocks: a level counts when three samples are equal. So a
// level held for 3 Clocks counts, and one shorter than 2 Clocks does not.
`default_nettype none
module glitch_filter #(
    parameter int Bits   = 1,  // [1, 64]
    parameter int Clocks = 3   // [1, 15]
) (
    input  wire logic            clk_i,
    input  wire logic            rst_ni,
    input  wire logic [Bits-1:0] input_i,
    output logic      [Bits-1:0] output_o
);

  logic [3:0] wait_q;
  logic [Bits-1:0] last_q;
  logic [Bits-1:0] before_q;
  logic looks;
  assign looks = wait_q == '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || looks) wait_q <= 4'(Clocks - 1);
    else wait_q <= wait_q - 1'b1;
    if (looks) begin
      last_q   <= input_i;
      before_q <= last_q;
      output_o <= (output_o & (input_i | last_q | before_q)) | (input_i & last_q & before_q);
    end
  end

endmodule
`default_nettype wire
