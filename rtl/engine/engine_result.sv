// SPDX-License-Identifier: Apache-2.0
// The limbs of a result as the columns' sums become known, and the two programs' flags.
//
//   clock        0            1       3        4         5
//   term         last of a column
//   asks_o       of IN
//   ask_o                     of IN
//   answer_i                          limb
//   sum_i                                      its sum
//   write_o                                    its limb
//   flags                                                of that limb and those below
//
// A limb has digits of 0..32767; the top one has a sign: of 16 bits in ADD and SUB, of 15 in
// products.
`default_nettype none
module engine_result (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic thread_i,  // the program that runs

    // Term
    input wire logic       run_i,
    input wire logic       result_i,
    input wire logic       product_i,
    input wire logic       in_i,
    input wire logic [2:0] limb_i,
    input wire logic       kept_i,        // the column is of the result
    input wire logic       ends_i,        // a column
    input wire logic       last_column_i,

    input wire logic signed [33:0] sum_i,
    input wire logic        [15:0] answer_i,

    output logic        asks_o,      // ask_o of the next clock
    output logic        ask_o,
    output logic        write_o,
    output logic [ 2:0] limb_o,      // the one that is written
    output logic [ 2:0] asked_o,     // the one that is asked for
    output logic [15:0] data_o,
    output logic        negative_o,
    output logic        zero_o
);

  logic kept;
  assign kept = run_i && result_i && ends_i && kept_i;

  logic [3:0] write_q;
  logic [3:0] last_q;
  logic [2:0] limb_q  [4];
  always_ff @(posedge clk_i) begin
    write_q <= rst_ni ? {write_q[2:0], kept} : '0;
    last_q <= {last_q[2:0], last_column_i};
    limb_q[0] <= limb_i;
    for (int n = 1; n < 4; n = n + 1) limb_q[n] <= limb_q[n-1];
  end
  assign asks_o  = rst_ni && kept && in_i;
  assign ask_o   = write_q[0] && in_i;
  assign asked_o = limb_q[0];
  assign write_o = write_q[3];
  assign limb_o  = limb_q[3];

  logic [15:0] answer_q;
  logic sign;
  always_ff @(posedge clk_i) answer_q <= answer_i;
  assign sign = product_i ? sum_i[14] : sum_i[15];
  always_comb begin
    data_o = {last_q[3] && sign, sum_i[14:0]};
    if (in_i) data_o = answer_q;
  end

  // Flags
  logic negative_q[2];
  logic zero_q[2];
  logic negative, zero;
  always_comb begin
    negative = sum_i[33];
    if (product_i) negative = last_q[3] && sum_i[14];
    if (in_i) negative = answer_q[15];
  end
  assign zero = data_o == '0 && (limb_q[3] == 3'd0 || zero_q[thread_i]);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      negative_q[0] <= 1'b0;
      negative_q[1] <= 1'b0;
      zero_q[0]     <= 1'b0;
      zero_q[1]     <= 1'b0;
    end else if (write_q[3]) begin
      negative_q[thread_i] <= negative;
      zero_q[thread_i]     <= zero;
    end
  end
  assign negative_o = negative_q[thread_i];
  assign zero_o = zero_q[thread_i];

endmodule
`default_nettype wire
