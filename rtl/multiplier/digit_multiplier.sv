// SPDX-License-Identifier: Apache-2.0
// Product of a word and a weight that comes in digits of two bits, lowest first:
//
//     base    = a, or -a if Negative
//     product = floor(base * weight / 2^(Bits-1) + 1/2)      0 <= weight < 2^(Bits-1)
//
// curvecore_pkg::weight_digits(Bits) digits; the last has one bit (for odd Bits the weight comes
// doubled).  No multiplier: several units share one weight.
//
//   cycle       0      1        2  ..  Digits + 1      Digits + 3
//   Take        1                                      (may be 1 again)
//   a_i         a
//   Triple             1
//   Step                        1  ..  1
//   Digit                       digits
//   Last                               1
//   base_o                      base
//   product_o   of the one before, up to cycle 2       product
`default_nettype none
module digit_multiplier #(
    parameter int Bits     = 36,  // [18, 36]
    parameter int Negative = 0    // 0, 1
) (
    input  wire logic                               clk_i,
    input  wire logic        [digits_pkg::Bits-1:0] digits_i,
    input  wire logic signed [            Bits-1:0] a_i,
    output logic signed      [            Bits-1:0] base_o,
    output logic signed      [            Bits-1:0] product_o
);

  initial if (Bits < 18 || Bits > 36) $fatal(1, "Bits must be in [18, 36]");

  logic                   triple;
  logic signed [Bits-1:0] a_q;
  logic signed [Bits-1:0] minus_a;
  logic signed [Bits+1:0] a;
  logic signed [Bits+1:0] multiplied;  // 2a, for -3a = a - 4a: 4a
  logic signed [Bits+1:0] triple_q;
  assign triple     = digits_i[digits_pkg::Triple];
  assign minus_a    = -a_q;
  assign a          = {{2{a_q[Bits-1]}}, a_q};
  assign multiplied = (Negative != 0) ? {a_q, 2'b00} : {a_q[Bits-1], a_q, 1'b0};
  always_ff @(posedge clk_i) begin
    if (digits_i[digits_pkg::Take]) a_q <= a_i;
    if (triple) begin
      base_o   <= (Negative != 0) ? minus_a : a_q;
      triple_q <= (Negative != 0) ? a - multiplied : a + multiplied;
    end
  end

  // The multiple, a clock ahead of its addition.
  logic signed [Bits+1:0] multiple_q;
  logic                   clear_q;
  logic                   step_q;
  logic                   last_q;
  always_ff @(posedge clk_i) begin
    clear_q <= triple;
    step_q  <= digits_i[digits_pkg::Step];
    last_q  <= digits_i[digits_pkg::Last];
    case (digits_i[digits_pkg::Digit+:2])
      2'd0: multiple_q <= '0;
      2'd1: multiple_q <= {{2{base_o[Bits-1]}}, base_o};
      2'd2: multiple_q <= {base_o[Bits-1], base_o, 1'b0};
      default: multiple_q <= triple_q;
    endcase
  end

  // The sum of the digits so far in halves: every digit shifts by two places, the last by one,
  // which leaves whole units, rounded by last_q.
  logic signed [  Bits:0] half_q;
  logic signed [Bits+1:0] whole;
  logic signed [Bits+1:0] carry;
  logic signed [Bits+1:0] sum;
  assign whole = {{2{half_q[Bits]}}, half_q[Bits:1]};
  assign carry = {{(Bits + 1) {1'b0}}, last_q};
  assign sum   = whole + multiple_q + carry;

  always_ff @(posedge clk_i) begin
    if (clear_q) half_q <= '0;
    else if (step_q) half_q <= sum[Bits+1:1];
  end
  assign product_o = half_q[Bits-1:0];

endmodule
`default_nettype wire
