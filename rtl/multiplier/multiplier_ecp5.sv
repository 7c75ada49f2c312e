// SPDX-License-Identifier: Apache-2.0
// ECP5 form of `multiplier`: up to four MULT18X18D with all their registers in use.
//
//   cycle   1              2                 3               4, 5
//           DSP input      DSP pipeline      DSP output      product_sum
`default_nettype none
module multiplier_ecp5 #(
    parameter int ABits = 36,  // [18, 36]
    parameter int BBits = 36,  // [18, 36]
    parameter int Shift = 0    // [0, 35]
) (
    input  wire logic                                clk_i,
    input  wire logic                                en_i,
    input  wire logic signed [            ABits-1:0] a_i,
    input  wire logic signed [            BBits-1:0] b_i,
    output logic signed      [ABits+BBits-Shift-1:0] product_o
);

  // Operands as fractions of 36 bits: signed high half, unsigned low half (empty at 18 bits).
  logic [35:0] a;
  logic [35:0] b;
  assign a = {a_i, {(36 - ABits) {1'b0}}};
  assign b = {b_i, {(36 - BBits) {1'b0}}};

  logic [35:0] high_high;
  logic [35:0] high_low;
  logic [35:0] low_high;
  logic [35:0] low_low;

  dsp_ecp5 u_high_high (
      .clk_i,
      .en_i,
      .a_signed_i(1'b1),
      .b_signed_i(1'b1),
      .a_i(a[35:18]),
      .b_i(b[35:18]),
      .product_o(high_high)
  );

  if (BBits > 18) begin : g_high_low
    dsp_ecp5 u_high_low (
        .clk_i,
        .en_i,
        .a_signed_i(1'b1),
        .b_signed_i(1'b0),
        .a_i(a[35:18]),
        .b_i(b[17:0]),
        .product_o(high_low)
    );
  end else begin : g_no_high_low
    assign high_low = 36'd0;
  end

  if (ABits > 18) begin : g_low_high
    dsp_ecp5 u_low_high (
        .clk_i,
        .en_i,
        .a_signed_i(1'b0),
        .b_signed_i(1'b1),
        .a_i(a[17:0]),
        .b_i(b[35:18]),
        .product_o(low_high)
    );
  end else begin : g_no_low_high
    assign low_high = 36'd0;
  end

  if (ABits > 18 && BBits > 18) begin : g_low_low
    dsp_ecp5 u_low_low (
        .clk_i,
        .en_i,
        .a_signed_i(1'b0),
        .b_signed_i(1'b0),
        .a_i(a[17:0]),
        .b_i(b[17:0]),
        .product_o(low_low)
    );
  end else begin : g_no_low_low
    assign low_low = 36'd0;
  end

  product_sum #(
      .ABits(ABits),
      .BBits(BBits),
      .Shift(Shift)
  ) u_sum (
      .clk_i,
      .en_i,
      .high_high_i(high_high),
      .high_low_i (high_low),
      .low_high_i (low_high),
      .low_low_i  (low_low),
      .product_o
  );

endmodule
`default_nettype wire
