// SPDX-License-Identifier: Apache-2.0
// rtl/engine/engine_entry.sv: of each stream words come out as they went in, none lost, doubled or
// overtaken, whatever the other stream does; each holds what it is asked to. Words are numbered,
// modulo more than a ring holds, and have the bit of their stream.
// control: OVERFLOWS s/segment_ready_o = segment_room != '0/segment_ready_o = 1'b1/
// control: ONE_RING s/profile_put, profile_put ? profile_put_q/1'b0, profile_put ? profile_put_q/
// control: BOTH_AT_ONCE s/ \&\& !segment_put;/ || !segment_put;/
// control: ROOM_OF_OTHER s/profile_room = (profile_take_q/profile_room = (segment_take_q/
// control: OTHER_TAKEN s/take_i \&\& of_profile_i) profile/take_i) profile/
// control: LOSES_WORD s/if (segment_put) segment_put_q/if (segment_put \&\& !take_i) segment_put_q/
// control: NEVER_WAITS s/profile_waits_o = .*/profile_waits_o = 1'b0;/
// control: NO_RESET s/      segment_take_q <= '0;//
`default_nettype none
module engine_entry_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic segment_valid_i,
    input wire logic profile_valid_i,
    input wire logic of_profile_i,
    input wire logic take_i
);

  localparam int Words = 4;
  localparam int Bits = 3;

  logic [Bits-1:0] sent_q [2];
  logic [Bits-1:0] taken_q[2];
  logic segment_ready, profile_ready, segment_waits, profile_waits;
  logic [15:0] segment_room, profile_room;
  logic [47:0] word;
  engine_entry #(
      .Words(Words)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .segment_valid_i,
      .segment_ready_o(segment_ready),
      .segment_room_o (segment_room),
      .segment_i      ({44'd0, 1'b0, sent_q[0]}),
      .profile_valid_i,
      .profile_ready_o(profile_ready),
      .profile_room_o (profile_room),
      .profile_i      ({44'd0, 1'b1, sent_q[1]}),
      .of_profile_i,
      .word_o         (word),
      .take_i,
      .segment_waits_o(segment_waits),
      .profile_waits_o(profile_waits)
  );

  logic [Bits-1:0] held[2];
  assign held[0] = sent_q[0] - taken_q[0];
  assign held[1] = sent_q[1] - taken_q[1];

  logic started_q = 1'b0;
  logic shown_q;  // the word at hand waited a clock ago, and is the same
  logic profile_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    profile_q <= of_profile_i;
    shown_q   <= rst_ni && !take_i && held[of_profile_i] != '0;
    if (!rst_ni) begin
      sent_q[0]  <= '0;
      sent_q[1]  <= '0;
      taken_q[0] <= '0;
      taken_q[1] <= '0;
    end else begin
      if (segment_valid_i && segment_ready) sent_q[0] <= sent_q[0] + 1'b1;
      if (profile_valid_i && profile_ready) sent_q[1] <= sent_q[1] + 1'b1;
      if (take_i) taken_q[of_profile_i] <= taken_q[of_profile_i] + 1'b1;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (held[of_profile_i] == '0) assume (!take_i);

      HoldsWhatFits : assert (held[0] <= Bits'(Words) && held[1] <= Bits'(Words));
      SegmentRoom : assert (segment_room == 16'(Words) - 16'(held[0]));
      ProfileRoom : assert (profile_room == 16'(Words) - 16'(held[1]));
      SegmentsEnter : assert (segment_ready == (held[0] != Bits'(Words)));
      ProfileEnters :
      assert (profile_ready == (held[1] != Bits'(Words) && !(segment_valid_i && segment_ready)));
      Waits : assert (segment_waits == (held[0] != '0) && profile_waits == (held[1] != '0));
      if (shown_q && profile_q == of_profile_i)
        InOrder : assert (word == {44'd0, of_profile_i, taken_q[of_profile_i]});

      Fills : cover (held[0] == Bits'(Words) && held[1] == Bits'(Words));
      Streams : cover (taken_q[0] == 3'd7 && taken_q[1] == 3'd7 && take_i && shown_q);
    end
  end

endmodule
`default_nettype wire
