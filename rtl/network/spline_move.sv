// SPDX-License-Identifier: Apache-2.0
// Displacement of a step along X Y Z, in units of 2^k: the sums of the terms of dx = V dq.
//
//     d = x[1] + .. + x[Order]
//
//   cycle      0               1         2
//   x_i        the last terms
//   axis_i                     axis      another ..     until the next step's x[1]
//   d_o                                  d of axis
`default_nettype none
module spline_move #(
    parameter int CoefBits = 36  // [18, 36]
) (
    input wire logic clk_i,

    input  wire logic   [3*CoefBits+14:0] x_i,     // X Y Z: terms {there, order, coefficient}
    input  wire logic   [            1:0] axis_i,
    output logic signed [   CoefBits-1:0] d_o
);

  localparam int TermBits = CoefBits + 5;

  logic signed [CoefBits-1:0] sum_q[3];
  for (genvar k = 0; k < 3; k++) begin : g_axis
    logic        [TermBits-1:0] x;
    logic signed [CoefBits-1:0] lower;  // the orders below
    assign x     = x_i[k*TermBits+:TermBits];
    assign lower = (x[TermBits-2:CoefBits] == 4'd1) ? '0 : sum_q[k];
    always_ff @(posedge clk_i) begin
      if (x[TermBits-1]) sum_q[k] <= lower + x[CoefBits-1:0];
    end
  end
  always_ff @(posedge clk_i) begin
    case (axis_i)
      2'd0:    d_o <= sum_q[0];
      2'd1:    d_o <= sum_q[1];
      default: d_o <= sum_q[2];
    endcase
  end

endmodule
`default_nettype wire
