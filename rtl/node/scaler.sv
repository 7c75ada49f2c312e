// SPDX-License-Identifier: Apache-2.0
// Scaler: the node  W = W(0) + g q  of a Shannon network, one order of the series after the other:
//
//     W[i] = floor(g q[i] / 2^(Bits-2) + 1/2)
//
// q comes digit after digit from word_digits, which several scalers share.
//
//   cycle      0        Digits + 5
//   digits_i   Take
//   w_o                 W[i], {there, order, coefficient}, kept until the next
//   load_i     Load, Again               a clock later W[0] = initial_i, or state_o
//              Gain                      g <- initial_i
`default_nettype none
module scaler #(
    parameter int Bits = 36  // [18, 36]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Initial condition
    input wire logic        [scaler_pkg::LoadBits-1:0] load_i,
    input wire logic signed [                Bits-1:0] initial_i,

    input wire logic [scaler_pkg::DigitsBits-1:0] digits_i,
    output logic [Bits+4:0] w_o,
    output logic signed [Bits-1:0] state_o  // W[0] + .. + W[i], a clock after w_o
);

  logic [scaler_pkg::DigitsBits-1:0] digits;
  local_copy #(
      .Bits(scaler_pkg::DigitsBits)
  ) u_control (
      .clk_i,
      .data_i(digits_i),
      .data_o(digits)
  );
  logic signed [Bits-1:0] gain_q;
  logic signed [Bits-1:0] minus_gain;
  logic signed [Bits-1:0] multiplicand;
  logic signed [Bits-1:0] unused_base;
  logic signed [Bits-1:0] product;
  assign minus_gain   = -gain_q;
  assign multiplicand = digits[scaler_pkg::Negative] ? minus_gain : gain_q;
  always_ff @(posedge clk_i) if (load_i[scaler_pkg::Gain]) gain_q <= initial_i;

  digit_multiplier #(
      .Bits(Bits)
  ) u_multiplier (
      .clk_i,
      .digits_i(digits[digits_pkg::Bits-1:0]),
      .a_i(multiplicand),
      .base_o(unused_base),
      .product_o(product)
  );

  // A control word is not reset on its way: it ends by itself.
  series_state #(
      .Bits(Bits)
  ) u_state (
      .clk_i,
      .rst_ni,
      .control_i(load_i[series_pkg::ZerothBits-1:0]),
      .initial_i,
      .x_i({digits[scaler_pkg::Done], digits[scaler_pkg::Order+:4], product}),
      .x_o(w_o),
      .state_o
  );

endmodule
`default_nettype wire
