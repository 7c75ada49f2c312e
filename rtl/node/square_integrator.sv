// SPDX-License-Identifier: Apache-2.0
// The node  R = -Gain phi^2: the integral of -2 Gain phi dphi. Gain 3 is the spline's R, [Chikurov]
// (30); the paper's recurrence of R_i lacks the 6. Gain 1 is the hyperbola's z, Fig. 3. The sum of
// products is that of the square:
//
//     S[i] = sum of phi[j] phi[i-j], j = 0 .. i        R[i] = -3 S[i], or -S[i]
//
// Terms are {there, order, coefficient}.
//
//   cycle              0     4(i+1)+9
//   Start, Order       1                and phi[i] or before
//   r_o                      R[i], kept
//   Load, Again                         a clock later R[0] = initial_i, or state_o
//
// With Gain 3 S has Bits - 3 fraction bits, R two less, phi Bits - 2. With Gain 1 all have Bits.
`default_nettype none
module square_integrator #(
    parameter int Bits = 36,  // [18, 36]
    parameter int Gain = 3,   // 1, 3
    parameter int Own  = 1,   // 0, 1: as folded_sum's, with factors_o and product_i
    parameter int Form = 0    // 0 portable, 1 ECP5
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic        [series_pkg::Bits-1:0] control_i,
    input wire logic signed [            Bits-1:0] initial_i,

    input  wire logic   [Bits+4:0] phi_i,
    output logic        [Bits+4:0] r_o,
    output logic signed [Bits-1:0] state_o, // R[0] + .. + R[i], a clock after r_o

    output logic      [37:0] factors_o,
    input  wire logic [35:0] product_i
);

  initial if (Gain != 1 && Gain != 3) $fatal(1, "Gain must be 1 or 3");

  logic                   phi_there;
  logic        [     3:0] phi_order;
  logic signed [Bits-1:0] phi;
  logic                   square_there;
  logic                   unused_quotient;
  logic        [     3:0] order;
  logic signed [Bits-1:0] square;
  assign {phi_there, phi_order, phi} = phi_i;
  series_product #(
      .Bits(Bits),
      .Shift((Gain == 3) ? Bits - 1 : Bits),
      .Quotient(0),
      .First(0),
      .Extra(1),
      .Own(Own),
      .Form(Form)
  ) u_product (
      .clk_i,
      .rst_ni,
      .u_write_i(phi_there),
      .u_index_i(phi_order),
      .u_i(phi),
      .s_write_i(phi_there),
      .s_index_i(phi_order),
      .s_i(phi),
      .start_i(control_i[series_pkg::Start]),
      .order_i(control_i[series_pkg::Order+:4]),
      .d_there_o(square_there),
      .x_there_o(unused_quotient),
      .order_o(order),
      .sum_o(square),
      .factors_o,
      .product_i
  );

  // floor(-3 S / 4 + 1/2), or -S, in three clocks.
  logic signed [Bits+1:0] square_wide;
  logic signed [Bits+1:0] square_twice;
  logic signed [Bits+1:0] three_q;
  logic signed [Bits+1:0] minus_three_q;
  logic signed [Bits+1:0] half;
  logic signed [Bits-1:0] r;
  logic                   three_there_q;
  logic                   minus_there_q;
  assign square_wide  = (Bits + 2)'(square);
  assign square_twice = (Gain == 3) ? {square[Bits-1], square, 1'b0} : '0;
  assign half         = (Gain == 3) ? (Bits + 2)'(3'sd2) : '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      three_there_q <= 1'b0;
      minus_there_q <= 1'b0;
    end else begin
      three_there_q <= square_there;
      minus_there_q <= three_there_q;
    end
  end
  always_ff @(posedge clk_i) begin
    three_q       <= square_wide + square_twice;
    minus_three_q <= half - three_q;
  end

  assign r = (Gain == 3) ? minus_three_q[Bits+1:2] : minus_three_q[Bits-1:0];

  series_state #(
      .Bits(Bits)
  ) u_state (
      .clk_i,
      .rst_ni,
      .control_i(control_i[series_pkg::ZerothBits-1:0]),
      .initial_i,
      .x_i({minus_there_q, order, r}),
      .x_o(r_o),
      .state_o
  );

endmodule
`default_nettype wire
