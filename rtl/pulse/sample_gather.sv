// SPDX-License-Identifier: Apache-2.0
// The sample whose positions rtl/pulse/place_scaler.sv takes axis by axis, whole when it takes the
// last one: the upper bits, rounded, of the first three axes.
//
//   clock        0     1            2
//   axis_i       a
//   position_i         of axis a
//   sample_o                        has it; axes come in order, many clocks each
`default_nettype none
module sample_gather #(
    parameter int Axes     = 3,   // [3, 9]
    parameter int FineBits = 42,  // [18, 44] bits of a position
    parameter int Bits     = 17   // [1, FineBits] bits that are kept; the others are 0
) (
    input  wire logic                     clk_i,
    input  wire logic [              3:0] axis_i,
    input  wire logic [     FineBits-1:0] position_i,
    output logic      [Axes*FineBits-1:0] sample_o
);

  logic [3:0] axis_q;
  always_ff @(posedge clk_i) axis_q <= axis_i;
  for (genvar a = 0; a < Axes; a++) begin : gen_axes
    if (a < 3) begin : gen_kept
      logic [Bits-1:0] kept_q;
      always_ff @(posedge clk_i) if (axis_q == 4'(a)) kept_q <= position_i[FineBits-1-:Bits];
      assign sample_o[(a+1)*FineBits-1-:FineBits] = {kept_q, (FineBits - Bits)'(0)};
    end else begin : gen_none
      assign sample_o[(a+1)*FineBits-1-:FineBits] = '0;
    end
  end

endmodule
`default_nettype wire
