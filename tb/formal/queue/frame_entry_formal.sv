// SPDX-License-Identifier: Apache-2.0
// rtl/queue/frame_entry.sv, for any words: those that pass are the words that came, none lost or
// doubled, each with its tag, valid, with the check of all words before it in its program, begun
// with the digest at the program's first word, in a frame of the next number that follows the one
// before; and every such word passes. The first other word is reported, with its cause, and nothing
// passes after it; nor while another stream is cut, or the word has to wait. Words are numbered; a
// reset makes a fresh start.
// control: LETS_TAG s/can_be_i && data_o.*;/can_be_i;/
// control: ANY_ORDER s/!numbered_i ||/1'b1 ||/
// control: ANY_FOLLOWS s/follows_i \&\&/1'b1 \&\&/
// control: ANY_CHECK s/ \&\& holds;/;/
// control: SHORT_CHECK s/{5.d0, top, 3.d0}/16'd0/
// control: ENDLESS_CHECK s/begins_q <= complete_i \&\& last_i/begins_q <= 1'b0/
// control: ANY_DIGEST s/begins_q ? digest_i : check_q/begins_q ? 16'd0 : check_q/
// control: DIGEST_OF_FRAMES s/begins_q <= complete_i \&\& last_i/begins_q <= complete_i/
// control: DIGEST_ONCE s/begins_q <= 1'b1;/begins_q <= begins_q;/
// control: CHECKS_NUMBER s/if (numbered_i || checked_i)/if (checked_i)/
// control: FAULT_GOES s/if (held_q \&\& !cut) fault_o/if (held_q) fault_o/
// control: LOSES_WORD s/assign ready_o  = !held_q || pass_o/assign ready_o  = !held_q || valid_o/
// control: COUNTS_WORDS s/if (pass_o \&\& complete_i) sequence_q/if (pass_o) sequence_q/
// control: BLOCKS_BUS s/|| pass_o || cut;/|| pass_o;/
// control: NO_RESET s/sequence_q <= '0;/sequence_q <= sequence_q;/
`default_nettype none
module frame_entry_formal (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        valid_i,
    input wire logic [ 1:0] tag_i,
    input wire logic [ 7:0] above_i,     // the number, or a check
    input wire logic        can_be_i,
    input wire logic        numbered_i,
    input wire logic        checked_i,
    input wire logic        follows_i,
    input wire logic        complete_i,
    input wire logic        last_i,
    input wire logic [15:0] digest_i,
    input wire logic        cut_i,
    input wire logic        wait_i,
    input wire logic        ready_i,
    input wire logic [ 1:0] next_tag_i
);

  logic [3:0] taken_q;  // words that came
  logic [3:0] passed_q;
  logic [7:0] frames_q;
  logic held_q;
  logic [1:0] tag_q;  // that the next word must have

  logic ready;
  logic valid;
  logic pass;
  logic [47:0] data;
  logic frame;
  logic [1:0] fault;
  frame_entry u_dut (
      .clk_i,
      .rst_ni,
      .valid_i,
      .ready_o(ready),
      .data_i({
        2'b10,
        tag_i,
        above_i,
        26'b0,
        last_i,
        checked_i,
        follows_i,
        can_be_i,
        numbered_i,
        complete_i,
        taken_q
      }),
      .digest_i,
      .cut_i,
      .wait_i,
      .valid_o(valid),
      .ready_i,
      .data_o(data),
      .tag_i({2'b10, tag_q}),
      .can_be_i(data[6]),
      .numbered_i(data[5]),
      .checked_i(checked),
      .follows_i(data[7]),
      .complete_i(data[4]),
      .last_i(data[9]),
      .pass_o(pass),
      .frame_o(frame),
      .fault_o(fault)
  );

  logic tagged_so;
  logic can_be;
  logic follows;
  logic cut;
  assign tagged_so = data[47:44] == {2'b10, tag_q};
  assign can_be    = tagged_so && data[6] && (!checked || data[43:36] == (crc[15:8] ^ crc[7:0]));
  assign follows   = data[7] && (!data[5] || data[43:36] == frames_q);
  assign cut       = cut_i || fault != 2'b00;

  // The check of the word, bit by bit
  logic checked;
  logic first_q;  // a program's first word has to come
  logic [15:0] crc_q;
  logic [15:0] crc;
  logic [47:0] counted;
  assign checked = data[8] && !data[5];
  always_comb begin
    counted = data;
    if (checked || data[5]) counted[43:36] = '0;
    crc = first_q ? digest_i : crc_q;
    for (int n = 0; n < 8; n = n + 1) crc = {crc[14:0], 1'b0} ^ (crc[15] ? 16'h9 : 16'h0);
    crc = crc ^ {4'b0, counted[43:32]} ^ counted[31:16] ^ counted[15:0];
  end

  logic started_q = 1'b0;
  logic ran_q;  // no reset in the clock before
  logic cut_q;
  logic others_q;
  logic ends_q;
  logic [1:0] fault_q;
  logic [1:0] cause_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    ran_q     <= rst_ni;
    cut_q     <= rst_ni && cut;
    others_q  <= rst_ni && cut_i;
    ends_q    <= rst_ni && valid && ready_i && data[4];
    fault_q   <= rst_ni ? fault : 2'b00;
    cause_q   <= rst_ni && held_q && !cut ? {can_be && !follows, !can_be} : 2'b00;
    if (!rst_ni) begin
      taken_q  <= '0;
      passed_q <= '0;
      frames_q <= '0;
      held_q   <= 1'b0;
      first_q  <= 1'b1;
      crc_q    <= '0;
    end else begin
      if (valid && ready_i) begin
        held_q   <= 1'b0;
        passed_q <= passed_q + 4'd1;
        first_q  <= data[4] && data[9];
        crc_q    <= crc;
        tag_q    <= next_tag_i;
        if (data[4]) frames_q <= frames_q + 8'd1;
      end
      if (valid_i && ready && !cut) begin
        held_q  <= 1'b1;
        taken_q <= taken_q + 4'd1;
      end
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (others_q) assume (cut_i);

      if (!ran_q) AfterReset : assert (!valid && ready && !frame && fault == 2'b00);
      Passes : assert (valid == (held_q && can_be && follows && !cut && !wait_i));
      Told : assert (pass == (valid && ready_i));
      if (valid) InOrder : assert (data[3:0] == passed_q);
      if (!cut) NoneLost : assert (held_q == (taken_q != passed_q));
      if (cut_q) NothingPasses : assert (!valid && ready);
      Frame : assert (frame == ends_q);
      Cause : assert (fault == (fault_q | cause_q));

      SecondFrame : cover (valid && data[5] && frames_q == 8'd1);
      Missing : cover (fault == 2'b10 && frames_q == 8'd1);
      Checked : cover (valid && checked && passed_q == 4'd2 && data[43:36] != '0);
    end
  end

endmodule
`default_nettype wire
