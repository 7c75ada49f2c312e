// SPDX-License-Identifier: Apache-2.0
// Product of two signed limbs of 16 bits on one multiplier.
//
//   clock        0         2
//   a_i, b_i     a, b
//   product_o              a b
//
// Form: 0 portable, 1 ECP5 (MULT18X18D), 2 UP5K (SB_MAC16); equal bit for bit.
`default_nettype none
module limb_product #(
    parameter int Form = 0  // 0, 1, 2
) (
    input  wire logic               clk_i,
    input  wire logic signed [15:0] a_i,
    input  wire logic signed [15:0] b_i,
    output logic signed      [31:0] product_o
);

  initial if (Form < 0 || Form > 2) $fatal(1, "Form must be 0, 1 or 2");

  if (Form == 1) begin : g_ecp5
    logic [35:0] product;
    dsp_ecp5 #(
        .PipelineClock("NONE")
    ) u_dsp (
        .clk_i,
        .en_i(1'b1),
        .a_signed_i(1'b1),
        .b_signed_i(1'b1),
        .a_i({{2{a_i[15]}}, a_i}),
        .b_i({{2{b_i[15]}}, b_i}),
        .product_o(product)
    );
    assign product_o = $signed(product[31:0]);
  end else if (Form == 2) begin : g_up5k
    logic [15:0] a;
    logic [15:0] b;
    logic [31:0] product;
    assign a = $unsigned(a_i);
    assign b = $unsigned(b_i);
    dsp_up5k u_dsp (
        .clk_i,
        .en_i(1'b1),
        .a_i(a),
        .b_i(b),
        .product_o(product)
    );
    assign product_o = $signed(product);
  end else begin : g_portable
    logic signed [31:0] a_q;
    logic signed [31:0] b_q;
    always_ff @(posedge clk_i) begin
      a_q       <= 32'(a_i);
      b_q       <= 32'(b_i);
      product_o <= a_q * b_q;
    end
  end

endmodule
`default_nettype wire
