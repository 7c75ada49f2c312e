// SPDX-License-Identifier: Apache-2.0
// Words of a step along a spline for its bank (rtl/sampler/bank_pkg.sv).
//
//   Mode 0   the terms of x y z: X Y Z of the term's order
//   Mode 1   the terms of q: Own.  The cubic, X Y Z of the power of q: a' 3, B' 2, V 1, of which V
//            and W come as terms of order 0, and B' = floor(W / 8 + 1/2)
//
//   cycle                 0                    1                2
//   a_there_i             axis of a_i          a' in words_o
//   v_i, x_i, q_i         there                term in words_o
//   w_i                   there                                 B' in words_o
//
// One kind of word of the cubic comes at a time: a' before V, B' a clock after V or later.
`default_nettype none
module spline_bank #(
    parameter int CoefBits = 36,  // [18, 36]
    parameter int Mode     = 1    // 0 series, 1 polynomial
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic [            1:0] bank_i,
    input wire logic [            2:0] a_there_i,
    input wire logic [   CoefBits-1:0] a_i,
    input wire logic [   CoefBits+4:0] q_i,        // terms {there, order, coefficient}
    input wire logic [3*CoefBits+14:0] x_i,        // three of them
    input wire logic [3*CoefBits+14:0] v_i,
    input wire logic [3*CoefBits+14:0] w_i,

    output logic [          bank_pkg::Bits-1:0] write_o,
    output logic [bank_pkg::Lanes*CoefBits-1:0] words_o
);

  localparam int TermBits = CoefBits + 5;

  logic [           2:0] lanes_q;
  logic [           3:0] place_q;
  logic [3*CoefBits-1:0] xyz_q;
  logic                  own_there;
  logic [           3:0] own_place;
  logic [  CoefBits-1:0] own;
  logic [           1:0] bank_q;
  assign write_o = {3'b000, own_there, lanes_q, own_place, place_q, bank_q};
  assign words_o = {{(3 * CoefBits) {1'b0}}, own, xyz_q};
  always_ff @(posedge clk_i) bank_q <= bank_i;

  logic [2:0] lanes;
  always_ff @(posedge clk_i) lanes_q <= rst_ni ? lanes : 3'd0;

  if (Mode == 0) begin : g_series
    logic unused;
    assign unused    = &{a_there_i, a_i, q_i, v_i, w_i};
    assign lanes     = {3{x_i[TermBits-1]}};
    assign own_there = 1'b0;
    assign own_place = 4'd0;
    assign own       = '0;
    always_ff @(posedge clk_i) begin
      place_q <= x_i[CoefBits+:4];
      xyz_q   <= {x_i[2*TermBits+:CoefBits], x_i[TermBits+:CoefBits], x_i[0+:CoefBits]};
    end
  end else begin : g_cubic
    logic unused;
    assign unused = &x_i;

    logic                own_there_q;
    logic [         3:0] own_place_q;
    logic [CoefBits-1:0] own_q;
    assign own_there = own_there_q;
    assign own_place = own_place_q;
    assign own       = own_q;
    always_ff @(posedge clk_i) begin
      own_there_q <= rst_ni && q_i[TermBits-1];
      own_place_q <= q_i[CoefBits+:4];
      own_q       <= q_i[CoefBits-1:0];
    end

    logic [           2:0] v_there;
    logic [           2:0] b_there_q;
    logic [3*CoefBits-1:0] v;
    logic [3*CoefBits-1:0] b;
    for (genvar k = 0; k < 3; k++) begin : g_axis
      logic [TermBits-1:0] w;
      logic signed [CoefBits:0] quarters;  // floor(W / 4)
      logic signed [CoefBits:0] quarters_q;
      logic signed [CoefBits:0] one;
      logic signed [CoefBits:0] rounded;
      assign w = w_i[k*TermBits+:TermBits];
      assign quarters = {{3{w[CoefBits-1]}}, w[CoefBits-1:2]};
      assign one = (CoefBits + 1)'(2'sd1);
      assign rounded = quarters_q + one;
      assign v_there[k] = v_i[k*TermBits+TermBits-1] && v_i[k*TermBits+CoefBits+:4] == 4'd0;
      assign v[k*CoefBits+:CoefBits] = v_i[k*TermBits+:CoefBits];
      assign b[k*CoefBits+:CoefBits] = rounded[CoefBits:1];
      always_ff @(posedge clk_i) begin
        b_there_q[k] <= rst_ni && w[TermBits-1] && w[TermBits-2:CoefBits] == 4'd0;
        quarters_q   <= quarters;
      end
    end
    assign lanes = a_there_i | v_there | b_there_q;
    always_ff @(posedge clk_i) begin
      place_q <= 4'd3;
      xyz_q   <= {3{a_i}};
      if (b_there_q != 3'd0) begin
        place_q <= 4'd2;
        xyz_q   <= b;
      end
      if (v_there != 3'd0) begin
        place_q <= 4'd1;
        xyz_q   <= v;
      end
    end
  end

endmodule
`default_nettype wire
