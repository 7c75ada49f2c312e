// SPDX-License-Identifier: Apache-2.0
// Sharer of each tick's increment among its 2^n samples: after j of them floor(j ds / 2^n) is gone.
// Twin: SampleShare of hls/path_kernel.hpp.
//
//   clock            0         1       3       5
//   tick_valid_i     1
//   tick_ready_o     1
//   wanted_i                           1
//   sample_valid_o                             1       until sample_ready_i has taken it
//   sample_ds_o                                ds/2^n
//
// One sample per clock, at tick boundaries too. A sample is sent only when it is wanted: wanted_i
// is 1 while more samples are requested than sent_o has reported. n is constant.
`default_nettype none
module sample_share (
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
    output logic      [17:0] sample_rate_o
);

  logic [14:0] mask_q;
  always_ff @(posedge clk_i) mask_q <= ~(15'h7fff << samples_per_tick_log2_i);

  // ds / 2^n: 48 bits, and its fraction, 15 bits
  logic share_valid;
  logic [62:0] share_q;
  logic [17:0] share_rate_q;
  logic [62:0] ds;
  assign ds = {tick_ds_i, 15'b0};

  logic [14:0] index_q;
  logic last;
  assign last = index_q == mask_q;
  logic advance;
  logic coarse_valid_q;
  logic fine_valid_q;
  logic share_valid_q;
  logic [62:0] coarse_q;
  logic [62:0] fine_q;
  logic [17:0] coarse_rate_q;
  logic [17:0] fine_rate_q;
  assign share_valid = share_valid_q;
  assign advance = !share_valid_q || (sent_o && last);
  assign tick_ready_o = advance;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      coarse_valid_q <= 1'b0;
      fine_valid_q   <= 1'b0;
      share_valid_q  <= 1'b0;
    end else if (advance) begin
      coarse_valid_q <= tick_valid_i;
      fine_valid_q   <= coarse_valid_q;
      share_valid_q  <= fine_valid_q;
    end
  end
  always_ff @(posedge clk_i) begin
    if (advance) begin
      coarse_q      <= ds >> {samples_per_tick_log2_i[3:2], 2'b0};
      coarse_rate_q <= tick_rate_i;
      fine_q        <= coarse_q >> samples_per_tick_log2_i[1:0];
      fine_rate_q   <= coarse_rate_q;
      share_q       <= fine_q;
      share_rate_q  <= fine_rate_q;
    end
  end

  // Fractions add up; their carry is a quantum.
  logic [14:0] fraction_q;
  logic [15:0] sum;
  assign sum = {1'b0, fraction_q} + {1'b0, share_q[14:0]};
  logic sum_valid_q;
  logic sum_ready;
  logic carry_q;
  logic [47:0] whole_q;
  logic [17:0] rate_q;
  assign sum_ready = !sum_valid_q || !sample_valid_o || sample_ready_i;
  assign sent_o = share_valid && wanted_i && sum_ready;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      index_q        <= '0;
      fraction_q     <= '0;
      sum_valid_q    <= 1'b0;
      sample_valid_o <= 1'b0;
    end else begin
      if (sent_o) begin
        index_q    <= last ? '0 : index_q + 1'b1;
        fraction_q <= sum[14:0];
      end
      if (sum_ready) sum_valid_q <= sent_o;
      if (!sample_valid_o || sample_ready_i) sample_valid_o <= sum_valid_q;
    end
  end
  always_ff @(posedge clk_i) begin
    if (sent_o) begin
      carry_q <= sum[15];
      whole_q <= share_q[62:15];
      rate_q  <= share_rate_q;
    end
    if (!sample_valid_o || sample_ready_i) begin
      sample_ds_o   <= whole_q + {47'b0, carry_q};
      sample_rate_o <= rate_q;
    end
  end

endmodule
`default_nettype wire
