// SPDX-License-Identifier: Apache-2.0
// The numbers of steps of all axes since the reset; one of them is read, by an axis that exists.
`default_nettype none
module step_counters #(
    parameter int Axes = 3  // [1, 9]
) (
    input  wire logic              clk_i,
    input  wire logic              rst_ni,
    input  wire logic [  Axes-1:0] rise_i,
    input  wire logic [  Axes-1:0] back_i,
    input  wire logic [       3:0] axis_i,
    output logic      [      31:0] count_o,
    output logic      [2*Axes-1:0] low_o     // low bits of each
);

  localparam int AxisBits = (Axes > 1) ? $clog2(Axes) : 1;
  logic [31:0] counts[2**AxisBits];
  for (genvar a = 0; a < 2 ** AxisBits; a++) begin : gen_counts
    if (a < Axes) begin : g_axis
      step_counter u_counter (
          .clk_i,
          .rst_ni,
          .rise_i (rise_i[a]),
          .back_i (back_i[a]),
          .count_o(counts[a])
      );
      assign low_o[2*a+:2] = counts[a][1:0];
    end else begin : g_none
      assign counts[a] = 32'd0;
    end
  end
  assign count_o = counts[axis_i[AxisBits-1:0]];
  logic unused_axis;
  assign unused_axis = &{1'b0, axis_i};

endmodule
`default_nettype wire
