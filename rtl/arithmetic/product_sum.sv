// SPDX-License-Identifier: Apache-2.0
// The sum of a product's four parts, rounded: the last two stages of `multiplier`.
//
//     sum     = high_high 2^36 + (high_low + low_high) 2^18 + low_low      (operands of 36 bits)
//     product = floor(sum / 2^Drop + 1/2),   Drop = (36 - ABits) + (36 - BBits) + Shift
//
//   cycle   0       1                              2
//           parts   outer + rounding, inner sum    product
`default_nettype none
module product_sum #(
    parameter int ABits = 36,  // [18, 36]
    parameter int BBits = 36,  // [18, 36]
    parameter int Shift = 0    // [0, 35]
) (
    input  wire logic                                clk_i,
    input  wire logic                                en_i,
    input  wire logic signed [                 35:0] high_high_i,
    input  wire logic signed [                 35:0] high_low_i,
    input  wire logic signed [                 35:0] low_high_i,
    input  wire logic        [                 35:0] low_low_i,
    output logic signed      [ABits+BBits-Shift-1:0] product_o
);

  // One half of the last bit kept, split like the sum into 54 high and 18 low bits.  With Shift = 0
  // the dropped bits are zero, and there is nothing to round.
  localparam int Drop = 72 - ABits - BBits + Shift;
  localparam logic [53:0] HalfHigh = (Shift > 0 && Drop > 18) ? 54'd1 << (Drop - 19) : 54'd0;
  localparam logic [35:0] HalfLow = (Shift > 0 && Drop <= 18) ? 36'd1 << (Drop - 1) : 36'd0;

  logic signed [36:0] high_low;
  logic signed [36:0] low_high;
  logic        [35:0] low;
  logic        [53:0] outer;
  assign high_low = {high_low_i[35], high_low_i};
  assign low_high = {low_high_i[35], low_high_i};
  assign low      = low_low_i + HalfLow;  // no carry: low_low <= (2^18 - 1)^2, HalfLow <= 2^17
  assign outer    = {high_high_i, low[35:18]};

  logic signed [36:0] inner_q;
  logic        [53:0] outer_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      inner_q <= high_low + low_high;
      outer_q <= outer + HalfHigh;
    end
  end

  logic [53:0] inner;
  logic [53:0] high;
  assign inner = {{17{inner_q[36]}}, inner_q};
  assign high  = outer_q + inner;

  // Drop is at most 71 - 18: the kept bits begin in the low or in the high part.
  if (Drop < 18) begin : g_keep_low
    logic [17:0] low_q;
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        low_q     <= low[17:0];
        product_o <= {high, low_q[17:Drop]};
      end
    end
  end else begin : g_keep_high
    always_ff @(posedge clk_i) begin
      if (en_i) product_o <= high[53:Drop-18];
    end
  end

endmodule
`default_nettype wire
