// SPDX-License-Identifier: Apache-2.0
// Time within a piece as the variable of its polynomial: tau = time / 2^(m + 16), 35 fraction bits.
//
//   clock      0        2
//   valid_i    1
//   time_i     time
//   valid_o             1
//   tau_o               tau      tag_o: tag_i
`default_nettype none
module tau_shift #(
    parameter int TagBits = 8  // [1, 32]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic               valid_i,
    input  wire logic [       35:0] time_i,
    input  wire logic [        4:0] time_exponent_i,  // m, [0, 19]
    input  wire logic [TagBits-1:0] tag_i,
    output logic                    valid_o,
    output logic      [       35:0] tau_o,
    output logic      [TagBits-1:0] tag_o
);

  initial if (TagBits < 1 || TagBits > 32) $fatal(1, "TagBits must be in [1, 32]");

  logic [4:0] shift;
  assign shift = 5'd19 - time_exponent_i;

  logic valid_q;
  logic [1:0] fine_q;
  logic [35:0] coarse_q;
  logic [TagBits-1:0] tag_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q <= 1'b0;
      valid_o <= 1'b0;
    end else begin
      valid_q <= valid_i;
      valid_o <= valid_q;
    end
  end
  always_ff @(posedge clk_i) begin
    coarse_q <= time_i << {shift[4:2], 2'b0};
    fine_q   <= shift[1:0];
    tag_q    <= tag_i;
    tau_o    <= coarse_q << fine_q;
    tag_o    <= tag_q;
  end

endmodule
`default_nettype wire
