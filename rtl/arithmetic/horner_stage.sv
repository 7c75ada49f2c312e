// SPDX-License-Identifier: Apache-2.0
// One multiplier of a Horner evaluation, with the coefficients of its passes:
//
//     product = floor((coefficient + sum) x / 2^Shift + 1/2)
//     sum     = product of the pass before, here or in the stage before; 0 in the first pass of all
//
// A product is a word and the bit below it.  Where a stage follows, its sum takes both and so
// rounds; the last stage rounds itself, and the bit is 0.
//
//   enabled clock   0                1                2             3             Loop
//   address_i       of the pass
//   first_i         1: previous_i
//   previous_i      Interval > 1     Interval = 1
//   x_i                                               Interval <= 2 Interval > 2
//   late_o                                                                        product
//                                                                     (Interval = 1: + 1)
//
// Loop is 9 for 4 and 8 passes, two clocks more than sum and product need: one of them registers
// the address, which comes from a wide choice.
`default_nettype none
module horner_stage #(
    parameter int Bits      = 36,     // [18, 36]
    parameter int Shift     = 35,     // [0, 35]
    parameter int LastShift = Shift,  // [1, 35] for the last pass; Interval > 2
    parameter int Address   = 2,      // [1, 8] coefficients: Interval passes of every bank
    parameter int Interval  = 1,      // 1, 2, 4, 8 passes
    parameter int First     = 1,      // 1: no stage before
    parameter int Last      = 1,      // 1: no stage behind
    parameter int Form      = 0       // form of the multiplier
) (
    input wire logic clk_i,
    input wire logic en_i,

    // Coefficients
    input wire logic                      write_i,
    input wire logic        [Address-1:0] write_address_i,
    input wire logic signed [   Bits-1:0] write_coef_i,

    // Passes
    input  wire logic        [Address-1:0] address_i,
    input  wire logic                      first_i,
    input  wire logic                      next_last_i,  // a clock before late_o is registered
    input  wire logic signed [   Bits-1:0] x_i,
    input  wire logic signed [     Bits:0] previous_i,
    output logic signed      [     Bits:0] late_o
);

  logic signed [Bits-1:0] memory[2**Address];
  always_ff @(posedge clk_i) begin
    if (write_i) memory[write_address_i] <= write_coef_i;
  end

  logic [Address-1:0] address;
  if (Interval > 2) begin : g_address
    logic [Address-1:0] address_q;
    always_ff @(posedge clk_i) begin
      if (en_i) address_q <= address_i;
    end
    assign address = address_q;
  end else begin : g_direct_address
    assign address = address_i;
  end

  logic signed [Bits-1:0] coef_q;
  always_ff @(posedge clk_i) begin
    if (en_i) coef_q <= memory[address];
  end

  // The sum, in time for the addition to coef_q.
  logic signed [Bits:0] sum;
  if (Interval > 1) begin : g_fold
    logic signed [Bits:0] sum_q;
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        if (!first_i) sum_q <= late_o;
        else if (First != 0) sum_q <= '0;
        else sum_q <= previous_i;
      end
    end
    if (Interval > 2) begin : g_late_sum
      logic signed [Bits:0] sum2_q;
      always_ff @(posedge clk_i) begin
        if (en_i) sum2_q <= sum_q;
      end
      assign sum = sum2_q;
    end else begin : g_direct_sum
      assign sum = sum_q;
    end
  end else begin : g_chain
    logic unused;
    assign unused = first_i;
    assign sum = (First != 0) ? '0 : previous_i;
  end

  logic signed [  Bits:0] coef_half;
  logic signed [  Bits:0] twice;
  logic signed [Bits-1:0] accumulator_q;
  assign coef_half = {coef_q, 1'b1};
  assign twice     = coef_half + sum;
  always_ff @(posedge clk_i) begin
    if (en_i) accumulator_q <= twice[Bits:1];
  end

  localparam int Mixed = (Interval > 2 && LastShift != Shift) ? 1 : 0;
  localparam int ProductShift = (Mixed != 0 || Last == 0) ? 0 : Shift;
  logic signed [2*Bits-ProductShift-1:0] product;
  multiplier #(
      .ABits(Bits),
      .BBits(Bits),
      .Shift(ProductShift),
      .Form (Form)
  ) u_multiplier (
      .clk_i,
      .en_i,
      .a_i(accumulator_q),
      .b_i(x_i),
      .product_o(product)
  );

  if (Mixed != 0) begin : g_mixed
    // One of two shifts: the exact product from the bit of one half upwards, rounded here.
    logic is_last;
    local_copy u_last (
        .clk_i,
        .data_i(next_last_i),
        .data_o(is_last)
    );
    logic signed [Bits:0] plain;
    logic signed [Bits:0] last;
    logic signed [Bits:0] halves;
    logic signed [Bits:0] one;
    logic signed [Bits:0] rounded;
    assign plain   = product[Shift-1+:Bits+1];
    assign last    = product[LastShift-1+:Bits+1];
    assign halves  = is_last ? last : plain;
    assign one     = (Bits + 1)'(2'sd1);
    assign rounded = halves + one;
    always_ff @(posedge clk_i) begin
      if (en_i) late_o <= {rounded[Bits:1], 1'b0};
    end
  end else begin : g_rounded
    logic unused_last;
    logic signed [Bits:0] pass;
    assign unused_last = next_last_i;
    if (Last != 0) begin : g_last
      assign pass = {product[Bits-1:0], 1'b0};
    end else begin : g_exact
      assign pass = product[Shift-1+:Bits+1];
    end
    if (Interval > 2) begin : g_late
      always_ff @(posedge clk_i) begin
        if (en_i) late_o <= pass;
      end
    end else begin : g_direct
      assign late_o = pass;
    end
  end

endmodule
`default_nettype wire
