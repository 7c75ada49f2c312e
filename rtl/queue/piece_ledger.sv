// SPDX-License-Identifier: Apache-2.0
// The ledger of the profile queue: whole pieces, their ticks, and the number of final ones.
//
//   clock      0       1          2
//   put_i      1
//   queued_o           1
//   finals_o           with it
//   ticks_o                       with the piece
//
// A piece is counted from its put_i, after its last word's entry, to its take_i; put_i and take_i
// come one at a time. ticks_o follows take_i by 2 clocks: so the ticks of a piece are never counted
// both here and in the present one, which is reported in the clock after take_i and read a clock
// later (rtl/queue/underrun_guard.sv).
`default_nettype none
module piece_ledger #(
    parameter int QueueWords = 512  // [16, 4096]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Pieces that enter the queue
    input wire logic        put_i,
    input wire logic [19:0] put_ticks_i,
    input wire logic        put_final_i,

    // Pieces that begin
    input wire logic        take_i,
    input wire logic [19:0] take_ticks_i,
    input wire logic        take_final_i,

    output logic        queued_o,  // one or more whole pieces
    output logic [ 9:0] finals_o,
    output logic [31:0] ticks_o
);

  initial if (QueueWords < 16 || QueueWords > 4096) $fatal(1, "QueueWords must be in [16, 4096]");

  // The queue, its output registers and the loader.
  localparam int MaxPieces = (QueueWords + 2) / words_pkg::PieceWords + 1;
  localparam int CountBits = $clog2(MaxPieces + 1);

  logic [CountBits-1:0] pieces_q;
  logic [CountBits-1:0] finals_q;
  logic change_final;
  assign change_final = (put_i && put_final_i) || (take_i && take_final_i);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      pieces_q <= '0;
      finals_q <= '0;
    end else begin
      if (put_i || take_i) pieces_q <= pieces_q + {{(CountBits - 1) {take_i}}, 1'b1};
      if (change_final) finals_q <= finals_q + {{(CountBits - 1) {take_i}}, 1'b1};
    end
  end
  assign queued_o = pieces_q != '0;
  assign finals_o = 10'(finals_q);

  // Ticks of a taken piece with their bits inverted, and the sum's carry.
  logic [19:0] change_q;
  logic less_q;
  logic [31:0] change;
  logic [32:0] sum;
  assign change = {{12{less_q}}, change_q};
  assign sum    = {ticks_o, 1'b1} + {change, less_q};
  always_ff @(posedge clk_i) begin
    change_q <= take_i ? ~take_ticks_i : put_ticks_i;
    less_q   <= rst_ni && take_i;
    if (!rst_ni || !(put_i || take_i)) change_q <= '0;
    if (!rst_ni) ticks_o <= '0;
    else ticks_o <= sum[32:1];
  end

endmodule
`default_nettype wire
