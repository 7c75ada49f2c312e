// SPDX-License-Identifier: Apache-2.0
// What the sampler needs of V and W: their terms of order 0, and B' = floor(W / 8 + 1/2).
//
//   cycle          0                    1                            2
//   v_i, w_i       terms of X, Y, Z
//   v_write_o                           the axes of v_o
//   b_write_o                                                        the axes of b_o
`default_nettype none
module cubic_words #(
    parameter int CoefBits = 36  // [18, 36]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic [3*CoefBits+14:0] v_i,        // three terms {there, order, coefficient}
    input  wire logic [3*CoefBits+14:0] w_i,
    output logic      [            2:0] v_write_o,
    output logic      [ 3*CoefBits-1:0] v_o,
    output logic      [            2:0] b_write_o,
    output logic      [ 3*CoefBits-1:0] b_o
);

  localparam int TermBits = CoefBits + 5;

  for (genvar k = 0; k < 3; k++) begin : g_axis
    logic [TermBits-1:0] v;
    logic [TermBits-1:0] w;
    logic signed [CoefBits:0] quarters;  // of W: floor(W / 4)
    logic signed [CoefBits:0] one;
    logic signed [CoefBits:0] rounded;
    logic signed [CoefBits:0] quarters_q;
    logic there_q;
    assign v        = v_i[k*TermBits+:TermBits];
    assign w        = w_i[k*TermBits+:TermBits];
    assign quarters = {{3{w[CoefBits-1]}}, w[CoefBits-1:2]};
    assign one      = (CoefBits + 1)'(2'sd1);
    assign rounded  = quarters_q + one;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        v_write_o[k] <= 1'b0;
        there_q      <= 1'b0;
        b_write_o[k] <= 1'b0;
      end else begin
        v_write_o[k] <= v[TermBits-1] && v[TermBits-2:CoefBits] == 4'd0;
        b_write_o[k] <= there_q;
        there_q      <= w[TermBits-1] && w[TermBits-2:CoefBits] == 4'd0;
      end
    end
    always_ff @(posedge clk_i) begin
      quarters_q <= quarters;
      v_o[k*CoefBits+:CoefBits] <= v[CoefBits-1:0];
      b_o[k*CoefBits+:CoefBits] <= rounded[CoefBits:1];
    end
  end

endmodule
`default_nettype wire
