// SPDX-License-Identifier: Apache-2.0
// Places of a term's factors and of a result's limb in memory, 4 word + limb: a word by its
// number, or by its place in page X or Y of the program that runs. Constants stand in words 0 to 4.
//
//   term              | first factor          | second factor
//   product           | F0 (MADR: F2), limb i | F1, limb j; of a power 2^r if j is its limb, else 0
//   added             | F0 (MAC: F2)          | 1
//   product, ADD, SUB | F0                    | 1
//   added, ADD, SUB   | 1, -1                 | F1, as of a product
//   empty             | any                   | 0
//   OUT               | F0                    | any
//
// Pages are taken from OUT's last limb, a clock behind its term (hls/instruction.hpp).
`default_nettype none
module engine_operands #(
    parameter int WordBits = 8  // [8, 12]: 2^WordBits words
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic [23:0] fields_i,  // {F0, F1, F2}
    input wire logic        thread_i,  // the program that runs

    // Pages
    input wire logic                page_x_i,
    input wire logic                page_y_i,
    input wire logic [WordBits-6:0] page_i,

    // Term
    input  wire logic                product_i,
    input  wire logic                sum_i,
    input  wire logic                minus_i,
    input  wire logic                power_i,
    input  wire logic                gathers_i,
    input  wire logic                adds_up_i,
    input  wire logic [         2:0] i_i,
    input  wire logic [         1:0] j_i,
    input  wire logic [         2:0] limb_i,     // the result's
    input  wire logic                added_i,
    input  wire logic                empty_i,
    output logic      [WordBits+1:0] first_o,
    output logic      [WordBits+1:0] second_o,

    // Limb that is written
    input  wire logic [         2:0] written_i,
    output logic      [WordBits+1:0] result_o,
    output logic                     constant_o  // words that are not written
);

  localparam int PageBits = WordBits - 5;
  localparam logic [WordBits+1:0] One = (WordBits + 2)'(engine_pkg::One);
  localparam logic [WordBits+1:0] MinusOne = (WordBits + 2)'(engine_pkg::MinusOne);
  localparam logic [WordBits+1:0] Zero = (WordBits + 2)'(engine_pkg::Zero);

  initial if (WordBits < 8 || WordBits > 12) $fatal(1, "WordBits must be in [8, 12]");

  // Pages
  logic [PageBits-1:0] x_q[2];
  logic [PageBits-1:0] y_q[2];
  logic [PageBits-1:0] x, y;
  assign x = x_q[thread_i];
  assign y = y_q[thread_i];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_q[0] <= '0;
      x_q[1] <= '0;
      y_q[0] <= '0;
      y_q[1] <= '0;
    end else begin
      if (page_x_i) x_q[thread_i] <= page_i;
      if (page_y_i) y_q[thread_i] <= page_i;
    end
  end
  function automatic logic [WordBits-1:0] word(input logic [7:0] field,
                                               input logic [PageBits-1:0] page_x,
                                               input logic [PageBits-1:0] page_y);
    word = {{(WordBits - 7) {1'b0}}, field[6:0]};
    if (field[7]) word = {field[5] ? page_y : page_x, field[4:0]};
  endfunction
  logic [7:0] f0, f1, f2;
  assign {f0, f1, f2} = fields_i;

  // First factor
  logic from_f2;
  logic [2:0] first_limb;
  logic [WordBits-1:0] first_word;
  assign from_f2 = added_i ? gathers_i : adds_up_i;
  assign first_limb = product_i && !added_i ? i_i : limb_i;
  assign first_word = word(from_f2 ? f2 : f0, x, y);
  always_comb begin
    first_o = {first_word[WordBits-1:1], first_word[0] | first_limb[2], first_limb[1:0]};
    if (sum_i && added_i) first_o = minus_i ? MinusOne : One;
  end

  // Second factor
  logic [WordBits-1:0] second_word;
  assign second_word = word(f1, x, y);
  always_comb begin
    second_o = {second_word, j_i};
    if (power_i) second_o = j_i == f1[5:4] ? {{(WordBits - 2) {1'b0}}, f1[3:0]} : Zero;
    if (empty_i) second_o = Zero;
    if (sum_i != added_i) second_o = One;
  end

  // Result
  logic [WordBits-1:0] result_word;
  assign result_word = word(f2, x, y);
  assign result_o = {result_word[WordBits-1:1], result_word[0] | written_i[2], written_i[1:0]};
  assign constant_o = result_word[WordBits-1:3] == '0;

endmodule
`default_nettype wire
