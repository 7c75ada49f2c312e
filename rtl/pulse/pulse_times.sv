// SPDX-License-Identifier: Apache-2.0
// Times of the drives for rtl/pulse/step_pulse.sv, once for all axes: 0 counts as 1, and sums that
// count from a pulse's beginning.
`default_nettype none
module pulse_times #(
    parameter int TimeBits = 12  // [4, 16]
) (
    input wire logic clk_i,

    input wire logic [TimeBits-1:0] steplen_i,
    input wire logic [TimeBits-1:0] stepspace_i,
    input wire logic [TimeBits-1:0] dirsetup_i,
    input wire logic [TimeBits-1:0] dirhold_i,

    output logic [TimeBits-1:0] length_o,
    output logic [TimeBits-1:0] setup_o,
    output logic [TimeBits-1:0] again_o,     // clocks from a pulse to the next
    output logic [TimeBits-1:0] turn_o,      // clocks from a pulse to a turn
    output logic                length_1_o,
    output logic                setup_1_o
);

  // Times of 0 or 1, and the lowest bits, which make 1 of 0
  logic length_1, setup_1, space_1, hold_1;
  logic length_q;
  logic setup_q;
  logic space_q;
  logic hold_q;
  logic [TimeBits-1:0] space;
  logic [TimeBits-1:0] hold;
  assign length_o = {steplen_i[TimeBits-1:1], length_q};
  assign setup_o  = {dirsetup_i[TimeBits-1:1], setup_q};
  assign space    = {stepspace_i[TimeBits-1:1], space_q};
  assign hold     = {dirhold_i[TimeBits-1:1], hold_q};
  assign length_1 = steplen_i[TimeBits-1:1] == '0;
  assign setup_1  = dirsetup_i[TimeBits-1:1] == '0;
  assign space_1  = stepspace_i[TimeBits-1:1] == '0;
  assign hold_1   = dirhold_i[TimeBits-1:1] == '0;
  always_ff @(posedge clk_i) begin
    length_q   <= steplen_i[0] || length_1;
    setup_q    <= dirsetup_i[0] || setup_1;
    space_q    <= stepspace_i[0] || space_1;
    hold_q     <= dirhold_i[0] || hold_1;
    again_o    <= length_o + space;
    turn_o     <= length_o + hold;
    length_1_o <= length_1;
    setup_1_o  <= setup_1;
  end

endmodule
`default_nettype wire
