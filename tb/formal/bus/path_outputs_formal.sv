// SPDX-License-Identifier: Apache-2.0
// rtl/output/path_outputs.sv: without enable_i nothing is on, in that clock and in all until a word
// has come; a flush leaves on what is on with keep_i, and nothing without it; a word is taken in
// its order alone, and six clocks after another while there is room.
// control: STAYS_ON s/bits_q   <= '0;//
// control: ON_WHEN_OFF s/bits_q & {8{enable_i}}/bits_q/
// control: PWM_WHEN_OFF s/on_q && enable_i/on_q/
// control: ANY_ORDER s/\+:4\] == number_q/+:4] >= number_q/
// control: FLUSHED_OFF s/else if (apply) begin/else if (apply || flush_i) begin/
// control: READS_FIRST s/&& !takes//
`default_nettype none
module path_outputs_formal (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        flush_i,
    input wire logic        keep_i,
    input wire logic        valid_i,
    input wire logic [47:0] word_i,
    input wire logic        made_i,
    input wire logic [31:0] path_i,
    input wire logic        taken_i,
    input wire logic        drawn_i,
    input wire logic        enable_i
);

  logic is_next, ready, pwm, settled;
  logic [15:0] room;
  logic [ 7:0] bits;
  logic [11:0] power;
  path_outputs #(
      .Words(64)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .flush_i,
      .keep_i,
      .valid_i,
      .word_i,
      .next_o(is_next),
      .ready_o(ready),
      .room_o(room),
      .made_i,
      .path_i,
      .taken_i,
      .drawn_i,
      .enable_i,
      .delay_write_i(1'b0),
      .delay_i('0),
      .settled_o(settled),
      .bits_o(bits),
      .power_o(power),
      .pwm_o(pwm)
  );

  logic started_q = 1'b0;
  logic took_q;  // a word since the reset, or since it was enabled
  logic flush_q;
  logic kept_q;  // through two clocks of a flush, while enabled
  logic [7:0] bits_q;
  logic [3:0] count_q;
  logic [2:0] since_q;  // clocks since the last one, up to 6
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    flush_q   <= flush_i;
    kept_q    <= rst_ni && enable_i && flush_i && flush_q && keep_i;
    bits_q    <= bits;
    if (!rst_ni || !enable_i || (flush_i && !keep_i)) took_q <= 1'b0;
    if (!rst_ni || !enable_i || flush_i) begin
      count_q <= '0;
      since_q <= 3'd6;
    end else if (is_next && ready) begin
      took_q  <= 1'b1;
      count_q <= count_q + 1'b1;
      since_q <= 3'd1;
    end else if (since_q != 3'd6) since_q <= since_q + 1'b1;
    if (!started_q)
      assume (!rst_ni);
      else begin
        if (!enable_i) assert (bits == '0 && !pwm);
        if (!took_q) assert (bits == '0 && power == '0 && !pwm);
        if (kept_q && enable_i) assert (bits == bits_q);
        if (is_next) assert (word_i[47:44] == 4'd15 && word_i[43:40] == count_q);
        if (is_next) assert (word_i[39:38] != 2'd3);
        if (since_q == 3'd6 && room != '0) assert (ready);
        if (room == '0) assert (!ready);
        cover (bits == 8'd5 && pwm && count_q == 4'd3);
      end
  end

endmodule
`default_nettype wire
