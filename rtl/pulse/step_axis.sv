// SPDX-License-Identifier: Apache-2.0
// One axis: rates in, pulses out, from its reference until it is stopped.
//
// An axis gives no step until a rate is loaded as fresh: it stands at the place of that sample.
// stop_i ends this reference, and so does a refused rate. Twin: StepAxis of hls/step_axis.hpp.
`default_nettype none
module step_axis #(
    parameter int RateBits = 29,  // [22, 36]
    parameter int TimeBits = 12   // [4, 16]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Times, from pulse_times
    input wire logic [TimeBits-1:0] length_i,
    input wire logic [TimeBits-1:0] setup_i,
    input wire logic [TimeBits-1:0] again_i,
    input wire logic [TimeBits-1:0] turn_i,
    input wire logic                length_1_i,
    input wire logic                setup_1_i,

    input wire logic                load_i,
    input wire logic                none_i,
    input wire logic                fresh_i,
    input wire logic                moves_i,
    input wire logic                refused_i,
    input wire logic [RateBits-1:0] rate_i,

    input wire logic stop_i,

    output logic step_o,
    output logic direction_o,
    output logic rise_o,
    output logic referenced_o,
    output logic refused_o,     // stays until the next reference, as the others
    output logic overrun_o,
    output logic uncertain_o
);

  logic begins;
  logic begun_q;  // in the clock before: a rate comes from block RAM, late
  logic refused;
  assign begins  = load_i && !none_i && fresh_i;
  assign refused = load_i && !none_i && refused_i;
  always_ff @(posedge clk_i) begin
    begun_q <= begins;
    if (!rst_ni || stop_i || refused) referenced_o <= 1'b0;
    else if (begins) referenced_o <= 1'b1;
    if (!rst_ni || begins) refused_o <= 1'b0;
    else if (refused) refused_o <= 1'b1;
  end

  logic hit;
  logic back;
  step_phase #(
      .RateBits(RateBits)
  ) u_phase (
      .clk_i,
      .rst_ni,
      .load_i,
      .none_i,
      .fresh_i,
      .moves_i,
      .rate_i,
      .hit_o (hit),
      .back_o(back)
  );

  step_pulse #(
      .TimeBits(TimeBits)
  ) u_pulse (
      .clk_i,
      .rst_ni,
      .length_i,
      .setup_i,
      .again_i,
      .turn_i,
      .length_1_i,
      .setup_1_i,
      .hit_i  (hit),
      .back_i (back),
      .stop_i (stop_i || !referenced_o),
      .clear_i(begun_q),
      .step_o,
      .direction_o,
      .rise_o,
      .overrun_o,
      .uncertain_o
  );

endmodule
`default_nettype wire
