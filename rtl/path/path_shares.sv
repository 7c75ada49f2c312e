// SPDX-License-Identifier: Apache-2.0
// Increments of samples from those of ticks (rtl/path/sample_share.sv), and the path travelled with
// them: path_valid_o once per sample, up to 2 clocks after it is taken.
`default_nettype none
module path_shares #(
    parameter int Room = 64  // [8, 128] waiting ticks
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic [3:0] samples_per_tick_log2_i,

    // Ticks
    input wire logic        tick_valid_i,
    input wire logic [47:0] tick_ds_i,
    input wire logic [17:0] tick_rate_i,

    // Samples
    input  wire logic        wanted_i,
    output logic             sent_o,
    output logic             sample_valid_o,
    input  wire logic        sample_ready_i,
    output logic      [47:0] sample_ds_o,
    output logic      [17:0] sample_rate_o,

    // The path
    output logic        path_valid_o,
    output logic [47:0] path_ds_o,
    output logic [17:0] path_rate_o,
    output logic [63:0] path_o
);

  logic unused_room;
  logic share_valid;
  logic share_ready;
  logic [65:0] share;
  word_queue #(
      .Bits (66),
      .Depth(Room)
  ) u_ds_queue (
      .clk_i,
      .rst_ni,
      .valid_i(tick_valid_i),
      .ready_o(unused_room),
      .data_i ({tick_rate_i, tick_ds_i}),
      .valid_o(share_valid),
      .ready_i(share_ready),
      .data_o (share)
  );
  sample_share u_share (
      .clk_i,
      .rst_ni,
      .samples_per_tick_log2_i,
      .tick_valid_i(share_valid),
      .tick_ready_o(share_ready),
      .tick_ds_i   (share[47:0]),
      .tick_rate_i (share[65:48]),
      .wanted_i,
      .sent_o,
      .sample_valid_o,
      .sample_ready_i,
      .sample_ds_o,
      .sample_rate_o
  );
  path_meter u_meter (
      .clk_i,
      .rst_ni,
      .move_i (sample_valid_o && sample_ready_i),
      .ds_i   (sample_ds_o),
      .rate_i (sample_rate_o),
      .valid_o(path_valid_o),
      .ds_o   (path_ds_o),
      .rate_o (path_rate_o),
      .path_o
  );

endmodule
`default_nettype wire
