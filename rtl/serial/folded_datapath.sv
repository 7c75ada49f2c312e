// SPDX-License-Identifier: Apache-2.0
// The one multiplier of the serial build with its word memory: d = c + round(a b / 2^(CoefBits-1)),
// or / 2^(CoefBits-2) with wide_i; one operation per clock.
//
//   cycle    0                      1 .. 7    8                9
//            addresses, target_i              d_o, target_o
//   memory   a, b read                        d written        d readable
//
// target_i: 1 the word memory at d_address_i, 2 and 3 what the user makes of d_o.  An operation
// reads what one nine cycles before has written; c is read five cycles after a and b.  Words from
// outside are written when no result is: external_ready_o.  Nothing is written under reset.
`default_nettype none
module folded_datapath #(
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic [7:0] a_address_i,
    input wire logic [7:0] b_address_i,
    input wire logic [7:0] c_address_i,
    input wire logic [7:0] d_address_i,
    input wire logic       wide_i,
    input wire logic [1:0] target_i,

    input  wire logic                external_i,
    output logic                     external_ready_o,
    input  wire logic [         7:0] external_address_i,
    input  wire logic [CoefBits-1:0] external_data_i,

    output logic        [         1:0] target_o,
    output logic        [         7:0] d_address_o,
    output logic signed [CoefBits-1:0] d_o
);

  initial if (CoefBits < 18 || CoefBits > 36) $fatal(1, "CoefBits must be in [18, 36]");
  initial
    if (MultiplierForm < 0 || MultiplierForm > 2) $fatal(1, "MultiplierForm must be in [0, 2]");
  localparam int W = (CoefBits < 18 || CoefBits > 36) ? 36 : CoefBits;

  // What travels beside the operands.
  logic [7:0] c_address_q[5];
  logic [7:0] d_address_q[8];
  logic       wide_q     [7];
  logic [1:0] target_q   [8];
  always_ff @(posedge clk_i) begin
    c_address_q[0] <= c_address_i;
    d_address_q[0] <= d_address_i;
    wide_q[0]      <= wide_i;
    target_q[0]    <= rst_ni ? target_i : 2'd0;
    for (int n = 1; n < 5; n = n + 1) c_address_q[n] <= c_address_q[n-1];
    for (int n = 1; n < 7; n = n + 1) wide_q[n] <= wide_q[n-1];
    for (int n = 1; n < 8; n = n + 1) begin
      d_address_q[n] <= d_address_q[n-1];
      target_q[n]    <= rst_ni ? target_q[n-1] : 2'd0;
    end
  end
  assign target_o    = target_q[7];
  assign d_address_o = d_address_q[7];

  logic         write;
  logic [  7:0] write_address;
  logic [W-1:0] write_data;
  assign external_ready_o = target_o != 2'd1;
  assign write            = rst_ni && (external_i || !external_ready_o);
  assign write_address    = external_ready_o ? external_address_i : d_address_o;
  assign write_data       = external_ready_o ? external_data_i : d_o;

  logic        [W-1:0] a;
  logic        [W-1:0] b;
  logic        [W-1:0] c;
  logic signed [W-1:0] a_q;
  logic signed [W-1:0] b_q;
  logic signed [W-1:0] c_q;
  word_memory #(
      .CoefBits(W)
  ) u_a (
      .clk_i,
      .write_i        (write),
      .write_address_i(write_address),
      .write_data_i   (write_data),
      .read_i         (a_address_i),
      .data_o         (a)
  );
  word_memory #(
      .CoefBits(W)
  ) u_b (
      .clk_i,
      .write_i        (write),
      .write_address_i(write_address),
      .write_data_i   (write_data),
      .read_i         (b_address_i),
      .data_o         (b)
  );
  word_memory #(
      .CoefBits(W)
  ) u_c (
      .clk_i,
      .write_i        (write),
      .write_address_i(write_address),
      .write_data_i   (write_data),
      .read_i         (c_address_q[4]),
      .data_o         (c)
  );
  always_ff @(posedge clk_i) begin
    a_q <= a;
    b_q <= b;
    c_q <= c;
  end

  // To nearest, ties upwards: the floor plus the bit below.
  logic signed [2*W-1:0] product;
  logic signed [  W-1:0] floor;
  logic                  below;
  logic        [    W:0] sum;
  multiplier #(
      .ABits(W),
      .BBits(W),
      .Shift(0),
      .Form (MultiplierForm)
  ) u_multiplier (
      .clk_i,
      .en_i     (1'b1),
      .a_i      (a_q),
      .b_i      (b_q),
      .product_o(product)
  );
  assign floor = wide_q[6] ? product[2*W-3:W-2] : product[2*W-2:W-1];
  assign below = wide_q[6] ? product[W-3] : product[W-2];
  assign sum   = {c_q, 1'b1} + {floor, below};
  always_ff @(posedge clk_i) d_o <= sum[W:1];

endmodule
`default_nettype wire
