// SPDX-License-Identifier: Apache-2.0
// The three products of an axis on the fewest multipliers that the sample interval allows: exact,
// curvecore_pkg::MultiplierLatency clocks after their factors.
//
//   SampleInterval   multipliers
//   1                t sine | n versine | rate tau
//   2                t sine, rate tau | n versine
//   4, 8             all three on one
//
// The phase inputs state whose factors are present; by default rate and tau.
`default_nettype none
module polynomial_products #(
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int SampleInterval = 1,   // 1, 2, 4, 8
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,

    input wire logic                       sine_phase_i,
    input wire logic                       versine_phase_i,
    input wire logic signed [CoefBits-1:0] tangent_i,
    input wire logic signed [CoefBits-1:0] sine_i,
    input wire logic signed [CoefBits-1:0] normal_i,
    input wire logic signed [CoefBits-1:0] versine_i,
    input wire logic signed [CoefBits-1:0] rate_i,
    input wire logic signed [CoefBits-1:0] tau_i,

    output logic signed [2*CoefBits-1:0] sine_product_o,
    output logic signed [2*CoefBits-1:0] versine_product_o,
    output logic signed [2*CoefBits-1:0] tau_product_o
);

  // Multiplier 0 has the sine, the last one tau.
  logic signed [CoefBits-1:0] a;
  logic signed [CoefBits-1:0] b;
  always_comb begin
    a = rate_i;
    b = tau_i;
    if (SampleInterval == 1 || sine_phase_i) begin
      a = tangent_i;
      b = sine_i;
    end else if (SampleInterval > 2 && versine_phase_i) begin
      a = normal_i;
      b = versine_i;
    end
  end

  multiplier #(
      .ABits(CoefBits),
      .BBits(CoefBits),
      .Shift(0),
      .Form (MultiplierForm)
  ) u_first (
      .clk_i,
      .en_i(1'b1),
      .a_i(a),
      .b_i(b),
      .product_o(sine_product_o)
  );

  if (SampleInterval > 2) begin : g_one
    assign versine_product_o = sine_product_o;
  end else begin : g_two
    multiplier #(
        .ABits(CoefBits),
        .BBits(CoefBits),
        .Shift(0),
        .Form (MultiplierForm)
    ) u_versine (
        .clk_i,
        .en_i(1'b1),
        .a_i(normal_i),
        .b_i(versine_i),
        .product_o(versine_product_o)
    );
  end

  if (SampleInterval > 1) begin : g_shared
    assign tau_product_o = sine_product_o;
  end else begin : g_three
    multiplier #(
        .ABits(CoefBits),
        .BBits(CoefBits),
        .Shift(0),
        .Form (MultiplierForm)
    ) u_tau (
        .clk_i,
        .en_i(1'b1),
        .a_i(rate_i),
        .b_i(tau_i),
        .product_o(tau_product_o)
    );
  end

endmodule
`default_nettype wire
