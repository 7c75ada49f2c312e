// SPDX-License-Identifier: Apache-2.0
// Samples as frames of XY2-100, for the scan heads of lasers: each sample period has a frame with
// the positions of the first three axes, 20 bits in parallel.
//
//   bit        0    1    2    3   ..  18   19
//   data_o     0    0    1   15   ..   0   parity
//   sync_o     1    1    1    1   ..   1    0
//   clock_o    1 0  1 0  1 0  1 0 ..  1 0  1 0       a receiver samples as it falls
//
// Bits 15 .. 0: the upper 16 bits of the position, rounded, in a scan head's count: 8000 is the
// middle of its field, so 2^FineBits units are the field. The parity makes the ones of a frame
// even. Between samples, and without them, the last frame is repeated.
//
//   clock               0     n           n + 2^PeriodLog2
//   sample_taken_i      1
//   tick_i                    1           1
//   data_o, ..                  its frame
//
// A bit is 2^PeriodLog2 / 20 clocks, its edges to the clock above. Scan heads take 95 to 110
// thousand frames a second: 2^9 clocks at 50 MHz are 97,656. Twin: xy2_frame of hls/xy2_frame.hpp.
`default_nettype none
module xy2_100 #(
    parameter int Axes       = 3,   // [3, 9]
    parameter int FineBits   = 42,  // [18, 44] bits of a position
    parameter int PeriodLog2 = 9    // [7, 20]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Samples, axis 0 in the low bits
    input wire logic                     tick_i,
    input wire logic                     sample_taken_i,
    input wire logic [Axes*FineBits-1:0] sample_i,

    // Pins, with differential drivers behind them
    output logic       clock_o,
    output logic       sync_o,
    output logic [2:0] data_o
);

  initial if (Axes < 3 || Axes > 9) $fatal(1, "Axes must be in [3, 9]");
  initial if (FineBits < 18 || FineBits > 44) $fatal(1, "FineBits must be in [18, 44]");
  initial if (PeriodLog2 < 7 || PeriodLog2 > 20) $fatal(1, "PeriodLog2 must be in [7, 20]");

  localparam int Halves = 40;  // halves of bits in a frame

  // The present half of a bit
  logic [PeriodLog2-1:0] share_q;
  logic [PeriodLog2:0] share;
  logic [5:0] half_q;
  logic [4:0] index;
  logic begins_q;  // a half
  assign share = {1'b0, share_q} + (PeriodLog2 + 1)'(Halves);
  assign index = half_q[5:1];
  always_ff @(posedge clk_i) begin
    if (!rst_ni || tick_i) begin
      share_q <= '0;
      half_q  <= '0;
    end else begin
      share_q <= share[PeriodLog2-1:0];
      if (share[PeriodLog2]) half_q <= half_q + 1'b1;
    end
    begins_q <= rst_ni && (tick_i || share[PeriodLog2]);
    if (!rst_ni) begin
      clock_o <= 1'b0;
      sync_o  <= 1'b1;
    end else if (begins_q) begin
      clock_o <= !half_q[0];
      sync_o  <= index != 5'd19;
    end
  end

  for (genvar a = 0; a < 3; a++) begin : gen_axes
    logic [15:0] upper;
    logic up;
    logic [15:0] next_q;
    logic [15:0] sent_q;
    logic parity_q;
    logic data;
    assign upper = sample_i[(a+1)*FineBits-1-:16];
    assign up = sample_i[(a+1)*FineBits-17] && upper != 16'h7fff;
    always_comb begin
      case (index)
        5'd0, 5'd1: data = 1'b0;
        5'd2: data = 1'b1;
        5'd19: data = parity_q;
        default: data = sent_q[4'(5'd18-index)];
      endcase
    end
    always_ff @(posedge clk_i) begin
      if (!rst_ni) next_q <= 16'h8000;
      else if (sample_taken_i) next_q <= (upper ^ 16'h8000) + {15'b0, up};
      if (tick_i) sent_q <= next_q;
      if (!rst_ni) begin
        data_o[a] <= 1'b0;
        parity_q  <= 1'b0;
      end else if (begins_q && !half_q[0]) begin
        data_o[a] <= data;
        parity_q  <= parity_q ^ data;  // 0 again behind each frame
      end
    end
  end

endmodule
`default_nettype wire
