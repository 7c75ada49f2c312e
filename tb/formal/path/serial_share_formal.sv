// SPDX-License-Identifier: Apache-2.0
// rtl/path/serial_share.sv: every tick gives its 2^n samples as numbered_ticks.sv says; a sample is
// reported, and its rate stands, in the clock after it was taken.
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

  logic [17:0] tick_rate;
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
      .tick_rate_i(tick_rate),
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

  logic [3:0] tick;
  logic checks;
  numbered_ticks #(
      .Inside(2),
      .Idle  (8)
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

  logic taken_q;
  logic [3:0] taken_tick_q;
  always_ff @(posedge clk_i) begin
    taken_q      <= rst_ni && sample_valid && sample_ready_i;
    taken_tick_q <= tick;
  end

  always_comb begin
    if (checks) begin
      Told : assert (path_valid == taken_q);
      if (path_valid) OfTheSample : assert (sample_rate == {14'b0, taken_tick_q});

      Tells : cover (path_valid && !tick_ready && tick == 4'd2);
    end
  end

endmodule
`default_nettype wire
