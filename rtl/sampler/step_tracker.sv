// SPDX-License-Identifier: Apache-2.0
// Which step a sample lies in.  Twin: hls/interpolator_kernel.hpp.
//
// `left` is what remains to the largest offset of the present step, `beyond` the same for the next
// step: left + stride, held as a sum of two so that its addition takes no clock of its own.  Both
// less ds are computed in parallel; the first that is not negative tells the step:
//
//   left - ds >= 0                   the sample lies in the present step
//   left - ds < 0, beyond - ds >= 0  in the next: one switch, no clock lost
//   both < 0                         go on to the next step (hold), then compare again
//
// Everything here moves in slots: enabled clocks in phase 0 of the sampler.
//
//   slot         0         1
//   request_*    taken if request_ready_o
//   token_o                1 in the clock after every slot
//   sample_o               1: a sample at step_o, left_o
`default_nettype none
module step_tracker (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic en_i,
    input wire logic slot_i,

    input  wire logic        request_valid_i,
    output logic             request_ready_o,
    input  wire logic [47:0] request_ds_i,

    // The step after step_o
    input wire logic                                next_valid_i,
    input wire logic [curvecore_pkg::StepBits:0]    next_stride_i,

    output logic        token_o,
    output logic        sample_o,
    output logic [ 2:0] step_o,
    output logic [curvecore_pkg::StepBits-1:0] left_o
);

  localparam int Bits = 50;  // of sums of a length of 2^44 and ds
  localparam int NextBits = curvecore_pkg::StepBits + 1;

  logic            [47:0] ds_q;       // 0 without a request
  logic                   request_q;
  logic signed [Bits-1:0] left_q;
  logic        [Bits-1:0] beyond_q;   // beyond = beyond_q + stride_q, once ahead_q
  logic        [Bits-1:0] stride_q;
  logic                   ahead_q;    // the next step is known
  logic                   hold_q;     // this slot goes on to the next step, without ds

  logic signed [Bits-1:0] ds;
  logic signed [Bits-1:0] left;
  assign ds   = {2'b00, ds_q};
  assign left = left_q - ds;

  // beyond_q + stride_q - ds: three words become two, then one addition.
  logic [Bits-1:0] minus;
  logic [Bits-1:0] partial;
  logic [Bits-1:0] majority;
  logic [Bits-1:0] carries;
  logic [Bits-1:0] beyond;
  assign minus    = hold_q ? '1 : ~ds;
  assign partial  = beyond_q ^ stride_q ^ minus;
  assign majority = (beyond_q & stride_q) | (beyond_q & minus) | (stride_q & minus);
  assign carries  = {majority[Bits-2:0], 1'b1};
  assign beyond   = partial + carries;

  logic stay;
  logic go;
  logic skip;
  logic done;
  assign stay = !hold_q && !left[Bits-1];
  assign go   = hold_q || (left[Bits-1] && ahead_q && !beyond[Bits-1]);
  assign skip = !hold_q && left[Bits-1] && ahead_q && beyond[Bits-1];
  assign done = !hold_q && (stay || go);

  logic move;
  assign move            = en_i && slot_i;
  assign request_ready_o = move && done;

  // Before the first step there is one that is over: its left is -1.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ds_q      <= '0;
      request_q <= 1'b0;
      left_q    <= '1;
      beyond_q  <= '1;
      stride_q  <= '0;
      ahead_q   <= 1'b0;
      hold_q    <= 1'b0;
      step_o    <= 3'd7;
    end else if (move) begin
      hold_q <= skip;
      if (done) begin
        request_q <= request_valid_i;
        ds_q      <= request_valid_i ? request_ds_i : '0;
      end
      if (go) step_o <= step_o + 3'd1;
      if (stay) left_q <= left;
      else if (go) left_q <= beyond;
      if (stay || go) beyond_q <= beyond;
      if (go) ahead_q <= 1'b0;
      else if (next_valid_i) ahead_q <= 1'b1;
      if (!go && !ahead_q && next_valid_i) stride_q <= {{(Bits - NextBits) {1'b0}}, next_stride_i};
      else if (stay || go) stride_q <= '0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      token_o  <= 1'b0;
      sample_o <= 1'b0;
    end else if (en_i) begin
      token_o  <= slot_i;
      sample_o <= slot_i && done && request_q;
    end
  end
  assign left_o = left_q[NextBits-2:0];

endmodule
`default_nettype wire
