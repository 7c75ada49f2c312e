// SPDX-License-Identifier: Apache-2.0
// The one multiplier of the serial build with its word memory; one operation per clock:
//
//     d = c + round((the sum so far + a b) / 2^shift)
//
//   cycle    0                      1 .. 7    8                9
//            addresses, target_i              d_o, target_o
//   memory   a, b read                        d written        d readable
//
// scale_i: (shift - CoefBits + 6) modulo 8, from CoefBits - 6 to CoefBits + 4; without Splines
// CoefBits - 2 or - 1 (4, 5).  first_i: one less if b is of index 1 and the shift CoefBits - 1 or
// + 1.  more_i, with Splines: the product goes into the sum, which is over with the next operation
// without it.
//
// target_i: 1 the word memory at d_address_i, 2 and 3 the user's uses of d_o.  An operation reads
// the result of one nine cycles before; c is read five cycles after a and b.  External words are
// written when no result is: external_ready_o.  Nothing is written under reset, and no result
// replaces a constant.
`default_nettype none
module folded_datapath #(
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int Splines        = 1,   // 0, 1
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic [7+Splines:0] a_address_i,
    input wire logic [7+Splines:0] b_address_i,
    input wire logic [7+Splines:0] c_address_i,
    input wire logic [7+Splines:0] d_address_i,
    input wire logic [        2:0] scale_i,
    input wire logic               first_i,
    input wire logic               more_i,
    input wire logic [        1:0] target_i,

    input  wire logic                external_i,
    output logic                     external_ready_o,
    input  wire logic [ 7+Splines:0] external_address_i,
    input  wire logic [CoefBits-1:0] external_data_i,

    output logic        [         1:0] target_o,
    output logic        [ 7+Splines:0] d_address_o,
    output logic signed [CoefBits-1:0] d_o
);

  initial if (CoefBits < 18 || CoefBits > 36) $fatal(1, "CoefBits must be in [18, 36]");
  initial if (Splines < 0 || Splines > 1) $fatal(1, "Splines must be 0 or 1");
  initial
    if (MultiplierForm < 0 || MultiplierForm > 2) $fatal(1, "MultiplierForm must be in [0, 2]");
  localparam int W = (CoefBits < 18 || CoefBits > 36) ? 36 : CoefBits;
  localparam int AddressBits = 8 + Splines;

  // The portable form's product is a clock early, and its rest waits instead, which needs fewer
  // registers.
  localparam int Early = (MultiplierForm == 0) ? 1 : 0;

  // Words that travel beside the operands.
  logic [AddressBits-1:0] c_address_q[5];
  logic [AddressBits-1:0] d_address_q[8];
  logic [            2:0] scale_q    [7];
  logic [            1:0] target_q   [8];
  logic                   one_less;
  assign one_less = first_i && b_address_i[3:0] == 4'd1;
  always_ff @(posedge clk_i) begin
    c_address_q[0] <= c_address_i;
    d_address_q[0] <= d_address_i;
    scale_q[0]     <= {scale_i[2:1], scale_i[0] && !one_less};
    target_q[0]    <= rst_ni ? target_i : 2'd0;
    for (int n = 1; n < 5; n = n + 1) c_address_q[n] <= c_address_q[n-1];
    for (int n = 1; n < 7; n = n + 1) scale_q[n] <= scale_q[n-1];
    for (int n = 1; n < 8; n = n + 1) begin
      d_address_q[n] <= d_address_q[n-1];
      target_q[n]    <= rst_ni ? target_q[n-1] : 2'd0;
    end
  end
  assign target_o    = target_q[7];
  assign d_address_o = d_address_q[7];

  // Constants are in 0x81, 0x91 and 0xa0 to 0xaf.
  logic constant;
  assign constant = d_address_o == AddressBits'(8'h81) || d_address_o == AddressBits'(8'h91) ||
      d_address_o[AddressBits-1:4] == (4 + Splines)'(4'ha);

  logic                   write;
  logic [AddressBits-1:0] write_address;
  logic [          W-1:0] write_data;
  assign external_ready_o = target_o != 2'd1;
  assign write            = rst_ni && (external_ready_o ? external_i : !constant);
  assign write_address    = external_ready_o ? external_address_i : d_address_o;
  assign write_data       = external_ready_o ? external_data_i : d_o;

  logic signed [W-1:0] a;
  logic signed [W-1:0] b;
  logic        [W-1:0] c;
  logic signed [W-1:0] c_q;
  word_memory #(
      .CoefBits(W),
      .Words(1 << AddressBits)
  ) u_a (
      .clk_i,
      .write_i        (write),
      .write_address_i(write_address),
      .write_data_i   (write_data),
      .read_i         (a_address_i),
      .data_o         (a)
  );
  word_memory #(
      .CoefBits(W),
      .Words(1 << AddressBits)
  ) u_b (
      .clk_i,
      .write_i        (write),
      .write_address_i(write_address),
      .write_data_i   (write_data),
      .read_i         (b_address_i),
      .data_o         (b)
  );
  word_memory #(
      .CoefBits(W),
      .Words(1 << AddressBits)
  ) u_c (
      .clk_i,
      .write_i        (write),
      .write_address_i(write_address),
      .write_data_i   (write_data),
      .read_i         (c_address_q[4]),
      .data_o         (c)
  );
  always_ff @(posedge clk_i) c_q <= c;

  // Block RAM is slow: without the accumulator of sums there is the time for a register behind it.
  logic signed [W-1:0] a_factor;
  logic signed [W-1:0] b_factor;
  if (Splines == 0) begin : g_factors
    always_ff @(posedge clk_i) begin
      a_factor <= a;
      b_factor <= b;
    end
  end else begin : g_words
    assign a_factor = a;
    assign b_factor = b;
  end

  // To nearest, ties upwards: the floor plus the bit below.
  logic signed [2*W-1:0] product;
  logic signed [  W-1:0] floor;
  logic                  below;
  logic        [    W:0] rounding;
  logic        [    W:0] sum;
  multiplier #(
      .ABits(W),
      .BBits(W),
      .Shift(0),
      .Form (MultiplierForm),
      .Early(Early)
  ) u_multiplier (
      .clk_i,
      .en_i     (1'b1),
      .a_i      (a_factor),
      .b_i      (b_factor),
      .product_o(product)
  );
  if (Splines == 0) begin : g_product
    logic unused_more;
    logic longer;
    assign unused_more = more_i;
    assign longer = scale_q[6-Early][0];
    assign floor = longer ? product[2*W-2:W-1] : product[2*W-3:W-2];
    assign below = longer ? product[W-2] : product[W-3];
  end else begin : g_sum
    // This is a stage later than the product.
    logic more_q[6-Early];
    always_ff @(posedge clk_i) begin
      more_q[0] <= more_i;
      for (int n = 1; n < 6 - Early; n = n + 1) more_q[n] <= more_q[n-1];
    end
    folded_accumulator #(
        .CoefBits(W)
    ) u_accumulator (
        .clk_i,
        .product_i(product),
        .more_i   (more_q[5-Early]),
        .scale_i  (scale_q[6-Early]),
        .floor_o  (floor),
        .below_o  (below)
    );
  end
  if (Early == 1) begin : g_wait
    logic [W:0] waits_q;
    always_ff @(posedge clk_i) waits_q <= {floor, below};
    assign rounding = waits_q;
  end else begin : g_now
    assign rounding = {floor, below};
  end
  assign sum = {c_q, 1'b1} + rounding;
  always_ff @(posedge clk_i) d_o <= sum[W:1];

endmodule
`default_nettype wire
