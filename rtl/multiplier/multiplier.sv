// SPDX-License-Identifier: Apache-2.0
// Pipelined signed multiplier with rounding: one product per clock.
//
//     product = floor(a * b / 2^Shift + 1/2)     Shift = 0: the exact product
//
//   cycle      0     1     2     3     4     5
//   a_i, b_i   a, b
//   product_o                                 product     (curvecore_pkg::MultiplierLatency = 5)
//
// en_i = 0 stops every stage.  No reset: a product follows its operands only.
// Form: 0 portable, 1 ECP5 (registered MULT18X18D), 2 UP5K (SB_MAC16); equal bit for bit.
`default_nettype none
module multiplier #(
    parameter int ABits = 36,  // [18, 36]
    parameter int BBits = 36,  // [18, 36]
    parameter int Shift = 0,   // [0, 35]
    parameter int Form  = 0,   // 0, 1 or 2
    parameter int Early = 0    // 1, with Form 0: the product comes a clock earlier
) (
    input  wire logic                                clk_i,
    input  wire logic                                en_i,
    input  wire logic signed [            ABits-1:0] a_i,
    input  wire logic signed [            BBits-1:0] b_i,
    output logic signed      [ABits+BBits-Shift-1:0] product_o
);

  initial if (ABits < 18 || ABits > 36) $fatal(1, "ABits must be in [18, 36]");
  initial if (BBits < 18 || BBits > 36) $fatal(1, "BBits must be in [18, 36]");
  initial if (Shift < 0 || Shift > 35) $fatal(1, "Shift must be in [0, 35]");
  initial if (Form < 0 || Form > 2) $fatal(1, "Form must be 0, 1 or 2");

  // Elaboration must not stop below before the message above is seen.
  localparam int Legal = (ABits >= 18 && ABits <= 36 && BBits >= 18 && BBits <= 36) ? 1 : 0;

  if (Legal == 1 && Form == 0) begin : g_portable
    multiplier_portable #(
        .ABits(ABits),
        .BBits(BBits),
        .Shift(Shift),
        .Early(Early)
    ) u_multiplier (
        .clk_i,
        .en_i,
        .a_i,
        .b_i,
        .product_o
    );
  end else if (Legal == 1 && Form == 1) begin : g_ecp5
    multiplier_ecp5 #(
        .ABits(ABits),
        .BBits(BBits),
        .Shift(Shift)
    ) u_multiplier (
        .clk_i,
        .en_i,
        .a_i,
        .b_i,
        .product_o
    );
  end else if (Legal == 1 && Form == 2) begin : g_up5k
    multiplier_up5k #(
        .ABits(ABits),
        .BBits(BBits),
        .Shift(Shift)
    ) u_multiplier (
        .clk_i,
        .en_i,
        .a_i,
        .b_i,
        .product_o
    );
  end

endmodule
`default_nettype wire
