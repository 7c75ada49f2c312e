// SPDX-License-Identifier: Apache-2.0
// rtl/path/piece_ledger.sv: the counts are those of the pieces that wait, in every order of words
// and takes that the queue allows; ticks follow two clocks later. Pieces are of one or two ticks.
// control: LOSES_PIECE s/!take_i) pieces_q/!take_i \&\& !final_o) pieces_q/
// control: BOTH_AT_ONCE s/if (put \&\& !take_i)/if (put)/
// control: FINAL_STAYS s/if (take_final \&\& !put_final)/if (take_final \&\& !put)/
// control: NARROW s/(QueueWords + 2) \/ 5 + 1/(QueueWords + 2) \/ 5 - 1/
// control: LOSES_TICKS s/put_ticks_q  <= put ?/put_ticks_q  <= (put \&\& !take_i) ?/
// control: NO_RESET s/finals_q <= '0;//
`default_nettype none
module piece_ledger_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic word_i,
    input wire logic double_i,
    input wire logic final_i,
    input wire logic take_i
);

  localparam int QueueWords = 16;
  localparam int Held = QueueWords + 2 + 5;  // with the queue's output and the loader
  localparam int Pieces = 4;

  // The pieces that wait, oldest first, and the words of the one that comes in.
  logic [2:0] pieces_q;
  logic [2:0] words_q;
  logic first_double_q;
  logic first_final_q;
  logic [Pieces-1:0] double_q;
  logic [Pieces-1:0] final_q;
  logic put;
  assign put = word_i && words_q == 3'd4;

  logic queued;
  logic plenty;
  logic final_waits;
  logic [31:0] ticks;
  piece_ledger #(
      .QueueWords(QueueWords)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .word_i,
      .data_i({16'b0, final_i, 29'b0, double_i, !double_i}),
      .take_i,
      .take_ticks_i({18'b0, double_q[0], !double_q[0]}),
      .take_final_i(final_q[0]),
      .queued_o(queued),
      .plenty_o(plenty),
      .final_o(final_waits),
      .ticks_o(ticks)
  );

  logic started_q = 1'b0;
  logic [2:0] place;  // of the piece that comes in
  assign place = take_i ? pieces_q - 3'd1 : pieces_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!rst_ni) begin
      pieces_q <= '0;
      words_q  <= '0;
      final_q  <= '0;
    end else begin
      if (word_i) words_q <= put ? 3'd0 : words_q + 3'd1;
      if (word_i && words_q == 3'd0) begin
        first_double_q <= double_i;
        first_final_q  <= final_i;
      end
      pieces_q <= pieces_q + {2'b0, put} - {2'b0, take_i};
      if (take_i) begin
        final_q  <= {1'b0, final_q[Pieces-1:1]};
        double_q <= {1'b0, double_q[Pieces-1:1]};
      end
      for (int n = 0; n < Pieces; n = n + 1) begin
        if (put && place == 3'(n)) begin
          double_q[n] <= first_double_q;
          final_q[n]  <= first_final_q;
        end
      end
    end
  end

  logic [3:0] waiting;
  always_comb begin
    waiting = '0;
    for (int n = 0; n < Pieces; n = n + 1) begin
      if (pieces_q > 3'(n)) waiting = waiting + {2'b0, double_q[n], !double_q[n]};
    end
  end
  logic [3:0] waiting_q[2];
  always_ff @(posedge clk_i) begin
    waiting_q[0] <= rst_ni ? waiting : '0;
    waiting_q[1] <= rst_ni ? waiting_q[0] : '0;
  end

  logic [5:0] held;
  assign held = {1'b0, pieces_q, 2'b0} + {3'b0, pieces_q} + {3'b0, words_q};
  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (held >= 6'(Held)) assume (!word_i);
      if (pieces_q == '0) assume (!take_i);

      Queued : assert (queued == (pieces_q != '0));
      Plenty : assert (plenty == (pieces_q >= 3'd2));
      Final : assert (final_waits == (final_q != '0));
      Ticks : assert (ticks == {28'b0, waiting_q[1]});

      Full : cover (held == 6'(Held) && final_q == 4'b1010 && ticks == 32'd7);
      TakesLast : cover (!queued && ticks == 32'd2 && waiting == '0);
    end
  end

endmodule
`default_nettype wire
