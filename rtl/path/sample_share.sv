// SPDX-License-Identifier: Apache-2.0
// Shares each tick's increment among its 2^n samples: after j of them, floor(j ds / 2^n) is gone.
// Twin: SampleShare of hls/path_kernel.hpp.
//
//   clock            0         1       2       3
//   tick_valid_i     1
//   tick_ready_o     1
//   wanted_i                           1
//   sample_valid_o                             1       until sample_ready_i has taken it
//   sample_ds_o                                ds/2^n
//
// One sample per clock, at tick boundaries too. A sample is sent only when it is wanted: wanted_i
// is true as long as more samples are asked for than sample_sent_o told. n stands still.
`default_nettype none
module sample_share (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic [3:0] samples_per_tick_log2_i,  // n

    // Ticks
    input  wire logic        tick_valid_i,
    output logic             tick_ready_o,
    input  wire logic [47:0] tick_ds_i,
    input  wire logic [16:0] tick_rate_i,

    // Samples
    input  wire logic        wanted_i,
    output logic             sent_o,          // a sample enters the output
    output logic             sample_valid_o,
    input  wire logic        sample_ready_i,
    output logic      [47:0] sample_ds_o,
    output logic      [16:0] sample_rate_o
);

  logic [14:0] mask;
  assign mask = ~(15'h7fff << samples_per_tick_log2_i);

  // A tick's whole share and what remains of its division
  logic share_valid_q;
  logic share_ready;
  logic [47:0] whole_q;
  logic [14:0] rest_q;
  logic [16:0] rate_q;

  logic [14:0] index_q;
  logic [14:0] fraction_q;
  logic [15:0] sum;
  logic [15:0] carried;
  logic carry;
  assign sum = {1'b0, fraction_q} + {1'b0, rest_q};
  assign carried = sum >> samples_per_tick_log2_i;
  assign carry = carried[0];

  assign sent_o = share_valid_q && wanted_i && (!sample_valid_o || sample_ready_i);
  logic last;
  assign last = index_q == mask;
  assign share_ready = sent_o && last;
  assign tick_ready_o = !share_valid_q || share_ready;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      share_valid_q  <= 1'b0;
      index_q        <= '0;
      fraction_q     <= '0;
      sample_valid_o <= 1'b0;
    end else begin
      if (tick_ready_o) share_valid_q <= tick_valid_i;
      if (sent_o) begin
        index_q    <= last ? '0 : index_q + 1'b1;
        fraction_q <= sum[14:0] & mask;
      end
      if (sent_o || sample_ready_i) sample_valid_o <= sent_o;
    end
  end

  always_ff @(posedge clk_i) begin
    if (tick_ready_o) begin
      whole_q <= tick_ds_i >> samples_per_tick_log2_i;
      rest_q  <= tick_ds_i[14:0] & mask;
      rate_q  <= tick_rate_i;
    end
    if (sent_o) begin
      sample_ds_o   <= whole_q + {47'b0, carry};
      sample_rate_o <= rate_q;
    end
  end

endmodule
`default_nettype wire
