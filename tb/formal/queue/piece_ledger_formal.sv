// SPDX-License-Identifier: Apache-2.0
// rtl/queue/piece_ledger.sv: the counts are those of the waiting pieces, for every order of puts
// and takes, one at a time, that the queue allows; ticks follow two clocks later. Pieces are of one
// or two ticks.
// control: LOSES_PIECE s/take_i) pieces_q/(take_i \&\& finals_q == '0)) pieces_q/
// control: FINAL_STAYS s/take_i \&\& take_final_i/take_i \&\& put_final_i/
// control: NARROW s/PieceWords + 1/PieceWords - 1/
// control: LOSES_TICKS s/!(put_i || take_i)) change_q/!(put_i || take_i) || put_final_i) change_q/
// control: KEEPS_TAKEN s/{ticks_o, 1'b1} + {change, less_q}/{ticks_o, 1'b1}/
// control: NO_RESET s/finals_q <= '0;//
`default_nettype none
module piece_ledger_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic put_i,
    input wire logic double_i,
    input wire logic final_i,
    input wire logic take_i
);

  localparam int QueueWords = 16;
  localparam int Pieces = 4;

  // The pieces that wait, oldest first.
  logic [2:0] pieces_q;
  logic [Pieces-1:0] double_q;
  logic [Pieces-1:0] final_q;

  logic queued;
  logic [9:0] finals;
  logic [31:0] ticks;
  piece_ledger #(
      .QueueWords(QueueWords)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .put_i,
      .put_ticks_i({18'b0, double_i, !double_i}),
      .put_final_i(final_i),
      .take_i,
      .take_ticks_i({18'b0, double_q[0], !double_q[0]}),
      .take_final_i(final_q[0]),
      .queued_o(queued),
      .finals_o(finals),
      .ticks_o(ticks)
  );

  logic started_q = 1'b0;
  logic [2:0] place;  // of the piece that comes in
  assign place = pieces_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!rst_ni) begin
      pieces_q <= '0;
      final_q  <= '0;
    end else begin
      pieces_q <= pieces_q + {2'b0, put_i} - {2'b0, take_i};
      if (take_i) begin
        final_q  <= {1'b0, final_q[Pieces-1:1]};
        double_q <= {1'b0, double_q[Pieces-1:1]};
      end
      for (int n = 0; n < Pieces; n = n + 1) begin
        if (put_i && place == 3'(n)) begin
          double_q[n] <= double_i;
          final_q[n]  <= final_i;
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
  logic [3:0] waiting_q;
  always_ff @(posedge clk_i) waiting_q <= rst_ni ? waiting : '0;

  logic [2:0] finals_now;
  always_comb begin
    finals_now = '0;
    for (int n = 0; n < Pieces; n = n + 1) finals_now = finals_now + {2'b0, final_q[n]};
  end
  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (pieces_q == 3'(Pieces)) assume (!put_i);
      if (pieces_q == '0 || put_i) assume (!take_i);

      Queued : assert (queued == (pieces_q != '0));
      Finals : assert (finals == {7'b0, finals_now});
      Ticks : assert (ticks == {28'b0, waiting_q});

      Full : cover (pieces_q == 3'(Pieces) && final_q == 4'b1010 && ticks == 32'd7);
      TakesLast : cover (!queued && ticks == 32'd2 && waiting == '0);
    end
  end

endmodule
`default_nettype wire
