// SPDX-License-Identifier: Apache-2.0
// The terms of an instruction, one a clock, column by column: products of limbs i and j, i from the
// least on, then the limb that is added. A column without any has an empty term; one of ADD and SUB
// two; one of IN and OUT one.
//
//   clock    0         1       2       ..            last
//   start_i  1
//   run_i              1       1       ..            1
//   i_o ..             first   second  ..            last_o
//
// start_i comes with the instruction's fetch; its decoded fields are there from clock 1 on.
`default_nettype none
module engine_terms (
    input wire logic clk_i,

    input wire logic       start_i,
    input wire logic       run_i,
    input wire logic       product_i,
    input wire logic       sum_i,
    input wire logic       power_i,
    input wire logic       wide_i,
    input wire logic       gathers_i,
    input wire logic       adds_i,
    input wire logic [1:0] most_j_i,
    input wire logic [2:0] last_column_i,

    output logic [2:0] column_o,
    output logic [2:0] i_o,
    output logic [1:0] j_o,
    output logic       second_o,       // F1's limb in ADD and SUB
    output logic       added_o,        // the limb that is added
    output logic       empty_o,
    output logic       begins_o,       // a column
    output logic       ends_o,         // a column
    output logic       last_column_o,
    output logic       last_o          // term of the instruction
);

  // Behind a column's products
  logic behind_q;
  logic adds, last_product;
  logic [2:0] most_i;
  assign adds = gathers_i || (adds_i && column_o >= 3'd3);
  assign most_i = wide_i ? 3'd5 : 3'd2;
  assign last_product = power_i || j_o == 2'd0 || i_o == most_i;
  assign added_o = behind_q && adds;
  assign empty_o = behind_q && !adds;

  always_comb begin
    ends_o = 1'b1;
    if (product_i) ends_o = behind_q || (last_product && !adds);
    if (sum_i) ends_o = second_o;
  end
  assign last_column_o = column_o == last_column_i;
  assign last_o = ends_o && last_column_o;

  // The next column begins with its greatest j.
  logic [2:0] next_column;
  logic [1:0] next_j;
  logic [2:0] next_i;
  assign next_column = column_o + 3'd1;
  assign next_j = next_column > {1'b0, most_j_i} ? most_j_i : next_column[1:0];
  assign next_i = next_column - {1'b0, next_j};
  always_ff @(posedge clk_i) begin
    if (start_i) begin
      column_o <= 3'd0;
      i_o      <= 3'd0;
      j_o      <= 2'd0;
      second_o <= 1'b0;
      behind_q <= 1'b0;
      begins_o <= 1'b1;
    end else if (run_i) begin
      begins_o <= ends_o;
      second_o <= sum_i && !second_o;
      if (ends_o) begin
        column_o <= next_column;
        i_o      <= next_i;
        j_o      <= next_j;
        behind_q <= product_i && next_i > most_i;
      end else if (product_i) begin
        if (last_product) begin
          behind_q <= 1'b1;
        end else begin
          i_o <= i_o + 3'd1;
          j_o <= j_o - 2'd1;
        end
      end
    end
  end

endmodule
`default_nettype wire
