// SPDX-License-Identifier: Apache-2.0
// rtl/path/serial_share.sv: every tick gives its 2^n samples in order, none lost or doubled, only
// when they are wanted; offers stay, and the clock after; nothing gets stuck. Ticks are numbered
// through their rates.
// control: ONE_TOO_MANY s/{more_q\[13:0\], 1'b1}/{more_q[12:0], 2'b11}/
// control: LOSES_TICK s/assign tick_ready_o = !busy_q/assign tick_ready_o = 1'b1/
// control: UNWANTED s/ \&\& wanted_i//
// control: LOSES_SAMPLE s/ \&\& !sample_valid_o;/;/
// control: NO_RESET s/sample_valid_o <= 1'b0;//
// forget: u_dut.rate_q u_dut.left_q u_dut.more_q unless u_dut.busy_q
`default_nettype none
module serial_share_formal (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic [ 1:0] n_i,
    input wire logic        tick_valid_i,
    input wire logic [47:0] tick_ds_i,
    input wire logic        wanted_i,
    input wire logic        sample_ready_i
);

  logic [3:0] tick_number_q;
  logic tick_ready;
  logic sent;
  logic sample_valid;
  logic [47:0] sample_ds;
  logic [17:0] sample_rate;
  logic path_valid;
  logic [63:0] path;
  serial_share u_dut (
      .clk_i,
      .rst_ni,
      .samples_per_tick_log2_i({2'b0, n_i}),
      .tick_valid_i,
      .tick_ready_o(tick_ready),
      .tick_ds_i,
      .tick_rate_i({14'b0, tick_number_q}),
      .wanted_i,
      .sent_o(sent),
      .sample_valid_o(sample_valid),
      .sample_ready_i,
      .sample_ds_o(sample_ds),
      .sample_rate_o(sample_rate),
      .path_valid_o(path_valid),
      .path_o(path)
  );
  logic unused;
  assign unused = ^{sample_ds, path};

  logic started_q = 1'b0;
  logic [1:0] n_q;
  logic kept_q;
  logic taken_q;
  logic [3:0] taken_tick_q;
  localparam int Idle = 8;
  logic [Idle-1:0] idle_q;  // cycles in which a sample was possible and none came
  logic [2:0] sample_index_q;
  logic [3:0] sample_tick_q;
  logic [3:0] ticks_inside;
  assign ticks_inside = tick_number_q - sample_tick_q;
  logic last;
  assign last = sample_index_q == (3'd1 << n_i) - 3'd1;
  always_ff @(posedge clk_i) begin
    started_q    <= 1'b1;
    n_q          <= n_i;
    taken_q      <= rst_ni && sample_valid && sample_ready_i;
    taken_tick_q <= sample_tick_q;
    kept_q       <= rst_ni && sample_valid && !sample_ready_i;
    idle_q       <= {idle_q[Idle-2:0], rst_ni && ticks_inside != '0 && wanted_i && !sample_valid};
    if (!rst_ni) begin
      tick_number_q  <= '0;
      sample_index_q <= '0;
      sample_tick_q  <= '0;
    end else begin
      if (tick_valid_i && tick_ready) tick_number_q <= tick_number_q + 1'b1;
      if (sample_valid && sample_ready_i) begin
        sample_index_q <= last ? '0 : sample_index_q + 1'b1;
        if (last) sample_tick_q <= sample_tick_q + 1'b1;
      end
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else begin
      assume (n_i == n_q);
      if (rst_ni) begin
        FewInside : assert (ticks_inside <= 4'd2);
        if (sample_valid) InOrder : assert (sample_rate == {14'b0, sample_tick_q});
        if (sample_valid) NothingInvented : assert (ticks_inside != '0);
        Told : assert (path_valid == taken_q);
        if (path_valid) OfTheSample : assert (sample_rate == {14'b0, taken_tick_q});
        if (kept_q) KeepsOffer : assert (sample_valid);
        if (sent) Wanted : assert (wanted_i);
        if (idle_q == '1) NeverStuck : assert (sample_valid);
        if (ticks_inside == '0) TakesTick : assert (tick_ready);

        ThirdTick : cover (sample_valid && sample_tick_q == 4'd2 && n_i == 2'd2);
        Tells : cover (path_valid && !tick_ready && sample_tick_q == 4'd2);
      end
    end
  end

endmodule
`default_nettype wire
