// SPDX-License-Identifier: Apache-2.0
// An external input, two flip-flops later; after a reset it is set, as a request to stop.
`default_nettype none
module synchroniser #(
    parameter int Bits = 1  // [1, 64]
) (
    input  wire logic            clk_i,
    input  wire logic            rst_ni,
    input  wire logic [Bits-1:0] input_i,
    output logic      [Bits-1:0] output_o
);

  (* async_reg = "true" *)
  logic [Bits-1:0] first_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      first_q  <= '1;
      output_o <= '1;
    end else begin
      first_q  <= input_i;
      output_o <= first_q;
    end
  end

endmodule
`default_nettype wire
