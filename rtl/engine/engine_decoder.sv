// SPDX-License-Identifier: Apache-2.0
// An operation's terms, decoded while the instruction is fetched.
//
//   clock      0       1
//   fetch_i    1
//   ahead_i    word
//   others             of that word, until the next fetch
//
// A column gathers the products of limbs i and j of its two factors, i + j = column, then a limb
// that is added. Of a factor that is a power, limb `most_j_o` alone is not 0.
`default_nettype none
module engine_decoder (
    input wire logic clk_i,

    input wire logic        fetch_i,
    input wire logic [31:0] ahead_i,

    output logic       branch_o,      // BR, or no operation
    output logic       goes_o,        // BR
    output logic       in_o,
    output logic       out_o,
    output logic       result_o,      // words are written, flags set
    output logic       sum_o,         // ADD, SUB
    output logic       minus_o,       // SUB
    output logic       product_o,
    output logic       power_o,       // F1 is one, of any but branches and ports
    output logic       high_o,        // columns from 3 on are the result
    output logic       round_o,       // half of column 3 is added
    output logic       wide_o,        // SHR: limbs of F0 to 5, else 2
    output logic       gathers_o,     // MAC with a sum before
    output logic       adds_o,        // MADR
    output logic [1:0] most_j_o,      // most of j
    output logic [2:0] last_column_o
);

  logic [3:0] op;
  logic [1:0] most;
  logic flag, high, power, sum;
  assign op = ahead_i[31:28];
  assign most = ahead_i[27:26];
  assign flag = ahead_i[24];
  assign high = op == engine_pkg::Mulr || op == engine_pkg::Madr || op == engine_pkg::Shr;
  assign power = ahead_i[15:14] == 2'b11;
  assign sum = op == engine_pkg::Add || op == engine_pkg::Sub;

  logic product, port, branch;
  assign product = high || op == engine_pkg::Mull || op == engine_pkg::Mac;
  assign port = op == engine_pkg::In || op == engine_pkg::Out;
  assign branch = !product && !sum && !port;

  logic [2:0] last_column;
  always_comb begin
    last_column = {1'b0, most};
    if (high) last_column = {1'b0, most} + 3'd3;
    if (op == engine_pkg::Mac) last_column = 3'd5;
    if (branch) last_column = 3'd0;
  end

  always_ff @(posedge clk_i) begin
    if (fetch_i) begin
      branch_o      <= branch;
      goes_o        <= op == engine_pkg::Br;
      in_o          <= op == engine_pkg::In;
      out_o         <= op == engine_pkg::Out;
      result_o      <= product || sum || op == engine_pkg::In;
      sum_o         <= sum;
      minus_o       <= op == engine_pkg::Sub;
      product_o     <= product;
      power_o       <= power;
      high_o        <= high;
      round_o       <= high && !flag;
      wide_o        <= op == engine_pkg::Shr;
      gathers_o     <= op == engine_pkg::Mac && !flag;
      adds_o        <= op == engine_pkg::Madr;
      most_j_o      <= sum ? 2'd3 : power ? ahead_i[13:12] : 2'd2;
      last_column_o <= last_column;
    end
  end

endmodule
`default_nettype wire
