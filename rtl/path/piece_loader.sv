// SPDX-License-Identifier: Apache-2.0
// Loader of the next piece from profile words while the present one runs. Word format:
// hls/words.hpp.
//
// The five words of a piece go where they are used: coefficients and bounds into memories of Banks
// banks (bank_o of the piece), the words for the clock of pieces into outputs beside piece_valid_o.
// After piece_take_i the next piece is there 6 clocks later, when its words are queued. Words of a
// stop branch before it are written elsewhere as they come: stop_write_o, step_write_o.
//
//   clock           0    1    2    3    4    5
//   word            0    1    2    3    4              word_valid_i && word_ready_o
//   bound_write_o        1
//   coef_write_o              1    1    1
//   coef_pass_o               2    1    0              c1, c2, c3: Horner's last, middle, first
//   piece_valid_o                            1         until piece_take_i
`default_nettype none
module piece_loader #(
    parameter int BankBits = 3  // [1, 5]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic        word_valid_i,
    output logic             word_ready_o,
    input  wire logic [47:0] word_i,

    output logic stop_write_o,  // word_i is one
    output logic step_write_o,

    output logic                       coef_write_o,
    output logic        [         3:0] coef_pass_o,
    output logic signed [        35:0] coef_o,
    output logic                       bound_write_o,
    output logic        [         5:0] exponent_o,
    output logic        [        47:0] ds_o,
    output logic        [BankBits-1:0] bank_o,

    output logic             piece_valid_o,
    input  wire logic        piece_take_i,
    output logic      [19:0] ticks_o,
    output logic      [ 4:0] time_exponent_o,
    output logic             final_o
);

  initial if (BankBits < 1 || BankBits > 5) $fatal(1, "BankBits must be in [1, 5]");

  logic [2:0] index_q;
  logic word;
  logic taken;
  logic [3:0] tag;
  assign tag           = word_i[words_pkg::TagLow+:words_pkg::TagBits];
  assign word_ready_o  = !piece_valid_o;
  assign taken         = word_valid_i && word_ready_o;
  assign stop_write_o  = taken && tag == words_pkg::TagStop;
  assign step_write_o  = taken && tag == words_pkg::TagStep;
  assign word          = taken && !stop_write_o && !step_write_o;

  assign bound_write_o = word && index_q == 3'd1;
  assign ds_o          = {4'b0, word_i[43:0]};
  assign coef_write_o  = word && index_q >= 3'd2;
  assign coef_pass_o   = 4'd4 - {1'b0, index_q};
  assign coef_o        = word_i[35:0];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      index_q       <= 3'd0;
      piece_valid_o <= 1'b0;
      bank_o        <= '0;
    end else begin
      if (word) index_q <= (index_q == 3'd4) ? 3'd0 : index_q + 3'd1;
      if (word && index_q == 3'd4) piece_valid_o <= 1'b1;
      if (piece_take_i) begin
        piece_valid_o <= 1'b0;
        bank_o        <= bank_o + 1'b1;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (word && index_q == 3'd0) begin
      ticks_o         <= word_i[19:0];
      time_exponent_o <= word_i[24:20];
      exponent_o      <= word_i[30:25];
      final_o         <= word_i[31];
    end
  end

endmodule
`default_nettype wire
