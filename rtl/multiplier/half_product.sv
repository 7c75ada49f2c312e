// SPDX-License-Identifier: Apache-2.0
// Product of two 18-bit halves of words on one multiplier.
//
//   cycle        0                                3
//   factors_i    {a_signed, b_signed, a, b}
//   product_o                                     a b
//
// Form: 0 portable, 1 ECP5 (registered MULT18X18D); equal bit for bit.
`default_nettype none
module half_product #(
    parameter int Form = 0  // 0, 1
) (
    input  wire logic        clk_i,
    input  wire logic [37:0] factors_i,
    output logic      [35:0] product_o
);

  logic        a_signed;
  logic        b_signed;
  logic [17:0] a;
  logic [17:0] b;
  assign {a_signed, b_signed, a, b} = factors_i;

  if (Form == 1) begin : g_ecp5
    dsp_ecp5 u_dsp (
        .clk_i,
        .en_i(1'b1),
        .a_signed_i(a_signed),
        .b_signed_i(b_signed),
        .a_i(a),
        .b_i(b),
        .product_o
    );
  end else begin : g_portable
    logic signed [18:0] a_input_q;
    logic signed [18:0] b_input_q;
    logic signed [37:0] a_wide;
    logic signed [37:0] b_wide;
    logic signed [37:0] pipeline_q;
    assign a_wide = 38'(a_input_q);
    assign b_wide = 38'(b_input_q);
    always_ff @(posedge clk_i) begin
      a_input_q  <= {a_signed && a[17], a};
      b_input_q  <= {b_signed && b[17], b};
      pipeline_q <= a_wide * b_wide;
      product_o  <= pipeline_q[35:0];
    end
  end

endmodule
`default_nettype wire
