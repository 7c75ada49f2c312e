// SPDX-License-Identifier: Apache-2.0
// rtl/queue/piece_entry.sv, for any words: they pass as pieces, word by word, of consecutive
// numbers, each with a stop branch before it or without, which has steps, or those of one before
// it; a word passes exactly if it is valid by hls/words.hpp, and has the check of those before it
// in its program, begun with the digest; whole pieces alone are counted, each with the ticks and
// final of its own words; a path length is reported as it passes.
// control: SKIPS_WORD s/= tag + 4'd1/= tag + 4'd1 + {3'b0, tag == words_pkg::TagC1}/
// control: ZERO_TICKS s/- 1'b1;/;/
// control: ANY_EXPONENT s/e <= words_pkg::MostExponent \&\&//
// control: ANY_REST s/data_o\[words_pkg::SequenceLow-1:FirstSpare\] == '0/1'b1/
// control: NO_CHECK_OF_C2 s/tag == words_pkg::TagC2 ||//
// control: ONE_PROGRAM s/.last_i(final_o)/.last_i(1'b0)/
// control: SEVERAL_FINALS s/(pass \&\& tag == words_pkg::TagPiece)/(pass)/
// control: TWO_BRANCHES s/\&\& !stop_q \&\& stops/\&\& stops/
// control: UNKNOWN s/(known_q || !again)/1'b1/
// control: ENDLESS s/data_o\[words_pkg::StepLastLow\] ?/1'b0 ?/
// control: NO_RESET s/tag_q   <= words_pkg::TagPiece;/tag_q <= tag_q;/
`default_nettype none
module piece_entry_formal (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        valid_i,
    input wire logic [47:0] data_i,
    input wire logic [15:0] digest_i,
    input wire logic        cut_i,
    input wire logic        wait_i,
    input wire logic        turn_i,
    input wire logic        ready_i
);

  logic ready;
  logic valid;
  logic [47:0] data;
  logic piece;
  logic [19:0] ticks;
  logic ds;
  logic is_final;
  logic [1:0] fault;
  piece_entry u_dut (
      .clk_i,
      .rst_ni,
      .valid_i,
      .ready_o(ready),
      .data_i,
      .digest_i,
      .cut_i,
      .wait_i,
      .turn_i,
      .valid_o(valid),
      .ready_i,
      .data_o(data),
      .ds_o(ds),
      .piece_o(piece),
      .ticks_o(ticks),
      .final_o(is_final),
      .fault_o(fault)
  );

  logic [2:0] place_q;  // of the word that has to come in its piece
  logic [1:0] branch_q;  // 0 none, 1 a step has to come, 2 it is complete
  logic steps;
  logic stop;
  logic known_q;  // a branch came whose steps another may have
  logic again_q;  // the last branch has them
  assign steps = branch_q == 2'd1;
  assign stop  = place_q == '0 && branch_q == 2'd0 && data[47:44] == 4'd13;
  logic [7:0] pieces_q;
  logic held_q;
  logic ends_q;
  logic [19:0] ticks_q;
  logic final_q;
  logic started_q = 1'b0;
  logic pass;
  assign pass = valid && ready_i;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    ends_q    <= rst_ni && pass && place_q == 3'd4;
    if (!rst_ni) begin
      place_q  <= '0;
      branch_q <= '0;
      pieces_q <= '0;
      known_q  <= 1'b0;
      again_q  <= 1'b0;
      held_q   <= 1'b0;
    end else begin
      if (pass && steps) branch_q <= data[43] ? 2'd2 : 2'd1;
      else if (pass && stop) branch_q <= data[20] ? 2'd2 : 2'd1;
      else if (pass) begin
        branch_q <= '0;
        place_q  <= place_q == 3'd4 ? 3'd0 : place_q + 3'd1;
        if (place_q == 3'd4) pieces_q <= pieces_q + 8'd1;
      end
      if (pass && steps) known_q <= 1'b1;
      if (pass && stop) again_q <= data[20];
      if (ready) held_q <= valid_i && !cut_i && fault == 2'b00;
    end
    if (pass && place_q == 3'd0 && !steps && !stop) begin
      ticks_q <= data[19:0];
      final_q <= data[31];
    end
  end

  // hls/word_check.hpp
  logic checked;
  logic first_q;  // a program's first word has to come
  logic [15:0] crc_q;
  logic [15:0] so_far;
  logic [15:0] crc;
  assign so_far = first_q ? digest_i : crc_q;
  logic [47:0] counted;
  assign checked = place_q >= 3'd2 && !steps;
  always_comb begin
    counted = data;
    if (checked || (place_q == 3'd0 && !steps && !stop)) counted[43:36] = '0;
    crc = {so_far[7:0], 8'b0} ^ {5'b0, so_far[15:8], 3'b0} ^ {8'b0, so_far[15:8]} ^
        {4'b0, counted[43:32]} ^ counted[31:16] ^ counted[15:0];
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      first_q <= 1'b1;
      crc_q   <= '0;
    end else if (pass) begin
      first_q <= place_q == 3'd4 && final_q;
      crc_q   <= crc;
    end
  end

  // hls/words.hpp: ticks 1 .. 2^m, m 0 .. 19, e 0 .. 46, 4 spare bits
  logic can_be;
  logic is_ds;
  logic turn;
  assign is_ds = place_q == 3'd1;
  assign turn  = turn_i || !is_ds;
  always_comb begin
    can_be = !checked || data[43:36] == (crc[15:8] ^ crc[7:0]);
    if (place_q == 3'd0) begin
      can_be = data[24:20] <= 5'd19 && data[30:25] <= 6'd46 && data[35:32] == '0;
      if (data[19:0] == '0 || {12'b0, data[19:0]} > (32'd1 << data[24:20])) can_be = 1'b0;
      if (data[43:36] != pieces_q) can_be = 1'b0;
    end
    if (data[47:44] != 4'd8 + {1'b0, place_q}) can_be = 1'b0;
    // A wait, ticks: not 0
    if (stop) can_be = data[19:0] != '0 && data[43:21] == '0 && (known_q || !data[20]);
    if (steps) can_be = data[47:44] == 4'd14 && data[10:0] != '0;
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      Passes : assert (valid == (held_q && can_be && !cut_i && !wait_i && turn && fault == 2'b00));
      Counted : assert (piece == ends_q);
      if (piece) OfIts : assert ({is_final, ticks} == {final_q, ticks_q});
      Ds : assert (ds == (pass && is_ds));

      SecondFinal : cover (piece && is_final && pieces_q == 8'd2);
      Branch : cover (branch_q == 2'd2 && pieces_q == 8'd1);
      Again : cover (piece && again_q);
      Refused : cover (fault == 2'b01 && pieces_q == 8'd1 && place_q == 3'd3);
    end
  end

endmodule
`default_nettype wire
