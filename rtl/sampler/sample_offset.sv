// SPDX-License-Identifier: Apache-2.0
// Tau, the offset as a fraction of a full step, from the rest of a step:
//
//     sigma = offset - left,  tau = floor(sigma 2^-(k+16) 2^(CoefBits-1)) of the fraction
//
// A sample at the end of a segment's last step lands: its place is the end word.
//
//   clock           0          1              2       3, 4
//                   token_i    look_* read    sigma   shifts
//   valid_o                                           1 in clock 4, with tau_o, step_o, ...
`default_nettype none
module sample_offset #(
    parameter int CoefBits = 36  // [18, 36]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic                               token_i,
    input wire logic                               sample_i,
    input wire logic [                        2:0] step_i,
    input wire logic [curvecore_pkg::StepBits-1:0] left_i,

    output logic      [                        2:0] look_step_o,
    input  wire logic                               look_last_i,
    input  wire logic [                        4:0] look_k_i,
    input  wire logic [curvecore_pkg::StepBits-1:0] look_offset_i,

    output logic                valid_o,
    output logic                sample_o,
    output logic                land_o,
    output logic [         2:0] step_o,
    output logic [         4:0] down_o,    // MaxStepExponent - k
    output logic [CoefBits-1:0] tau_o
);

  localparam int Bits = curvecore_pkg::StepBits;

  assign look_step_o = step_i;

  // Clock 1: the step's words.
  logic [Bits-1:0] left_q;
  logic [Bits-1:0] offset_q;
  logic            last_q;
  logic [     4:0] shift_q;
  // Clock 2
  logic [Bits-2:0] sigma_q;
  logic [     4:0] shift2_q;
  logic            land2_q;
  // Clock 3
  logic [Bits-2:0] coarse_q;
  logic [     4:0] shift3_q;
  logic            land3_q;

  // tau has the top bits of a full step's offset; a full step itself has tau 0 and lands.
  logic [Bits-1:0] sigma;
  logic [     4:0] coarse;
  logic [     2:0] fine;
  logic [Bits-2:0] aligned;
  assign sigma   = offset_q - left_q;
  assign coarse  = {shift2_q[4:3], 3'd0};
  assign fine    = shift3_q[2:0];
  assign aligned = coarse_q << fine;
  always_ff @(posedge clk_i) begin
    left_q   <= left_i;
    offset_q <= look_offset_i;
    last_q   <= look_last_i;
    shift_q  <= 5'(curvecore_pkg::MaxStepExponent) - look_k_i;

    sigma_q  <= sigma[Bits-2:0];
    land2_q  <= last_q && left_q == '0;
    shift2_q <= shift_q;

    coarse_q <= sigma_q << coarse;
    shift3_q <= shift2_q;
    land3_q  <= land2_q;

    tau_o    <= {1'b0, aligned[Bits-2:Bits-CoefBits]};
    land_o   <= land3_q;
    down_o <= shift3_q;
  end

  // Words that travel along: token, sample, step.
  logic [3:0] valid_q;
  logic [3:0] sample_q;
  logic [2:0] step_q[4];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q  <= '0;
      sample_q <= '0;
    end else begin
      valid_q  <= {valid_q[2:0], token_i};
      sample_q <= {sample_q[2:0], sample_i};
    end
  end
  always_ff @(posedge clk_i) begin
    step_q[0] <= step_i;
    step_q[1] <= step_q[0];
    step_q[2] <= step_q[1];
    step_q[3] <= step_q[2];
  end
  assign valid_o  = valid_q[3];
  assign sample_o = sample_q[3];
  assign step_o   = step_q[3];

endmodule
`default_nettype wire
