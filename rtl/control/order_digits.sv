// SPDX-License-Identifier: Apache-2.0
// Drives a riemann_integrator with the step size 1: each term u[i-1] of its integrand starts the
// product by 1/i, which comes as digits, Digits = ceil(Bits / 2).  i = 1 .. Last.
//
//   cycle        0         5           Digits + 6
//   there_i      u[i-1]
//   there_o                i = 1       i > 1          x_o = x[i], order_o = i
`default_nettype none
module order_digits #(
    parameter int Bits = 36,  // [18, 36]
    parameter int Last = 12   // [1, 12]
) (
    input  wire logic                                  clk_i,
    input  wire logic                                  rst_ni,
    input  wire logic                                  there_i,
    input  wire logic [                           3:0] order_i,    // i - 1
    output logic      [riemann_pkg::ExpansionBits-1:0] control_o,
    output logic                                       there_o,
    output logic      [                           3:0] order_o
);

  logic [35:0] reciprocal[16];
  for (genvar i = 0; i < 16; i++) begin : g_reciprocal
    if (i >= 1 && i <= 12) begin : g_used
      assign reciprocal[i] = curvecore_pkg::reciprocal(Bits - 1, i);
    end else begin : g_unused
      assign reciprocal[i] = '0;
    end
  end

  logic [3:0] order;
  logic [35:0] weight;
  logic start_q;
  logic [3:0] order_q;
  logic [Bits-1:0] weight_q;
  assign order  = order_i + 4'd1;
  assign weight = reciprocal[order];
  always_ff @(posedge clk_i) begin
    start_q  <= rst_ni && there_i && order_i < 4'(Last);
    order_q  <= order;
    weight_q <= weight[Bits-1:0];
  end

  logic [digits_pkg::Bits-1:0] digits;
  logic                        done;
  digit_source #(
      .Bits(Bits)
  ) u_digits (
      .clk_i,
      .rst_ni,
      .start_i (start_q),
      .weight_i(weight_q),
      .digits_o(digits),
      .done_o  (done)
  );

  // Order 1 needs no product.
  logic first_q;
  logic collect;
  assign collect   = first_q || (done && order_o != 4'd1);
  assign control_o = {first_q, collect, 3'b000, digits};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      first_q <= 1'b0;
      there_o <= 1'b0;
    end else begin
      first_q <= digits[digits_pkg::Triple] && order_o == 4'd1;
      there_o <= collect;
    end
  end
  always_ff @(posedge clk_i) if (start_q) order_o <= order_q;

endmodule
`default_nettype wire
