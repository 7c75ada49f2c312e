// SPDX-License-Identifier: Apache-2.0
// An operation's terms, decoded while the instruction is fetched.
//
//   clock      0                        1
//   fetch_i    1
//   ahead_i    word
//   outputs    high_o, last_limb_o      the others, until the next fetch
//
// A column gathers the products of limbs i and j of its two factors, i + j = column, then a limb
// that is added. Of a factor that is a power, limb `most_j_o` alone is not 0.
`default_nettype none
module engine_decoder (
    input wire logic clk_i,

    input wire logic        fetch_i,
    input wire logic [31:0] ahead_i,

    output logic       high_o,      // columns from 3 on are the result
    output logic [2:0] last_limb_o, // the result's

    output logic       branch_o,   // BR, or no operation
    output logic       goes_o,     // BR
    output logic       in_o,
    output logic       out_o,
    output logic       result_o,   // limbs are written, flags set
    output logic       sum_o,      // ADD, SUB
    output logic       minus_o,    // SUB
    output logic       product_o,
    output logic       power_o,    // F1 is one
    output logic       single_o,   // one product a column
    output logic       round_o,    // half of column 3 is added
    output logic       wide_o,     // SHR: limbs of F0 to 5, else 2
    output logic       gathers_o,  // MAC with a sum before
    output logic       adds_o,     // a limb to each column
    output logic       adds_up_o,  // a limb to each column of the result: MADR
    output logic [1:0] most_j_o    // most of j
);

  logic [3:0] op;
  logic [1:0] most;
  logic flag, power;
  assign op = ahead_i[31:28];
  assign most = ahead_i[27:26];
  assign flag = ahead_i[24];
  assign power = ahead_i[15:14] == 2'b11;

  logic sum, product, port, gathers;
  assign high_o = op == engine_pkg::Mulr || op == engine_pkg::Madr || op == engine_pkg::Shr;
  assign sum = op == engine_pkg::Add || op == engine_pkg::Sub;
  assign product = high_o || op == engine_pkg::Mull || op == engine_pkg::Mac;
  assign port = op == engine_pkg::In || op == engine_pkg::Out;
  assign gathers = op == engine_pkg::Mac && !flag;

  assign last_limb_o = op == engine_pkg::Mac ? 3'd5 : {1'b0, most};

  // A sum's j is its column, a word's 2 at most.
  logic [1:0] most_j;
  assign most_j[1] = sum || !power || ahead_i[13];
  assign most_j[0] = sum || (power && ahead_i[12]);

  always_ff @(posedge clk_i) begin
    if (fetch_i) begin
      branch_o  <= !product && !sum && !port;
      goes_o    <= op == engine_pkg::Br;
      in_o      <= op == engine_pkg::In;
      out_o     <= op == engine_pkg::Out;
      result_o  <= product || sum || op == engine_pkg::In;
      sum_o     <= sum;
      minus_o   <= op == engine_pkg::Sub;
      product_o <= product;
      power_o   <= power;
      single_o  <= power || !product;
      round_o   <= high_o && !flag;
      wide_o    <= op == engine_pkg::Shr;
      gathers_o <= gathers;
      adds_o    <= gathers || sum;
      adds_up_o <= op == engine_pkg::Madr;
      most_j_o  <= most_j;
    end
  end

endmodule
`default_nettype wire
