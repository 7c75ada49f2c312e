// SPDX-License-Identifier: Apache-2.0
// The terms of an instruction, one a clock, column by column: products of limbs i and j, i from the
// least on, then the limb that is added. A column without any has an empty term. ADD and SUB have
// F0's limb as the product and F1's as what is added; IN and OUT one term a column.
//
//   clock    0         1       2       ..            last
//   start_i  1
//   run_i              1       1       ..            1
//   i_o ..             first   second  ..            last_o
//
// start_i comes with the instruction's fetch, and with it the first two of its fields; the others
// are there from clock 1 on.
`default_nettype none
module engine_terms (
    input wire logic clk_i,

    input wire logic       start_i,
    input wire logic       high_i,      // columns from 3 on are the result
    input wire logic [2:0] last_limb_i, // the result's

    input wire logic       run_i,
    input wire logic       single_i,   // one product a column
    input wire logic       wide_i,     // limbs i to 5, else 2
    input wire logic       adds_i,     // each column has it
    input wire logic       adds_up_i,  // each of the result has it
    input wire logic [1:0] most_j_i,

    output logic [2:0] i_o,
    output logic [1:0] j_o,
    output logic       added_o,        // the limb that is added
    output logic       empty_o,
    output logic       afresh_o,       // the first term
    output logic       begins_o,       // a column
    output logic       ends_o,         // a column
    output logic       kept_o,         // the column is of the result
    output logic [2:0] limb_o,         // the result's
    output logic       last_column_o,
    output logic       last_o          // term of the instruction
);

  logic behind_q;  // a column's products
  logic last_product_q;
  logic [2:0] left_q;  // limbs of the result that are to come
  logic adds;
  assign adds = adds_i || (adds_up_i && kept_o);
  assign added_o = behind_q && adds;
  assign empty_o = behind_q && !adds;
  assign ends_o = behind_q || (last_product_q && !adds);
  assign last_column_o = kept_o && left_q == 3'd0;
  assign last_o = ends_o && last_column_o;

  // The next column begins with its greatest j: one more, or with one more i.
  logic [1:0] column_q;  // the last two bits
  logic [2:0] first_i_q;
  logic [1:0] first_j_q;
  logic full;
  logic [2:0] next_i, more_i, most_i;
  logic [1:0] next_j;
  assign full   = first_j_q == most_j_i;
  assign next_i = full ? first_i_q + 3'd1 : first_i_q;
  assign next_j = full ? first_j_q : first_j_q + 2'd1;
  assign more_i = i_o + 3'd1;
  assign most_i = wide_i ? 3'd5 : 3'd2;
  always_ff @(posedge clk_i) begin
    if (start_i) begin
      column_q       <= 2'd0;
      left_q         <= last_limb_i;
      kept_o         <= !high_i;
      limb_o         <= 3'd0;
      first_i_q      <= 3'd0;
      first_j_q      <= 2'd0;
      i_o            <= 3'd0;
      j_o            <= 2'd0;
      last_product_q <= 1'b1;
      behind_q       <= 1'b0;
      begins_o       <= 1'b1;
      afresh_o       <= 1'b1;
    end else if (run_i) begin
      afresh_o <= 1'b0;
      begins_o <= ends_o;
      if (ends_o) begin
        column_q       <= column_q + 2'd1;
        left_q         <= left_q - {2'b0, kept_o};
        kept_o         <= kept_o || column_q == 2'd2;
        limb_o         <= limb_o + {2'b0, kept_o};
        first_i_q      <= next_i;
        first_j_q      <= next_j;
        i_o            <= next_i;
        j_o            <= next_j;
        last_product_q <= single_i || next_j == 2'd0 || next_i == most_i;
        behind_q       <= next_i > most_i;
      end else if (last_product_q) begin
        behind_q <= 1'b1;
      end else begin
        i_o            <= more_i;
        j_o            <= j_o - 2'd1;
        last_product_q <= j_o == 2'd1 || more_i == most_i;
      end
    end
  end

endmodule
`default_nettype wire
