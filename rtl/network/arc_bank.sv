// SPDX-License-Identifier: Apache-2.0
// Words of a step along a line, arc or helix for its bank (rtl/sampler/bank_pkg.sv).
//
//   Mode 0   c_1 = x[1] + rate, c_i = x[i]: X Y Z of place i, two clocks after collect_i
//   Mode 1   at once: n and t with zeroth_i, X Y Z and F G H; the angle's terms with collect_i, Own
//
// With Mode 1 write_o always names the step's bank.
`default_nettype none
module arc_bank #(
    parameter int CoefBits = 36,  // [18, 36]
    parameter int Mode     = 0    // 0 series, 1 polynomial
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic [           1:0] bank_i,
    input wire logic [  CoefBits+4:0] rate_i,     // {there, axis, rate}, before order 1
    input wire logic                  zeroth_i,
    input wire logic                  collect_i,
    input wire logic [           3:0] order_i,
    input wire logic [3*CoefBits-1:0] xyz_i,
    input wire logic [3*CoefBits-1:0] fgh_i,
    input wire logic [  CoefBits-1:0] angle_i,

    output logic [          bank_pkg::Bits-1:0] write_o,
    output logic [bank_pkg::Lanes*CoefBits-1:0] words_o
);

  if (Mode == 0) begin : g_series
    logic unused;
    assign unused = &{zeroth_i, fgh_i, angle_i};

    // Two clocks: register, add.
    logic       collect_q;
    logic       write_q;
    logic [1:0] bank_q;
    logic [1:0] write_bank_q;
    logic [3:0] order_q;
    logic [3:0] write_order_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        collect_q <= 1'b0;
        write_q   <= 1'b0;
      end else begin
        collect_q <= collect_i;
        write_q   <= collect_q;
      end
    end
    always_ff @(posedge clk_i) begin
      if (collect_i) begin
        bank_q  <= bank_i;
        order_q <= order_i;
      end
      if (collect_q) begin
        write_bank_q  <= bank_q;
        write_order_q <= order_q;
      end
    end
    for (genvar a = 0; a < 3; a++) begin : g_axis
      logic signed [CoefBits-1:0] rate_q;
      logic signed [CoefBits-1:0] x_q;
      logic signed [CoefBits-1:0] linear_q;
      logic signed [CoefBits-1:0] c_q;
      always_ff @(posedge clk_i) begin
        if (rate_i[CoefBits+4] && rate_i[CoefBits+:4] == 4'(a)) rate_q <= rate_i[CoefBits-1:0];
        if (collect_i) begin
          x_q      <= xyz_i[a*CoefBits+:CoefBits];
          linear_q <= (order_i == 4'd1) ? rate_q : '0;
        end
        if (collect_q) c_q <= x_q + linear_q;
      end
      assign words_o[a*CoefBits+:CoefBits] = c_q;
    end
    assign words_o[bank_pkg::Lanes*CoefBits-1:3*CoefBits] = '0;
    assign write_o = {4'b0000, {3{write_q}}, 4'd0, write_order_q, write_bank_q};
  end else begin : g_polynomial
    logic unused;
    assign unused  = &{rst_ni, clk_i, rate_i};
    assign words_o = {fgh_i, angle_i, xyz_i};
    assign write_o = {{3{zeroth_i}}, collect_i, {3{zeroth_i}}, order_i, 4'd0, bank_i};
  end

endmodule
`default_nettype wire
