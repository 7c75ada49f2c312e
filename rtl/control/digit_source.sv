// SPDX-License-Identifier: Apache-2.0
// A weight for digit_multiplier and riemann_integrator: its digits of two bits, lowest first, with
// their control.  Digits = ceil(Bits / 2).
//
//   cycle      0       1      2        3  ..  Digits + 2     Digits + 4
//   start_i    1
//   weight_i   weight                                      0 <= weight < 2^Bits, Bits-1 fraction
//   Take               1                                   of digits_o
//   Triple                    1
//   Step                               1  ..  1
//   Digit                              digits
//   Last                                      1
//   done_o                                                   1    digit_multiplier's product
`default_nettype none
module digit_source #(
    parameter int Bits = 36  // [18, 36]
) (
    input  wire logic                        clk_i,
    input  wire logic                        rst_ni,
    input  wire logic                        start_i,
    input  wire logic [            Bits-1:0] weight_i,
    output logic      [digits_pkg::Bits-1:0] digits_o,
    output logic                             done_o
);

  localparam int Digits = curvecore_pkg::weight_digits(Bits);
  localparam int Shifted = 2 * Digits;

  logic               take_q;
  logic               triple_q;
  logic               step_q;
  logic               digit_last;
  logic               before_last_q;
  logic               settle_q;
  logic [        4:0] count_q;
  logic [Shifted-1:0] weight_q;
  assign digit_last = step_q && before_last_q;
  assign digits_o   = {take_q, triple_q, step_q, digit_last, weight_q[1:0]};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      take_q   <= 1'b0;
      triple_q <= 1'b0;
      step_q   <= 1'b0;
      settle_q <= 1'b0;
      done_o   <= 1'b0;
    end else begin
      take_q   <= start_i;
      triple_q <= take_q;
      step_q   <= triple_q || (step_q && !digit_last);
      settle_q <= digit_last;
      done_o   <= settle_q;
    end
  end
  always_ff @(posedge clk_i) begin
    before_last_q <= step_q && count_q == 5'd1;
    count_q       <= step_q ? count_q - 5'd1 : 5'(Digits - 1);
    if (start_i) weight_q <= {weight_i, {(Shifted - Bits) {1'b0}}};
    else if (step_q) weight_q <= {2'b00, weight_q[Shifted-1:2]};
  end

endmodule
`default_nettype wire
