// SPDX-License-Identifier: Apache-2.0
// The start of each integration step, axis after axis: the segment's start, or the last origin plus
// the displacement of the last step,
//
//     d = sum of c_i = (x[1] + .. + x[Order]) + advance        in units of 2^k
//     origin' = origin + floor(d 2^k 2^GuardBits + 1/2)
//
// `sum` comes from the network's axis; auxiliary axes have none.
//
//   cycle          0      1      Axes         6      Axes + 5
//   start_i        1                                              fresh_i: a new segment
//   rate_axis_o           0  ..  Axes - 1                         sum_i, advance_i of that axis
//   read_axis_o                        0      1  ..             segment_start_i of it, a clock on
//   write_o                                   1  ..  1            point_axis_o, origin_o
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

    output logic                            rate_valid_o,
    output logic             [         3:0] rate_axis_o,
    input  wire logic signed [CoefBits-1:0] sum_i,
    input  wire logic signed [CoefBits-1:0] advance_i,

    output logic             [         3:0] read_axis_o,
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

  logic signed [CoefBits-1:0] sum_q;
  logic signed [CoefBits-1:0] advance_q;
  logic signed [CoefBits-1:0] d_q;
  logic        [         4:0] down_q;
  always_ff @(posedge clk_i) begin
    if (rate_valid_o) begin
      sum_q     <= sum_i;
      advance_q <= advance_i;
    end
    d_q    <= sum_q + advance_q;
    down_q <= 5'(curvecore_pkg::MaxStepExponent) - k_i;
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
      .down_i(down_q),
      .none_i(1'b0),
      .doubled_o(doubled)
  );

  // Clocks since an axis was read: its old origin is read in 3 and added in 4.
  localparam int Clocks = 5;
  logic [Clocks-1:0] valid_q;
  logic [       3:0] axis_q  [Clocks];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= {valid_q[Clocks-2:0], rate_valid_o};
  end
  always_ff @(posedge clk_i) begin
    axis_q[0] <= rate_axis_o;
    for (int c = 1; c < Clocks; c++) axis_q[c] <= axis_q[c-1];
  end

  logic signed [FineBits-1:0] origins  [16];
  logic signed [FineBits-1:0] old_q;
  logic signed [  FineBits:0] old_half;
  logic signed [  FineBits:0] twice_q;
  assign old_half     = {old_q, 1'b1};
  assign write_o      = valid_q[Clocks-1];
  assign read_axis_o  = axis_q[Clocks-2];
  assign point_axis_o = axis_q[Clocks-1];
  assign origin_o     = fresh_q ? segment_start_i : twice_q[FineBits:1];
  always_ff @(posedge clk_i) begin
    old_q   <= origins[axis_q[2]];
    twice_q <= old_half + doubled;
    if (write_o) origins[point_axis_o] <= origin_o;
  end

endmodule
`default_nettype wire
