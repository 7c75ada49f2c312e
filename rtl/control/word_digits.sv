// SPDX-License-Identifier: Apache-2.0
// The terms of a series, {there, order, coefficient}, for scalers: the digits of twice the
// coefficient's magnitude and its sign.  The orders above Last are not used.
//
//   cycle      0      2                         3 .. Digits + 5
//   q_i        q[i]
//   digits_o          Take, Negative, Order     the rest as digit_source; these two are kept
`default_nettype none
module word_digits #(
    parameter int Bits = 36,  // [18, 36]
    parameter int Last = 12   // [0, 12]
) (
    input  wire logic                              clk_i,
    input  wire logic                              rst_ni,
    input  wire logic [                  Bits+4:0] q_i,
    output logic      [scaler_pkg::DigitsBits-1:0] digits_o
);

  logic        [Bits+4:0] q_q;
  logic                   there;
  logic                   start;
  logic        [     3:0] order;
  logic signed [Bits-1:0] q;
  logic signed [Bits-1:0] minus_q;
  logic signed [Bits-1:0] magnitude;
  assign {there, order, q} = q_q;
  assign start             = there && order <= 4'(Last);
  assign minus_q           = -q;
  assign magnitude         = q[Bits-1] ? minus_q : q;

  logic [digits_pkg::Bits-1:0] digits;
  logic                        done;
  digit_source #(
      .Bits(Bits)
  ) u_digits (
      .clk_i,
      .rst_ni,
      .start_i (start),
      .weight_i({magnitude[Bits-2:0], 1'b0}),
      .digits_o(digits),
      .done_o  (done)
  );

  logic       negative_q;
  logic [3:0] order_q;
  assign digits_o = {order_q, negative_q, done, digits};
  always_ff @(posedge clk_i) begin
    q_q <= q_i;
    if (start) begin
      negative_q <= q[Bits-1];
      order_q    <= order;
    end
  end

endmodule
`default_nettype wire
