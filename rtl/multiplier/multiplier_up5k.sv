// SPDX-License-Identifier: Apache-2.0
// UP5K form of `multiplier`: SB_MAC16 multiplies 16 x 16 bits, so an operand has two parts up to 32
// bits (four primitives) and three above (eight, all that a UP5K has; the product of the two lowest
// parts, 4 x 4 bits at most, is made of logic).
//
//   cycle   1           2            3                   4                 5
//           DSP input   DSP output   pairs of products   sums of pairs     product
`default_nettype none
module multiplier_up5k #(
    parameter int ABits = 36,  // [18, 36]
    parameter int BBits = 36,  // [18, 36]
    parameter int Shift = 0    // [0, 35]
) (
    input  wire logic                                clk_i,
    input  wire logic                                en_i,
    input  wire logic signed [            ABits-1:0] a_i,
    input  wire logic signed [            BBits-1:0] b_i,
    output logic signed      [ABits+BBits-Shift-1:0] product_o
);

  // Operands as fractions of 48 bits: signed high part, unsigned middle and low parts.
  logic [47:0] a;
  logic [47:0] b;
  assign a = {a_i, {(48 - ABits) {1'b0}}};
  assign b = {b_i, {(48 - BBits) {1'b0}}};

  localparam int Drop = 96 - ABits - BBits + Shift;
  localparam logic [95:0] Half = (Shift > 0) ? 96'd1 << (Drop - 1) : 96'd0;

  // p<i><j> = part i of a times part j of b, weight 2^(16 (i + j)); part 2 is the high one.
  logic [31:0] p22;
  logic [31:0] p21;
  logic [31:0] p12;
  logic [31:0] p11;
  logic [31:0] p20;
  logic [31:0] p02;
  logic [31:0] p10;
  logic [31:0] p01;
  logic [31:0] p00;

  dsp_up5k #(
      .ASigned(1),
      .BSigned(1)
  ) u_p22 (
      .clk_i,
      .en_i,
      .a_i(a[47:32]),
      .b_i(b[47:32]),
      .product_o(p22)
  );

  dsp_up5k #(
      .ASigned(1),
      .BSigned(0)
  ) u_p21 (
      .clk_i,
      .en_i,
      .a_i(a[47:32]),
      .b_i(b[31:16]),
      .product_o(p21)
  );

  dsp_up5k #(
      .ASigned(0),
      .BSigned(1)
  ) u_p12 (
      .clk_i,
      .en_i,
      .a_i(a[31:16]),
      .b_i(b[47:32]),
      .product_o(p12)
  );

  dsp_up5k #(
      .ASigned(0),
      .BSigned(0)
  ) u_p11 (
      .clk_i,
      .en_i,
      .a_i(a[31:16]),
      .b_i(b[31:16]),
      .product_o(p11)
  );

  if (BBits > 32) begin : g_p20
    dsp_up5k #(
        .ASigned(1),
        .BSigned(0)
    ) u_p20 (
        .clk_i,
        .en_i,
        .a_i(a[47:32]),
        .b_i(b[15:0]),
        .product_o(p20)
    );
  end else begin : g_no_p20
    assign p20 = 32'd0;
  end

  if (ABits > 32) begin : g_p02
    dsp_up5k #(
        .ASigned(0),
        .BSigned(1)
    ) u_p02 (
        .clk_i,
        .en_i,
        .a_i(a[15:0]),
        .b_i(b[47:32]),
        .product_o(p02)
    );
  end else begin : g_no_p02
    assign p02 = 32'd0;
  end

  if (BBits > 32) begin : g_p10
    dsp_up5k #(
        .ASigned(0),
        .BSigned(0)
    ) u_p10 (
        .clk_i,
        .en_i,
        .a_i(a[31:16]),
        .b_i(b[15:0]),
        .product_o(p10)
    );
  end else begin : g_no_p10
    assign p10 = 32'd0;
  end

  if (ABits > 32) begin : g_p01
    dsp_up5k #(
        .ASigned(0),
        .BSigned(0)
    ) u_p01 (
        .clk_i,
        .en_i,
        .a_i(a[15:0]),
        .b_i(b[31:16]),
        .product_o(p01)
    );
  end else begin : g_no_p01
    assign p01 = 32'd0;
  end

  logic [15:0] a_low_q;
  logic [15:0] b_low_q;
  logic [31:0] a_low;
  logic [31:0] b_low;
  assign a_low = {16'd0, a_low_q};
  assign b_low = {16'd0, b_low_q};
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      a_low_q <= a[15:0];
      b_low_q <= b[15:0];
      p00     <= a_low * b_low;
    end
  end

  // Products that do not overlap stand side by side; the others are added in pairs.
  logic        [95:0] apart;
  logic signed [32:0] p21_wide;
  logic signed [32:0] p12_wide;
  logic signed [32:0] p20_wide;
  logic signed [32:0] p02_wide;
  logic        [32:0] p10_wide;
  logic        [32:0] p01_wide;
  assign apart    = {p22, p11, p00};
  assign p21_wide = {p21[31], p21};
  assign p12_wide = {p12[31], p12};
  assign p20_wide = {p20[31], p20};
  assign p02_wide = {p02[31], p02};
  assign p10_wide = {1'b0, p10};
  assign p01_wide = {1'b0, p01};

  logic        [95:0] apart_q;
  logic signed [32:0] pair3_q;
  logic signed [32:0] pair2_q;
  logic        [32:0] pair1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      apart_q <= apart + Half;
      pair3_q <= p21_wide + p12_wide;
      pair2_q <= p20_wide + p02_wide;
      pair1_q <= p10_wide + p01_wide;
    end
  end

  logic [63:0] pair3;
  logic [63:0] pair2;
  logic [95:0] pair1;
  assign pair3 = {{15{pair3_q[32]}}, pair3_q, 16'd0};
  assign pair2 = {{31{pair2_q[32]}}, pair2_q};
  assign pair1 = {47'd0, pair1_q, 16'd0};

  logic [95:0] outer_q;
  logic [63:0] inner_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      outer_q <= apart_q + pair1;
      inner_q <= pair3 + pair2;
    end
  end

  logic [95:0] inner;
  logic [95:0] sum;
  assign inner = {inner_q, 32'd0};
  assign sum   = outer_q + inner;
  always_ff @(posedge clk_i) begin
    if (en_i) product_o <= sum[95:Drop];
  end

endmodule
`default_nettype wire
