// SPDX-License-Identifier: Apache-2.0
// One axis of r0 cos + f0 sin: the displacement from the sine and versine of the angle,
//
//     rate = advance + floor(t sine / 2^Frac + 1/2)                            Frac = CoefBits - 2
//     d    = floor(n versine / 2^Frac + 1/2) + floor(rate tau / 2^(Frac+1) + 1/2)
//
// with ceil(3 / SampleInterval) multipliers.  A rounding is half a bit of the adder that follows.
//
//   clock             0        6           7             6 + Offset           12 + Offset
//   *_bank_i          tangent  advance     normal: 5 + Offset
//   sine_i            of 1 clock later: 1
//   versine_i                              at Offset
//   tau_i                                                at 1 + Offset
//   d_o                                                                       d
//
// Offset is 6, with SampleInterval = 2 it is 7: products on one multiplier fall into different
// phases.  `sine_phase_i`: the clock of sine_i; `versine_phase_i`: that of versine_i.
`default_nettype none
module polynomial_axis #(
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int SampleInterval = 1,   // 1, 2, 4, 8
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,

    // Words of the network, into a bank
    input wire logic        [         1:0] bank_i,
    input wire logic                       advance_write_i,
    input wire logic signed [CoefBits-1:0] advance_i,
    input wire logic                       normal_write_i,
    input wire logic signed [CoefBits-1:0] normal_i,
    input wire logic                       tangent_write_i,
    input wire logic signed [CoefBits-1:0] tangent_i,

    // Samples
    input  wire logic        [         1:0] tangent_bank_i,
    input  wire logic        [         1:0] advance_bank_i,
    input  wire logic        [         1:0] normal_bank_i,
    input  wire logic                       sine_phase_i,
    input  wire logic                       versine_phase_i,
    input  wire logic signed [CoefBits-1:0] sine_i,
    input  wire logic signed [CoefBits-1:0] versine_i,
    input  wire logic signed [CoefBits-1:0] tau_i,
    output logic signed      [CoefBits-1:0] d_o
);

  logic signed [CoefBits-1:0] advance_memory[4];
  logic signed [CoefBits-1:0] normal_memory [4];
  logic signed [CoefBits-1:0] tangent_memory[4];
  always_ff @(posedge clk_i) begin
    if (advance_write_i) advance_memory[bank_i] <= advance_i;
    if (normal_write_i) normal_memory[bank_i] <= normal_i;
    if (tangent_write_i) tangent_memory[bank_i] <= tangent_i;
  end

  logic signed [CoefBits-1:0] normal_q;
  logic signed [CoefBits-1:0] tangent_q;
  always_ff @(posedge clk_i) begin
    normal_q  <= normal_memory[normal_bank_i];
    tangent_q <= tangent_memory[tangent_bank_i];
  end

  logic signed [  CoefBits-1:0] rate;
  logic signed [2*CoefBits-1:0] sine_product;
  logic signed [2*CoefBits-1:0] versine_product;
  logic signed [2*CoefBits-1:0] tau_product;
  polynomial_products #(
      .CoefBits(CoefBits),
      .SampleInterval(SampleInterval),
      .MultiplierForm(MultiplierForm)
  ) u_products (
      .clk_i,
      .sine_phase_i,
      .versine_phase_i,
      .tangent_i(tangent_q),
      .sine_i,
      .normal_i(normal_q),
      .versine_i,
      .rate_i(rate),
      .tau_i,
      .sine_product_o(sine_product),
      .versine_product_o(versine_product),
      .tau_product_o(tau_product)
  );

  // A product from the bit of one half upwards.
  localparam int Frac = CoefBits - 2;
  logic signed [CoefBits:0] sine_part;
  logic signed [CoefBits:0] versine_part;
  logic signed [CoefBits:0] tau_part;
  assign sine_part    = sine_product[Frac-1+:CoefBits+1];
  assign versine_part = versine_product[Frac-1+:CoefBits+1];
  assign tau_part     = tau_product[Frac+:CoefBits+1];

  logic signed [  CoefBits:0] advance_half;
  logic signed [  CoefBits:0] rate_twice;
  logic signed [  CoefBits:0] inward_twice;
  logic signed [  CoefBits:0] inward_half;
  logic signed [  CoefBits:0] d_twice;
  logic signed [CoefBits-1:0] rate_q;
  logic signed [CoefBits-1:0] inward_q;
  assign advance_half = {advance_memory[advance_bank_i], 1'b1};
  assign rate_twice   = advance_half + sine_part;
  assign inward_twice = versine_part + $signed({{CoefBits{1'b0}}, 1'b1});
  assign inward_half  = {inward_q, 1'b1};
  assign d_twice      = inward_half + tau_part;
  always_ff @(posedge clk_i) begin
    rate_q   <= rate_twice[CoefBits:1];
    inward_q <= inward_twice[CoefBits:1];
    d_o      <= d_twice[CoefBits:1];
  end

  if (SampleInterval == 2) begin : g_later
    logic signed [CoefBits-1:0] late_q;
    always_ff @(posedge clk_i) begin
      late_q <= rate_q;
    end
    assign rate = late_q;
  end else begin : g_direct
    assign rate = rate_q;
  end

endmodule
`default_nettype wire
