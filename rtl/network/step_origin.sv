// SPDX-License-Identifier: Apache-2.0
// Where each integration step starts, axis after axis: the segment's start, or the origin before
// plus the displacement of the step before,
//
//     d = sum of c_i = (x[1] + .. + x[Order]) + advance        in units of 2^k
//     origin' = origin + floor(d 2^k 2^GuardBits + 1/2)
//
// `sum` is that of the network's axis; auxiliary axes have none.
//
//   cycle          0      1      Axes    5
//   start_i        1                              fresh_i: a new segment
//   rate_axis_o           0  ..  Axes-1           sum_i, advance_i of that axis
//   point_axis_o                         0  ..    start_i of that axis
//   write_o                              1  ..    origin_o, for Axes cycles
`default_nettype none
module step_origin #(
    parameter int CoefBits  = 36,  // [18, 36]
    parameter int FineBits  = 42,  // [18, 44]
    parameter int GuardBits = 10,  // [2, 12]
    parameter int AuxAxes   = 0    // [0, 6]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic       start_i,
    input wire logic       fresh_i,
    input wire logic [4:0] k_i,

    output logic                           rate_valid_o,
    output logic            [         3:0] rate_axis_o,
    input  wire logic signed [CoefBits-1:0] sum_i,
    input  wire logic signed [CoefBits-1:0] advance_i,

    output logic                            write_o,
    output logic             [         3:0] point_axis_o,
    input  wire logic signed [FineBits-1:0] segment_start_i,
    output logic signed      [FineBits-1:0] origin_o
);

  localparam int Last = 2 + AuxAxes;

  logic fresh_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      rate_valid_o <= 1'b0;
      rate_axis_o  <= 4'd0;
    end else if (start_i) begin
      rate_valid_o <= 1'b1;
      rate_axis_o  <= 4'd0;
    end else if (rate_valid_o) begin
      rate_valid_o <= rate_axis_o != 4'(Last);
      rate_axis_o  <= rate_axis_o + 4'd1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (start_i) fresh_q <= fresh_i;
  end

  logic signed [CoefBits-1:0] d_q;
  always_ff @(posedge clk_i) begin
    if (rate_valid_o) d_q <= sum_i + advance_i;
  end

  logic signed [FineBits:0] doubled;
  fine_scale #(
      .CoefBits (CoefBits),
      .FineBits (FineBits),
      .GuardBits(GuardBits)
  ) u_scale (
      .clk_i,
      .en_i(1'b1),
      .d_i(d_q),
      .k_i,
      .doubled_o(doubled)
  );

  // The axis whose displacement is scaled now.
  logic       valid_q[3];
  logic [3:0] axis_q [3];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q[0] <= 1'b0;
      valid_q[1] <= 1'b0;
      valid_q[2] <= 1'b0;
    end else begin
      valid_q[0] <= rate_valid_o;
      valid_q[1] <= valid_q[0];
      valid_q[2] <= valid_q[1];
    end
  end
  always_ff @(posedge clk_i) begin
    axis_q[0] <= rate_axis_o;
    axis_q[1] <= axis_q[0];
    axis_q[2] <= axis_q[1];
  end

  logic signed [FineBits-1:0] origins[16];
  logic signed [FineBits-1:0] old;
  logic signed [  FineBits:0] old_half;
  logic signed [  FineBits:0] twice;
  assign old          = origins[point_axis_o];
  assign old_half  = {old, 1'b1};
  assign twice        = old_half + doubled;
  assign write_o      = valid_q[2];
  assign point_axis_o = axis_q[2];
  assign origin_o     = fresh_q ? segment_start_i : twice[FineBits:1];
  always_ff @(posedge clk_i) begin
    if (write_o) origins[point_axis_o] <= origin_o;
  end

endmodule
`default_nettype wire
