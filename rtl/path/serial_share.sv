// SPDX-License-Identifier: Apache-2.0
// The serial build's rtl/path/sample_share.sv and rtl/path/path_meter.sv: shares a tick's increment
// among its 2^n samples, and adds up the path. After j samples of a tick floor(j ds / 2^n) is gone.
// Twin: SampleShare of hls/path_kernel.hpp.
//
//   clock            0         n + 1     n + 2
//   tick_valid_i     1
//   tick_ready_o     1                   1         0 until all of its samples are sent
//   wanted_i                   1
//   sent_o                     1
//   sample_valid_o                       1         until sample_ready_i has taken it
//   sample_ds_o                          ds/2^n
//
// A clock after a sample is taken path_valid_o reports the path with it; sample_ds_o and
// sample_rate_o are still its own: a sample every 2 clocks, at most. With the tick that waits in
// rtl/path/path_sequencer.sv three samples are ready for a core that has made a step meanwhile.
`default_nettype none
module serial_share (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic [3:0] samples_per_tick_log2_i,  // n

    // Ticks
    input  wire logic        tick_valid_i,
    output logic             tick_ready_o,
    input  wire logic [47:0] tick_ds_i,
    input  wire logic [17:0] tick_rate_i,

    // Samples
    input  wire logic        wanted_i,
    output logic             sent_o,          // a sample enters the output
    output logic             sample_valid_o,
    input  wire logic        sample_ready_i,
    output logic      [47:0] sample_ds_o,
    output logic      [17:0] sample_rate_o,

    // The path
    output logic        path_valid_o,
    output logic [63:0] path_o
);

  logic busy_q;
  logic [3:0] left_q;  // bits to shift
  logic [14:0] more_q;  // samples after this one, of the tick
  logic shared;
  logic taken;
  logic last;
  assign tick_ready_o = !busy_q;
  assign shared = busy_q && left_q == '0;
  assign sent_o = shared && wanted_i && !sample_valid_o;
  assign taken = sample_valid_o && sample_ready_i;
  assign last = more_q == '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      busy_q         <= 1'b0;
      sample_valid_o <= 1'b0;
      path_valid_o   <= 1'b0;
    end else begin
      busy_q         <= busy_q ? !(sent_o && last) : tick_valid_i;
      sample_valid_o <= sent_o || (sample_valid_o && !sample_ready_i);
      path_valid_o   <= taken;
    end
  end

  // ds / 2^n: 48 bits, and its fraction, 15 bits. Fractions add up; their carry is a quantum.
  logic [62:0] share_q;
  logic [62:0] sum;
  logic [17:0] rate_q;
  logic [14:0] fraction_q;
  assign sum = share_q + {48'b0, fraction_q};
  always_ff @(posedge clk_i) begin
    if (!busy_q) begin
      share_q <= {tick_ds_i, 15'b0};
      rate_q  <= tick_rate_i;
      left_q  <= samples_per_tick_log2_i;
      more_q  <= '0;
    end else if (left_q != '0) begin
      share_q <= share_q >> 1;
      left_q  <= left_q - 1'b1;
      more_q  <= {more_q[13:0], 1'b1};
    end else if (sent_o) begin
      more_q <= more_q - 1'b1;
    end
    if (sent_o) begin
      sample_ds_o   <= sum[62:15];
      sample_rate_o <= rate_q;
    end
    if (!rst_ni) fraction_q <= '0;
    else if (sent_o) fraction_q <= sum[14:0];
    if (!rst_ni) path_o <= '0;
    else if (taken) path_o <= path_o + {16'b0, sample_ds_o};
  end

endmodule
`default_nettype wire
