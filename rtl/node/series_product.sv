// SPDX-License-Identifier: Apache-2.0
// One order of a Stieltjes integral: the series of its integrand and of its integrating variable,
// kept as their orders come, multiplied on one 18 x 18 multiplier, rounded once; then the quotient
// by the order, rounded once more.
//
//     D = floor(sum of u[j] s[First + n-1 - j], j = 0 .. n-1, / 2^Shift + 1/2),   n = order + Extra
//     X = floor(D (2^(Bits-1) / order) / 2^QuotientShift + 1/2)
//
//   cycle              0      2 .. 4n+1     4n+6           4n+14
//   start_i, order_i   1
//                             u, s read
//   d_there_o                               1
//   x_there_o                                              1 (Quotient = 1)
//   sum_o                                   D, 5 clocks    X, until the next one's 4n+5
//
// There are four passes of n clocks each.  u[n-1] and s[First] are read first, u[0] and
// s[First+n-1] last: a word written in cycle c may be read in c+1, so the newest s in cycle n+1.
// Reset acts as series_state's.  Twin: hls/curves/curve_steps.hpp.
`default_nettype none
module series_product #(
    parameter int Bits          = 36,  // [18, 36]
    parameter int Shift         = 35,  // [1, 40]
    parameter int QuotientShift = 35,  // [1, 40]
    parameter int Quotient      = 1,   // 0: D only
    parameter int First         = 1,   // 0, 1
    parameter int Extra         = 0,   // 0, 1
    parameter int Own           = 1,   // 0, 1: as folded_sum's, with factors_o and product_i
    parameter int Form          = 0    // 0 portable, 1 ECP5
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic                   u_write_i,
    input wire logic        [     3:0] u_index_i,
    input wire logic signed [Bits-1:0] u_i,
    input wire logic                   s_write_i,
    input wire logic        [     3:0] s_index_i,
    input wire logic signed [Bits-1:0] s_i,

    input  wire logic              start_i,
    input  wire logic   [     3:0] order_i,
    output logic                   d_there_o,
    output logic                   x_there_o,
    output logic        [     3:0] order_o,
    output logic signed [Bits-1:0] sum_o,

    output logic      [37:0] factors_o,
    input  wire logic [35:0] product_i
);

  logic signed [Bits-1:0] u_memory[16];
  logic signed [Bits-1:0] s_memory[16];
  always_ff @(posedge clk_i) begin
    if (u_write_i) u_memory[u_index_i] <= u_i;
    if (s_write_i) s_memory[s_index_i] <= s_i;
  end

  // Passes: j falls, k rises.  The quotient is a sum of one product.
  logic       run_q;
  logic       divide_q;
  logic [1:0] part_q;
  logic       begin_q;  // a pass begins
  logic [3:0] top_q;
  logic [3:0] j_q;
  logic [3:0] k_q;
  logic       reset_n;
  logic       start_q;  // a clock late, beside the words that it starts
  logic       load_q;  // start_q or divide
  logic [3:0] start_order_q;
  logic [3:0] start_top_q;
  logic       pass_end;
  logic       run_end;
  logic       divide;
  logic       divide_next;
  logic [3:0] top;
  local_copy u_reset (
      .clk_i,
      .data_i(rst_ni),
      .data_o(reset_n)
  );
  assign pass_end = j_q == 4'd0;
  assign run_end  = run_q && pass_end && part_q == 2'd3;
  assign top      = (Extra != 0) ? order_i : order_i - 4'd1;
  always_ff @(posedge clk_i) begin
    if (!reset_n) begin
      start_q <= 1'b0;
      load_q  <= 1'b0;
      run_q   <= 1'b0;
    end else begin
      start_q <= start_i;
      load_q  <= start_i || divide_next;
      if (load_q) run_q <= 1'b1;
      else if (run_end) run_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    start_order_q <= order_i;
    start_top_q   <= top;
    if (load_q) begin
      divide_q <= divide;
      part_q   <= 2'd0;
      begin_q  <= 1'b1;
      top_q    <= start_q ? start_top_q : 4'd0;
      j_q      <= start_q ? start_top_q : 4'd0;
      k_q      <= 4'(First);
    end else begin
      begin_q <= pass_end;
      j_q     <= pass_end ? top_q : j_q - 4'd1;
      k_q     <= pass_end ? 4'(First) : k_q + 4'd1;
      if (pass_end) part_q <= part_q + 2'd1;
    end
    if (start_q) order_o <= start_order_q;
  end

  // Clocks since the last product of a sum entered.
  logic [4:0] d_q;
  logic [4:0] x_q;
  assign divide      = (Quotient != 0) && d_q[3];
  assign divide_next = (Quotient != 0) && d_q[2];
  assign d_there_o   = d_q[4];
  assign x_there_o   = x_q[4];
  always_ff @(posedge clk_i) begin
    if (!reset_n) begin
      d_q <= 5'd0;
      x_q <= 5'd0;
    end else begin
      d_q <= {d_q[3:0], run_end && !divide_q};
      x_q <= {x_q[3:0], run_end && divide_q};
    end
  end

  logic [35:0] reciprocal[16];
  for (genvar i = 0; i < 16; i++) begin : g_reciprocal
    if (i >= 1 && i <= 12) begin : g_used
      assign reciprocal[i] = curvecore_pkg::reciprocal(Bits - 1, i);
    end else begin : g_unused
      assign reciprocal[i] = '0;
    end
  end
  logic [    35:0] reciprocal_now;
  logic [Bits-1:0] reciprocal_q;
  assign reciprocal_now = reciprocal[order_o];
  always_ff @(posedge clk_i) reciprocal_q <= reciprocal_now[Bits-1:0];

  logic signed [Bits-1:0] a;
  logic signed [Bits-1:0] b;
  logic                   first;
  logic                   drop;
  logic signed [Bits-1:0] narrow_sum;
  assign a     = divide_q ? narrow_sum : u_memory[j_q];
  assign b     = divide_q ? reciprocal_q : s_memory[k_q];
  assign first = begin_q && part_q == 2'd0;
  assign drop  = begin_q && part_q[0];
  folded_multiplier #(
      .Bits(Bits),
      .NarrowShift(Shift),
      .WideShift(QuotientShift),
      .Own(Own),
      .Form(Form)
  ) u_multiplier (
      .clk_i,
      .valid_i(run_q),
      .part_i(part_q),
      .first_i(first),
      .drop_i(drop),
      .wide_i(divide_q),
      .unsigned_i(divide_q),
      .a_i(a),
      .b_i(b),
      .narrow_sum_o(narrow_sum),
      .sum_o,
      .factors_o,
      .product_i
  );

endmodule
`default_nettype wire
