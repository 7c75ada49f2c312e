// SPDX-License-Identifier: Apache-2.0
// Drives a riemann_integrator with the step size 1: each term u[i-1] of its integrand starts the
// product by 1/i, which comes as digits, Digits = ceil(Bits / 2).  i = 1 .. Last.
//
//   cycle        0         5           Digits + 6
//   there_i      u[i-1]
//   there_o                i = 1       i > 1          coef_o = x[i], order_o = i
//
// The other ports are riemann_integrator's, of the same names.
`default_nettype none
module order_digits #(
    parameter int Bits = 36,  // [18, 36]
    parameter int Last = 12   // [1, 12]
) (
    input  wire logic       clk_i,
    input  wire logic       rst_ni,
    input  wire logic       there_i,
    input  wire logic [3:0] order_i,    // i - 1
    output logic            take_o,
    output logic            triple_o,
    output logic            step_o,
    output logic            last_o,
    output logic      [1:0] digit_o,
    output logic            collect_o,
    output logic            first_o,
    output logic            there_o,
    output logic      [3:0] order_o
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

  logic done;
  digit_source #(
      .Bits(Bits)
  ) u_digits (
      .clk_i,
      .rst_ni,
      .start_i (start_q),
      .weight_i(weight_q),
      .take_o,
      .triple_o,
      .step_o,
      .last_o,
      .digit_o,
      .done_o  (done)
  );

  // Order 1 needs no product.
  assign collect_o = first_o || (done && order_o != 4'd1);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      first_o <= 1'b0;
      there_o <= 1'b0;
    end else begin
      first_o <= triple_o && order_o == 4'd1;
      there_o <= collect_o;
    end
  end
  always_ff @(posedge clk_i) if (start_q) order_o <= order_q;

endmodule
`default_nettype wire
