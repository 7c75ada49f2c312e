// SPDX-License-Identifier: Apache-2.0
// One axis between two samples: the clocks in which its place crosses from step to step.
//
//     phase <- phase + rate        2^-RateBits step, on every clock; a carry or borrow is a step
//
// A rate of 2^-16 step per period of 2^(RateBits - 16) clocks is the same number of 2^-RateBits
// steps per clock: the place lands on each sample exactly, and nothing adds up. The phase begins in
// the middle, so steps lie half-way between whole places.
//
//   clock       0      1      2
//   load_i      1
//   rate_i      rate
//   back_o                    of that rate
//   hit_o                     earliest of that rate
//
// back_o keeps its side while the rate is 0. Twin: StepPhase of hls/step_axis.hpp.
`default_nettype none
module step_phase #(
    parameter int RateBits = 29  // [22, 36]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic                load_i,
    input wire logic                none_i,   // no rate: 0
    input wire logic                fresh_i,  // the phase begins in the middle
    input wire logic                moves_i,  // the rate is not 0
    input wire logic [RateBits-1:0] rate_i,   // signed

    output logic hit_o,
    output logic back_o
);

  logic [RateBits-1:0] rate_q;
  logic [RateBits-1:0] phase_q;
  logic moves_q;
  logic begins;
  logic signed [RateBits:0] sum;
  assign begins = load_i && !none_i && fresh_i;
  assign sum = {1'b0, phase_q} + {rate_q[RateBits-1], rate_q};
  always_ff @(posedge clk_i) begin
    if (!rst_ni || (load_i && none_i)) begin
      rate_q  <= '0;
      moves_q <= 1'b0;
    end else if (load_i) begin
      rate_q  <= rate_i;
      moves_q <= moves_i;
    end
    if (!rst_ni || begins) begin
      phase_q <= {1'b1, {(RateBits - 1) {1'b0}}};
      hit_o   <= 1'b0;
    end else begin
      phase_q <= sum[RateBits-1:0];
      hit_o   <= sum[RateBits];
    end
    if (!rst_ni) back_o <= 1'b0;
    else if (moves_q) back_o <= rate_q[RateBits-1];
  end

endmodule
`default_nettype wire
