// SPDX-License-Identifier: Apache-2.0
// Adder of a Shannon network: the sum of three series, term after term, a clock later.  A term is
// {there, order, coefficient}; the three come together.
`default_nettype none
module adder #(
    parameter int Bits = 36  // [18, 36]
) (
    input  wire logic            clk_i,
    input  wire logic            rst_ni,
    input  wire logic [Bits+4:0] a_i,
    input  wire logic [Bits+4:0] b_i,
    input  wire logic [Bits+4:0] c_i,
    output logic      [Bits+4:0] sum_o
);

  logic signed [Bits-1:0] a;
  logic signed [Bits-1:0] b;
  logic signed [Bits-1:0] ab_q;
  logic signed [Bits-1:0] c_q;
  logic signed [Bits-1:0] sum;
  logic                   there_q;
  logic        [     3:0] order_q;
  assign a     = a_i[Bits-1:0];
  assign b     = b_i[Bits-1:0];
  assign sum   = ab_q + c_q;
  assign sum_o = {there_q, order_q, sum};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) there_q <= 1'b0;
    else there_q <= a_i[Bits+4];
  end
  always_ff @(posedge clk_i) begin
    order_q <= a_i[Bits+3:Bits];
    ab_q    <= a + b;
    c_q     <= c_i[Bits-1:0];
  end

endmodule
`default_nettype wire
