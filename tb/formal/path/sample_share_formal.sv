// SPDX-License-Identifier: Apache-2.0
// rtl/path/sample_share.sv: every tick gives its 2^n samples as numbered_ticks.sv says, one in
// each clock.
// control: ONE_TOO_MANY s/last ? '0 : index_q + 1'b1/last ? 15'h7fff : index_q + 1'b1/
// control: LOSES_TICK s/assign tick_ready_o = advance/assign tick_ready_o = 1'b1/
// control: UNWANTED s/ \&\& wanted_i//
// control: NO_RESET s/index_q        <= '0;//
// forget: u_dut.coarse_rate_q unless u_dut.coarse_valid_q
// forget: u_dut.fine_rate_q unless u_dut.fine_valid_q
// forget: u_dut.share_rate_q unless u_dut.share_valid_q
// forget: u_dut.rate_q unless u_dut.sum_valid_q
// forget: u_dut.sample_rate_o unless u_dut.sample_valid_o
`default_nettype none
module sample_share_formal (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic [ 1:0] n_i,
    input wire logic        tick_valid_i,
    input wire logic [47:0] tick_ds_i,
    input wire logic        wanted_i,
    input wire logic        sample_ready_i
);

  logic [17:0] tick_rate;
  logic tick_ready;
  logic sent;
  logic sample_valid;
  logic [47:0] sample_ds;
  logic [17:0] sample_rate;
  sample_share u_dut (
      .clk_i,
      .rst_ni,
      .samples_per_tick_log2_i({2'b0, n_i}),
      .tick_valid_i,
      .tick_ready_o(tick_ready),
      .tick_ds_i,
      .tick_rate_i(tick_rate),
      .wanted_i,
      .sent_o(sent),
      .sample_valid_o(sample_valid),
      .sample_ready_i,
      .sample_ds_o(sample_ds),
      .sample_rate_o(sample_rate)
  );
  logic unused;
  assign unused = ^sample_ds;

  logic [3:0] tick;
  logic checks;
  numbered_ticks #(
      .Inside(5),
      .Idle  (4)
  ) u_ticks (
      .clk_i,
      .rst_ni,
      .n_i,
      .tick_valid_i,
      .tick_ready_i  (tick_ready),
      .wanted_i,
      .sent_i        (sent),
      .sample_valid_i(sample_valid),
      .sample_ready_i,
      .sample_rate_i (sample_rate),
      .tick_rate_o   (tick_rate),
      .tick_o        (tick),
      .checks_o      (checks)
  );

  always_comb begin
    if (checks) Streams : cover (tick == 4'd3 && tick_ready && sample_valid && n_i == 2'd0);
  end

endmodule
`default_nettype wire
