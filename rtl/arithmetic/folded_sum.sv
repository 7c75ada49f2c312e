// SPDX-License-Identifier: Apache-2.0
// A sum of products on one 18 x 18 multiplier, four clocks a product:
//
//     total = half + a[1] b[1] + .. + a[n] b[n]      n <= 13
//
// The operands pass four times, part after part of the products: low x low, low x high, high x low,
// high x high halves.  So the adder needs no more than 42 bits: between the parts the sum moves
// down by 18.
//
//   cycle         0      n-1    n     2n     3n    4n-1          4n+4
//   valid_i       1  ..  1  ..  1  .. 1  ..  1  .. 1
//   part_i        0      0      1     2      3     3
//   first_i       1                                              tag_i is taken
//   drop_i                      1            1
//   a_i, b_i      a[1]   a[n]   a[1]  a[1]   a[1]  a[n]
//   total_o                                                      total, tag_o until the next's 4
//
// Clocks without valid_i may lie between.  unsigned_i: b has no sign.  half_i belongs to opening_o,
// a tag before its sum begins, in the same clock.  No reset: a sum follows its operands only.
// Form: 0 portable, 1 ECP5 (registered MULT18X18D); equal bit for bit.
// With Own = 0 the multiplier is outside, a half_product of the `or` of its users' factors_o, which
// are zero in clocks without operands: users whose operands never come together share it.
`default_nettype none
module folded_sum #(
    parameter int Bits    = 36,  // [18, 36]
    parameter int TagBits = 1,   // [1, 8]
    parameter int Own     = 1,   // 0, 1
    parameter int Form    = 0    // 0, 1
) (
    input  wire logic                      clk_i,
    input  wire logic                      valid_i,
    input  wire logic        [        1:0] part_i,
    input  wire logic                      first_i,
    input  wire logic                      drop_i,
    input  wire logic        [TagBits-1:0] tag_i,
    input  wire logic                      unsigned_i,
    input  wire logic signed [   Bits-1:0] a_i,
    input  wire logic signed [   Bits-1:0] b_i,
    output logic             [TagBits-1:0] opening_o,
    input  wire logic        [       41:0] half_i,
    output logic             [TagBits-1:0] tag_o,
    output logic             [       77:0] total_o,
    output logic             [       37:0] factors_o,
    input  wire logic        [       35:0] product_i
);

  initial if (Bits < 18 || Bits > 36) $fatal(1, "Bits must be in [18, 36]");
  initial if (Form < 0 || Form > 1) $fatal(1, "Form must be 0 or 1");
  localparam int W = (Bits < 18 || Bits > 36) ? 36 : Bits;
  localparam int SumBits = 42;

  // Halves: the high one signed, the low one not.
  logic signed [36:0] a;
  logic signed [36:0] b;
  logic        [17:0] a_q;
  logic        [17:0] b_q;
  logic               a_signed_q;
  logic               b_signed_q;
  assign a = 37'(a_i);
  assign b = {{(37 - W) {b_i[W-1] && !unsigned_i}}, b_i};
  always_ff @(posedge clk_i) begin
    a_q        <= part_i[1] ? a[35:18] : a[17:0];
    b_q        <= part_i[0] ? b[35:18] : b[17:0];
    a_signed_q <= part_i[1];
    b_signed_q <= part_i[0] && !unsigned_i;
    if (Own == 0 && !valid_i) {a_signed_q, b_signed_q, a_q, b_q} <= '0;
  end
  assign factors_o = {a_signed_q, b_signed_q, a_q, b_q};

  logic [35:0] product;
  if (Own != 0) begin : g_own
    logic unused;
    assign unused = &product_i;
    half_product #(
        .Form(Form)
    ) u_product (
        .clk_i,
        .factors_i(factors_o),
        .product_o(product)
    );
  end else begin : g_shared
    assign product = product_i;
  end

  // Tag and shift travel beside the product.
  localparam int Clocks = 4;
  logic               valid_q   [Clocks];
  logic               first_q   [Clocks];
  logic               drop_q    [Clocks];
  logic [TagBits-1:0] tag_q     [Clocks];
  logic               negative_q[Clocks];  // the product may be negative: its sign counts
  always_ff @(posedge clk_i) begin
    valid_q[0]    <= valid_i;
    first_q[0]    <= first_i;
    drop_q[0]     <= drop_i;
    tag_q[0]      <= tag_i;
    negative_q[0] <= part_i[1] || (part_i[0] && !unsigned_i);
    for (int n = 1; n < Clocks; n = n + 1) begin
      valid_q[n]    <= valid_q[n-1];
      first_q[n]    <= first_q[n-1];
      drop_q[n]     <= drop_q[n-1];
      tag_q[n]      <= tag_q[n-1];
      negative_q[n] <= negative_q[n-1];
    end
  end

  logic signed [SumBits-1:0] total_q;
  logic        [       35:0] dropped_q;
  logic        [SumBits-1:0] half_q;
  logic signed [SumBits-1:0] lowered;
  logic signed [SumBits-1:0] base;
  logic signed [SumBits-1:0] term;
  logic                      valid;
  logic                      first;
  logic                      drop;
  assign valid     = valid_q[Clocks-1];
  assign first     = first_q[Clocks-1];
  assign drop      = drop_q[Clocks-1];
  assign opening_o = tag_q[Clocks-2];
  assign lowered   = {{18{total_q[SumBits-1]}}, total_q[SumBits-1:18]};
  assign term      = {{(SumBits - 36) {product[35] && negative_q[Clocks-1]}}, product};
  always_comb begin
    base = total_q;
    if (drop) base = lowered;
    if (first) base = half_q;
  end
  always_ff @(posedge clk_i) begin
    half_q <= half_i;
    if (valid) begin
      total_q <= base + term;
      if (first) tag_o <= tag_q[Clocks-1];
      if (drop) dropped_q <= {total_q[17:0], dropped_q[35:18]};
    end
  end

  assign total_o = {total_q, dropped_q};

endmodule
`default_nettype wire
