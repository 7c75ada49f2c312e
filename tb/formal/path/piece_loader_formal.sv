// SPDX-License-Identifier: Apache-2.0
// rtl/path/piece_loader.sv: every five words make one piece, each word goes to its place, a piece
// waits until it is taken, and no word is taken meanwhile. Words of stop branches go elsewhere.
// control: KEEPS_STEPS s/ \&\& !step_write_o//
// control: LOSES_STOPS s/assign stop_write_o .*/assign stop_write_o = 1'b0;/
// control: SHORT_PIECE s/index_q == 3'd4) ? 3'd0/index_q == 3'd3) ? 3'd0/
// control: TAKES_EARLY s/assign word_ready_o .*/assign word_ready_o = 1'b1;/
// control: SAME_BANK s/bank_o + 1'b1/bank_o/
// control: WRONG_PLACE s/4'd4 - {1'b0, index_q}/{1'b0, index_q}/
// control: NO_RESET s/index_q       <= 3'd0;//
`default_nettype none
module piece_loader_formal (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        word_valid_i,
    input wire logic [47:0] word_i,
    input wire logic        take_i
);

  logic word_ready;
  logic stop_write;
  logic step_write;
  logic coef_write;
  logic [3:0] coef_pass;
  logic signed [35:0] coef;
  logic bound_write;
  logic [5:0] exponent;
  logic [47:0] ds;
  logic [2:0] bank;
  logic piece_valid;
  logic [19:0] ticks;
  logic [4:0] time_exponent;
  logic is_final;
  piece_loader #(
      .BankBits(3)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .word_valid_i,
      .word_ready_o(word_ready),
      .word_i,
      .stop_write_o(stop_write),
      .step_write_o(step_write),
      .coef_write_o(coef_write),
      .coef_pass_o(coef_pass),
      .coef_o(coef),
      .bound_write_o(bound_write),
      .exponent_o(exponent),
      .ds_o(ds),
      .bank_o(bank),
      .piece_valid_o(piece_valid),
      .piece_take_i(take_i),
      .ticks_o(ticks),
      .time_exponent_o(time_exponent),
      .final_o(is_final)
  );

  // The piece as it should be: words taken, and the first of them.
  logic started_q = 1'b0;
  logic [2:0] words_q;
  logic [2:0] pieces_q;
  logic [31:0] first_q;
  logic taken;
  logic stop;
  logic step;
  logic word;
  assign taken = word_valid_i && word_ready;
  assign stop  = taken && word_i[47:44] == 4'd13;
  assign step  = taken && word_i[47:44] == 4'd14;
  assign word  = taken && !stop && !step;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!rst_ni) begin
      words_q  <= '0;
      pieces_q <= '0;
    end else begin
      if (take_i) words_q <= '0;
      else if (word) words_q <= words_q + 1'b1;
      if (take_i) pieces_q <= pieces_q + 1'b1;
      if (word && words_q == 3'd0) first_q <= word_i[31:0];
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (!piece_valid) assume (!take_i);

      WholePiece : assert (piece_valid == (words_q == 3'd5));
      NeverStuck : assert (word_ready == (words_q != 3'd5));
      Elsewhere : assert (stop_write == stop && step_write == step);
      OwnBank : assert (bank == pieces_q);
      Bound : assert (bound_write == (word && words_q == 3'd1));
      Coefficients : assert (coef_write == (word && words_q >= 3'd2));
      if (coef_write) Place : assert (coef_pass == 4'd4 - {1'b0, words_q});
      if (coef_write) Coefficient : assert (coef == word_i[35:0]);
      if (bound_write) Length : assert (ds == {4'b0, word_i[43:0]});
      if (words_q != 3'd0) begin
        Control : assert ({is_final, exponent, time_exponent, ticks} == first_q);
      end

      SecondPiece : cover (piece_valid && pieces_q == 3'd1);
    end
  end

endmodule
`default_nettype wire
