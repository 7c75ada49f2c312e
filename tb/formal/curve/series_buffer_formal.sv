// SPDX-License-Identifier: Apache-2.0
// rtl/sampler/series_buffer.sv: a bank is not written while a sample may read it, every step is
// offered once, in order and with its own words, room as soon as a bank is free. Steps are numbered
// through their words, modulo more than the buffer counts.
// control: OVERWRITES s/used < 3'd4/used < 3'd5/
// control: NO_ROOM s/used < 3'd4/used < 3'd3/
// control: OFFERS_EARLY s/next_valid_o = .*/next_valid_o = 1'b1;/
// control: WRONG_BANK s/stride_memory\[next_step\[1:0\]\]/stride_memory[current_step_i[1:0]]/
// control: NO_RESET s/oldest_q <= 3'd7;//
`default_nettype none
module series_buffer_formal (
    input wire logic       clk_i,
    input wire logic       rst_ni,
    input wire logic       write_i,
    input wire logic       move_i,
    input wire logic       leave_i,
    input wire logic [2:0] leave_behind_i,
    input wire logic [2:0] look_behind_i
);

  localparam int Bits = curvecore_pkg::StepBits;

  // Steps written, the one samples are in, and the oldest with a sample under way.
  logic [4:0] written_q;
  logic [4:0] current_q;
  logic [4:0] oldest_q;
  logic [4:0] leave;
  logic [4:0] look;
  logic [4:0] behind;
  assign behind = current_q - oldest_q;
  assign leave  = current_q - {2'b0, leave_behind_i};
  assign look   = current_q - {2'b0, look_behind_i};

  logic room;
  logic [2:0] write_step;
  logic next_valid;
  logic [Bits:0] next_stride;
  logic look_last;
  logic [4:0] look_k;
  logic [Bits-1:0] look_offset;
  series_buffer u_dut (
      .clk_i,
      .rst_ni,
      .room_o(room),
      .write_step_o(write_step),
      .write_i,
      .last_i(written_q[0]),
      .k_i(written_q),
      .offset_i({{(Bits - 5) {1'b0}}, written_q}),
      .stride_i({{(Bits - 4) {1'b0}}, written_q}),
      .current_step_i(current_q[2:0]),
      .next_valid_o(next_valid),
      .next_stride_o(next_stride),
      .look_step_i(look[2:0]),
      .look_last_o(look_last),
      .look_k_o(look_k),
      .look_offset_o(look_offset),
      .leave_i,
      .leave_step_i(leave[2:0])
  );

  logic started_q = 1'b0;
  logic before_q;  // the oldest step is none, but the one before the first
  logic [4:0] next;
  logic [4:0] used;
  assign next = current_q + 5'd1;
  assign used = written_q - oldest_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!rst_ni) begin
      written_q <= '0;
      current_q <= '1;
      oldest_q  <= '1;
      before_q  <= 1'b1;
    end else begin
      if (write_i) written_q <= written_q + 5'd1;
      if (move_i) current_q <= next;
      if (leave_i) oldest_q <= leave;
      if (leave_i && leave != '1) before_q <= 1'b0;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (!room) assume (!write_i);
      if (!next_valid) assume (!move_i);
      if (leave_i) assume ({2'b0, leave_behind_i} <= behind);
      assume ({2'b0, look_behind_i} <= behind);

      FourBanks : assert (used <= 5'd4);
      Room : assert (room == (used != 5'd4));
      NeverAhead : assert (behind < used);
      Offers : assert (next_valid == (next != written_q));
      Place : assert (write_step == written_q[2:0]);
      if (next_valid) OwnStride : assert (next_stride[4:0] == next);
      if (look != '1 || !before_q) begin
        OwnWords : assert (look_last == look[0] && look_k == look && look_offset[4:0] == look);
      end

      Fills : cover (!room && !before_q && next == written_q && behind == 5'd3);
      GoesRound : cover (written_q == 5'd9 && behind == 5'd2);
    end
  end

endmodule
`default_nettype wire
