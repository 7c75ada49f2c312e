// SPDX-License-Identifier: Apache-2.0
// Sums of products, column by column: a column begins with what the one before carries, and with
// the half that rounds.
//
//   clock        0      3         4
//   begins_i ..  term
//   product_i           of it
//   sum_o                         with it
//
// At most three products of 2^30, a limb and a carry are within 34 bits.
`default_nettype none
module column_sum (
    input wire logic clk_i,

    input  wire logic               begins_i,   // a column
    input  wire logic               afresh_i,   // an instruction's first: nothing is carried
    input  wire logic               round_i,    // half of the column before is added
    input  wire logic signed [31:0] product_i,
    output logic signed      [33:0] sum_o
);

  logic [2:0] control_q[3];
  logic begins, afresh, round;
  always_ff @(posedge clk_i) begin
    control_q[0] <= {begins_i, afresh_i, round_i};
    control_q[1] <= control_q[0];
    control_q[2] <= control_q[1];
  end
  assign {begins, afresh, round} = control_q[2];

  logic signed [33:0] carry;
  logic signed [33:0] base;
  logic half;
  assign carry = sum_o >>> 15;
  assign half  = round && sum_o[14];
  always_comb begin
    base = sum_o;
    if (begins) base = carry;
    if (afresh) base = '0;
  end

  // The half is the adder's carry in.
  logic [34:0] first;
  logic [34:0] second;
  logic [34:0] sum;
  assign first = {base, 1'b1};
  assign second = {{2{product_i[31]}}, product_i, half};
  assign sum = first + second;
  always_ff @(posedge clk_i) sum_o <= $signed(sum[34:1]);

endmodule
`default_nettype wire
