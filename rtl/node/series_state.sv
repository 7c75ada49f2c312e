// SPDX-License-Identifier: Apache-2.0
// The terms of a node's series, {there, order, coefficient}, and their sum, the node's state at the
// end of the step.  A term of order 0 begins the sum, wherever it comes from.
//
//   cycle      0                       1
//   x_i        x[i], there             x_o = x[i], kept until the next
//   Load       1, initial_i = x[0]     x_o = x[0]
//   Again      1                       x_o = x[0] = state_o
//
// Reset acts a clock late, in a register beside the node: nothing may come in the clock after it.
`default_nettype none
module series_state #(
    parameter int Bits = 36  // [18, 36]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic [series_pkg::ZerothBits-1:0] control_i,
    input wire logic signed [Bits-1:0] initial_i,
    input wire logic [Bits+4:0] x_i,
    output logic [Bits+4:0] x_o,
    output logic signed [Bits-1:0] state_o  // x[0] + .. + x[i], a clock after x_o
);

  logic                   reset_n;
  logic                   there_q;
  logic                   zeroth_q;
  logic        [     3:0] order_q;
  logic signed [Bits-1:0] x_q;
  logic                   zeroth;
  logic                   zeroth_term;
  logic signed [Bits-1:0] start;
  local_copy u_reset (
      .clk_i,
      .data_i(rst_ni),
      .data_o(reset_n)
  );
  assign zeroth = control_i[series_pkg::Load] || control_i[series_pkg::Again];
  assign zeroth_term = zeroth || x_i[Bits+3:Bits] == 4'd0;
  assign start  = control_i[series_pkg::Again] ? state_o : initial_i;
  assign x_o    = {there_q, order_q, x_q};
  always_ff @(posedge clk_i) begin
    if (!reset_n) there_q <= 1'b0;
    else there_q <= x_i[Bits+4] || zeroth;
  end
  always_ff @(posedge clk_i) begin
    if (x_i[Bits+4] || zeroth) begin
      zeroth_q <= zeroth_term;
      order_q  <= zeroth ? 4'd0 : x_i[Bits+3:Bits];
      x_q      <= zeroth ? start : x_i[Bits-1:0];
    end
    if (there_q) state_o <= zeroth_q ? x_q : state_o + x_q;
  end

endmodule
`default_nettype wire
