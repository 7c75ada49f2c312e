// SPDX-License-Identifier: Apache-2.0
// The path so far, 64 bits in two halves, a clock each.
//
//   clock     0      2
//   move_i    1
//   ds_i      ds
//   valid_o          1
//   path_o           with ds        ds_o, rate_o: of this move
`default_nettype none
module path_meter (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic        move_i,
    input wire logic [47:0] ds_i,
    input wire logic [17:0] rate_i,

    output logic        valid_o,
    output logic [47:0] ds_o,
    output logic [17:0] rate_o,
    output logic [63:0] path_o
);

  logic move_q;
  logic [47:0] ds_q;
  logic [17:0] rate_q;
  logic [31:0] low_q;
  logic carry_q;
  logic [32:0] low;
  assign low = {1'b0, low_q} + {1'b0, ds_i[31:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      move_q  <= 1'b0;
      valid_o <= 1'b0;
      low_q   <= '0;
      path_o  <= '0;
    end else begin
      move_q  <= move_i;
      valid_o <= move_q;
      if (move_i) low_q <= low[31:0];
      if (move_q) begin
        path_o[31:0]  <= low_q;
        path_o[63:32] <= path_o[63:32] + {16'b0, ds_q[47:32]} + {31'b0, carry_q};
      end
    end
  end
  always_ff @(posedge clk_i) begin
    ds_q    <= ds_i;
    rate_q  <= rate_i;
    carry_q <= low[32];
    ds_o    <= ds_q;
    rate_o  <= rate_q;
  end

endmodule
`default_nettype wire
