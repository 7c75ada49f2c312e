// SPDX-License-Identifier: Apache-2.0
// Portable form of `multiplier`: four partial products of 18 bits, whose registers a DSP block may
// take.  No signal is wider than 64 bits before the product, which makes simulation fast.
//
//   cycle   1      2          3, 4          5
//           a, b   products   product_sum   product
`default_nettype none
module multiplier_portable #(
    parameter int ABits = 36,  // [18, 36]
    parameter int BBits = 36,  // [18, 36]
    parameter int Shift = 0,   // [0, 35]
    parameter int Early = 0    // 1: the product is there a clock earlier
) (
    input  wire logic                                clk_i,
    input  wire logic                                en_i,
    input  wire logic signed [            ABits-1:0] a_i,
    input  wire logic signed [            BBits-1:0] b_i,
    output logic signed      [ABits+BBits-Shift-1:0] product_o
);

  // Operands as fractions of 36 bits: signed high half, unsigned low half.
  logic [35:0] a;
  logic [35:0] b;
  assign a = {a_i, {(36 - ABits) {1'b0}}};
  assign b = {b_i, {(36 - BBits) {1'b0}}};

  logic [35:0] a_q;
  logic [35:0] b_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      a_q <= a;
      b_q <= b;
    end
  end

  logic signed [36:0] a_high;
  logic signed [36:0] b_high;
  logic signed [36:0] a_low;
  logic signed [36:0] b_low;
  assign a_high = {{19{a_q[35]}}, a_q[35:18]};
  assign b_high = {{19{b_q[35]}}, b_q[35:18]};
  assign a_low  = {19'd0, a_q[17:0]};
  assign b_low  = {19'd0, b_q[17:0]};

  logic signed [36:0] high_high_q;
  logic signed [36:0] high_low_q;
  logic signed [36:0] low_high_q;
  logic signed [36:0] low_low_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      high_high_q <= a_high * b_high;
      high_low_q  <= a_high * b_low;
      low_high_q  <= a_low * b_high;
      low_low_q   <= a_low * b_low;
    end
  end

  logic signed [ABits+BBits-Shift-1:0] product;
  product_sum #(
      .ABits(ABits),
      .BBits(BBits),
      .Shift(Shift)
  ) u_sum (
      .clk_i,
      .en_i,
      .high_high_i(high_high_q[35:0]),
      .high_low_i (high_low_q[35:0]),
      .low_high_i (low_high_q[35:0]),
      .low_low_i  (low_low_q[35:0]),
      .product_o  (product)
  );

  if (Early == 1) begin : g_early
    assign product_o = product;
  end else begin : g_kept
    always_ff @(posedge clk_i) begin
      if (en_i) product_o <= product;
    end
  end

endmodule
`default_nettype wire
