// SPDX-License-Identifier: Apache-2.0
// What the profile queue holds: whole pieces, their ticks, and whether one of them is final.
//
//   clock       0             1              2          3
//   word_i      piece's last
//   queued_o                  1
//   final_o                   of the piece
//   ticks_o                                             with the piece
//
// A piece is counted from its last word until take_i; ticks_o follows take_i by 3 clocks as well.
`default_nettype none
module piece_ledger #(
    parameter int QueueWords = 512  // [16, 4096]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Words that enter the queue
    input wire logic        word_i,
    input wire logic [47:0] data_i,

    // Pieces that begin
    input wire logic        take_i,
    input wire logic [19:0] take_ticks_i,
    input wire logic        take_final_i,

    output logic        queued_o,  // at least one whole piece
    output logic        plenty_o,  // the queue is three quarters full of whole pieces
    output logic        final_o,   // a final piece is among them
    output logic [31:0] ticks_o
);

  initial if (QueueWords < 16 || QueueWords > 4096) $fatal(1, "QueueWords must be in [16, 4096]");

  // The queue, its output registers and the loader.
  localparam int MaxPieces = (QueueWords + 2) / 5 + 1;
  localparam int CountBits = $clog2(MaxPieces + 1);
  localparam int Plenty = (3 * QueueWords) / 20;

  logic [2:0] index_q;
  logic [19:0] ticks_q;
  logic final_q;
  logic put;
  assign put = word_i && index_q == 3'd4;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) index_q <= 3'd0;
    else if (word_i) index_q <= (index_q == 3'd4) ? 3'd0 : index_q + 3'd1;
  end
  always_ff @(posedge clk_i) begin
    if (word_i && index_q == 3'd0) begin
      ticks_q <= data_i[19:0];
      final_q <= data_i[31];
    end
  end

  logic [CountBits-1:0] pieces_q;
  logic [CountBits-1:0] finals_q;
  logic put_final;
  logic take_final;
  assign put_final  = put && final_q;
  assign take_final = take_i && take_final_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      pieces_q <= '0;
      finals_q <= '0;
    end else begin
      if (put && !take_i) pieces_q <= pieces_q + 1'b1;
      if (take_i && !put) pieces_q <= pieces_q - 1'b1;
      if (put_final && !take_final) finals_q <= finals_q + 1'b1;
      if (take_final && !put_final) finals_q <= finals_q - 1'b1;
    end
  end
  assign queued_o = pieces_q != '0;
  assign plenty_o = pieces_q >= CountBits'(Plenty);
  assign final_o  = finals_q != '0;

  logic [19:0] put_ticks_q;
  logic [19:0] take_ticks_q;
  logic signed [31:0] change_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      put_ticks_q  <= '0;
      take_ticks_q <= '0;
      change_q     <= '0;
      ticks_o      <= '0;
    end else begin
      put_ticks_q  <= put ? ticks_q : '0;
      take_ticks_q <= take_i ? take_ticks_i : '0;
      change_q     <= $signed({12'b0, put_ticks_q}) - $signed({12'b0, take_ticks_q});
      ticks_o      <= ticks_o + change_q;
    end
  end

endmodule
`default_nettype wire
