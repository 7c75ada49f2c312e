// SPDX-License-Identifier: Apache-2.0
// A weight for digit_multiplier and riemann_integrator: its digits of two bits, lowest first, with
// the control that goes with them.  Digits = ceil(Bits / 2).
//
//   cycle      0       1      2        3  ..  Digits + 2     Digits + 4
//   start_i    1
//   weight_i   weight                                      0 <= weight < 2^Bits, Bits-1 fraction
//   take_o             1
//   triple_o                  1
//   step_o                             1  ..  1
//   digit_o                            digits
//   last_o                                    1
//   done_o                                                   1    digit_multiplier's product
`default_nettype none
module digit_source #(
    parameter int Bits = 36  // [18, 36]
) (
    input  wire logic            clk_i,
    input  wire logic            rst_ni,
    input  wire logic            start_i,
    input  wire logic [Bits-1:0] weight_i,
    output logic                 take_o,
    output logic                 triple_o,
    output logic                 step_o,
    output logic                 last_o,
    output logic      [     1:0] digit_o,
    output logic                 done_o
);

  localparam int Digits = curvecore_pkg::weight_digits(Bits);
  localparam int Shifted = 2 * Digits;

  logic               digit_last;
  logic               before_last_q;
  logic               settle_q;
  logic [        4:0] count_q;
  logic [Shifted-1:0] weight_q;
  assign digit_last = step_o && before_last_q;
  assign last_o     = digit_last;
  assign digit_o    = weight_q[1:0];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      take_o   <= 1'b0;
      triple_o <= 1'b0;
      step_o   <= 1'b0;
      settle_q <= 1'b0;
      done_o   <= 1'b0;
    end else begin
      take_o   <= start_i;
      triple_o <= take_o;
      step_o   <= triple_o || (step_o && !digit_last);
      settle_q <= digit_last;
      done_o   <= settle_q;
    end
  end
  always_ff @(posedge clk_i) begin
    before_last_q <= step_o && count_q == 5'd1;
    count_q       <= step_o ? count_q - 5'd1 : 5'(Digits - 1);
    if (start_i) weight_q <= {weight_i, {(Shifted - Bits) {1'b0}}};
    else if (step_o) weight_q <= {2'b00, weight_q[Shifted-1:2]};
  end

endmodule
`default_nettype wire
