// SPDX-License-Identifier: Apache-2.0
// The start of each integration step of a spline: X Y Z from the cubic, the auxiliary axes (with
// Chained also X Y Z) from the step before,
//
//     X Y Z   origin = start + floor(d 2^lambda 2^GuardBits + 1/2)
//     others  origin' = origin + floor(d 2^k 2^GuardBits + 1/2), at first start
//
//   cycle           0                  2                        4
//   there_i         1, axis_i, d_i
//   read_axis_o               axis                              segment_start_i of it: in cycle 2
//   write_o                                                     1, point_axis_o, origin_o
`default_nettype none
module spline_origin #(
    parameter int CoefBits  = 36,  // [18, 36]
    parameter int FineBits  = 42,  // [18, 44]
    parameter int GuardBits = 10,  // [2, 12]
    parameter int Chained   = 0    // 0, 1
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic       fresh_i,  // the step is the first of its segment
    input wire logic [4:0] k_i,
    input wire logic [4:0] lambda_i,

    input wire logic                       there_i,
    input wire logic        [         3:0] axis_i,
    input wire logic signed [CoefBits-1:0] d_i,      // the last step's: its advance

    output logic             [         3:0] read_axis_o,
    output logic                            write_o,
    output logic             [         3:0] point_axis_o,
    input  wire logic signed [FineBits-1:0] segment_start_i,
    output logic signed      [FineBits-1:0] origin_o
);

  logic aux;
  logic [4:0] down_step_q;
  logic [4:0] down_segment_q;
  logic [4:0] down_q;
  logic signed [CoefBits-1:0] d_q;
  logic signed [FineBits:0] doubled;
  assign aux = axis_i >= 4'd3 || Chained != 0;
  always_ff @(posedge clk_i) begin
    down_step_q    <= 5'(curvecore_pkg::MaxStepExponent) - k_i;
    down_segment_q <= 5'(curvecore_pkg::MaxStepExponent) - lambda_i;
    down_q         <= aux ? down_step_q : down_segment_q;
    d_q            <= d_i;
  end
  fine_scale #(
      .CoefBits (CoefBits),
      .FineBits (FineBits),
      .GuardBits(GuardBits)
  ) u_scale (
      .clk_i,
      .en_i(1'b1),
      .d_i(d_q),
      .down_i(down_q),
      .none_i(1'b0),
      .doubled_o(doubled)
  );

  // Clocks since there_i.
  localparam int Clocks = 4;
  logic [Clocks-1:0] there_q;
  logic [3:0] axis_q[Clocks];
  logic aux_q[Clocks];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) there_q <= '0;
    else there_q <= {there_q[Clocks-2:0], there_i};
  end
  always_ff @(posedge clk_i) begin
    axis_q[0] <= axis_i;
    aux_q[0]  <= aux;
    for (int c = 1; c < Clocks; c = c + 1) begin
      axis_q[c] <= axis_q[c-1];
      aux_q[c]  <= aux_q[c-1];
    end
  end

  logic signed [FineBits-1:0] origins[16];
  logic signed [FineBits-1:0] base_q;
  logic signed [FineBits-1:0] start_q[2];
  logic signed [FineBits:0] base_half;
  logic signed [FineBits:0] twice_q;
  assign write_o      = there_q[3];
  assign read_axis_o  = axis_q[0];
  assign point_axis_o = axis_q[3];
  assign base_half    = {base_q, 1'b1};
  assign origin_o     = (fresh_i && aux_q[3]) ? start_q[1] : twice_q[FineBits:1];
  always_ff @(posedge clk_i) begin
    base_q     <= aux_q[1] ? origins[axis_q[1]] : segment_start_i;
    start_q[0] <= segment_start_i;
    start_q[1] <= start_q[0];
    twice_q    <= base_half + doubled;
    if (write_o) origins[axis_q[3]] <= origin_o;
  end

endmodule
`default_nettype wire
