// SPDX-License-Identifier: Apache-2.0
// A sum of products on one 18 x 18 multiplier, four clocks a product, rounded once:
//
//     sum = floor((a[1] b[1] + .. + a[n] b[n]) / 2^Shift + 1/2)      n <= 13
//
// with Shift = NarrowShift, or WideShift where wide_i was 1; narrow_sum_o as if it never were.
// folded_sum has the cycles; sum_o comes in its cycle 4n+4.
`default_nettype none
module folded_multiplier #(
    parameter int Bits        = 36,  // [18, 36]
    parameter int NarrowShift = 35,  // [1, 40]
    parameter int WideShift   = 35,  // [1, 40]
    parameter int Own         = 1,   // 0, 1: as folded_sum's, with factors_o and product_i
    parameter int Form        = 0    // 0, 1
) (
    input  wire logic                   clk_i,
    input  wire logic                   valid_i,
    input  wire logic        [     1:0] part_i,
    input  wire logic                   first_i,
    input  wire logic                   drop_i,
    input  wire logic                   wide_i,
    input  wire logic                   unsigned_i,
    input  wire logic signed [Bits-1:0] a_i,
    input  wire logic signed [Bits-1:0] b_i,
    output logic signed      [Bits-1:0] narrow_sum_o,
    output logic signed      [Bits-1:0] sum_o,
    output logic             [    37:0] factors_o,
    input  wire logic        [    35:0] product_i
);

  initial if (Bits < 18 || Bits > 36) $fatal(1, "Bits must be in [18, 36]");
  initial if (NarrowShift < 1 || NarrowShift > 40) $fatal(1, "NarrowShift must be in [1, 40]");
  initial if (WideShift < 1 || WideShift > 40) $fatal(1, "WideShift must be in [1, 40]");
  initial if (Form < 0 || Form > 1) $fatal(1, "Form must be 0 or 1");
  localparam int W = (Bits < 18 || Bits > 36) ? 36 : Bits;

  localparam logic [41:0] NarrowHalf = 42'd1 << (NarrowShift - 1);
  localparam logic [41:0] WideHalf = 42'd1 << (WideShift - 1);

  logic wide;
  logic opening_wide;
  logic [41:0] half;
  logic [77:0] total;
  folded_sum #(
      .Bits(W),
      .TagBits(1),
      .Own(Own),
      .Form(Form)
  ) u_sum (
      .clk_i,
      .valid_i,
      .part_i,
      .first_i,
      .drop_i,
      .tag_i(wide_i),
      .unsigned_i,
      .a_i,
      .b_i,
      .opening_o(opening_wide),
      .half_i(half),
      .tag_o(wide),
      .total_o(total),
      .factors_o,
      .product_i
  );
  assign half = opening_wide ? WideHalf : NarrowHalf;
  assign narrow_sum_o = total[NarrowShift+:W];
  assign sum_o = wide ? total[WideShift+:W] : narrow_sum_o;

endmodule
`default_nettype wire
