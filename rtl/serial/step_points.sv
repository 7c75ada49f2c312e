// SPDX-License-Identifier: Apache-2.0
// A segment's points and rates, axis by axis, and the start of each step of it:
//
//     origin' = origin + floor(d 2^k 2^GuardBits + 1/2)
//
// Origins of X Y Z of splines are made from the segment's start, with 2^lambda: as axes 12 to 14.
//
//   cycle     0                   2                    3
//   move_i    1, d_i, axis_i                           origin' written
//   send_i    1: axis_i, what_i   0: origin kept
//                                 1: point_o           2: rate_o
//
// Words of the segment, moves and sends come in clocks of their own; an axis is sent in three
// clocks, with what_i from 0 to 2.
`default_nettype none
module step_points #(
    parameter int CoefBits  = 36,  // [18, 36]
    parameter int FineBits  = 42,  // [18, 44]
    parameter int GuardBits = 10,  // [2, 12]
    parameter int Splines   = 1    // 0, 1
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // The segment: a word of 0 the start, 1 the end, 2 the rate of an axis
    input wire logic        write_i,
    input wire logic [ 1:0] write_what_i,
    input wire logic [ 3:0] write_axis_i,
    input wire logic [47:0] write_data_i,
    input wire logic        spline_i,
    input wire logic [ 4:0] down_i,        // MaxStepExponent - k
    input wire logic [ 4:0] spline_down_i, // MaxStepExponent - lambda

    input wire logic                       move_i,
    input wire logic                       send_i,
    input wire logic        [         1:0] what_i,
    input wire logic        [         3:0] axis_i,
    input wire logic signed [CoefBits-1:0] d_i,

    // Outputs to the banks of the rates {there, axis, rate} and of the points {there, axis, end,
    // origin}
    output logic [  CoefBits+4:0] rate_o,
    output logic [2*FineBits+4:0] point_o
);

  localparam int Bits = (CoefBits > FineBits) ? CoefBits : FineBits;

  // Words come late in a clock.
  logic            write_q;
  logic [     5:0] write_place_q;
  logic [Bits-1:0] write_data_q;
  always_ff @(posedge clk_i) begin
    write_q       <= rst_ni && write_i;
    write_place_q <= {write_what_i, write_axis_i};
    write_data_q  <= write_data_i[Bits-1:0];
  end

  // The axis, clocks 1 to 3.
  logic       move_q[3];
  logic       send_q[2];
  logic [1:0] what_q[2];
  logic [3:0] axis_q[3];
  always_ff @(posedge clk_i) begin
    move_q[0] <= rst_ni && move_i;
    send_q[0] <= rst_ni && send_i;
    what_q[0] <= what_i;
    axis_q[0] <= axis_i;
    move_q[1] <= rst_ni && move_q[0];
    send_q[1] <= rst_ni && send_q[0];
    what_q[1] <= what_q[0];
    axis_q[1] <= axis_q[0];
    move_q[2] <= rst_ni && move_q[1];
    axis_q[2] <= axis_q[1];
  end

  logic                     of_spline;
  logic        [       4:0] down;
  logic signed [FineBits:0] doubled;
  assign of_spline = (Splines != 0) && axis_i[3:2] == 2'b11;
  assign down      = of_spline ? spline_down_i : down_i;
  fine_scale #(
      .CoefBits (CoefBits),
      .FineBits (FineBits),
      .GuardBits(GuardBits)
  ) u_scale (
      .clk_i,
      .en_i     (1'b1),
      .d_i,
      .down_i   (down),
      .none_i   (1'b0),
      .doubled_o(doubled)
  );

  // Block RAM is slow, a register follows it.
  (* ram_style = "block", no_rw_check *)
  logic        [    Bits-1:0] points      [64];
  logic        [    Bits-1:0] read_q;
  logic        [    Bits-1:0] point_q;
  logic        [FineBits-1:0] origin_q;
  logic signed [  FineBits:0] point_half;
  logic signed [  FineBits:0] twice;
  logic        [FineBits-1:0] moved_q;
  logic                       made;
  logic        [         3:0] read_axis;
  logic        [         5:0] read_place;
  logic                       write;
  logic        [         5:0] write_place;
  logic        [    Bits-1:0] write_data;
  assign made        = (Splines != 0) && spline_i && axis_i < 4'd3 && what_i == 2'd0;
  assign point_half  = {point_q[FineBits-1:0], 1'b1};
  assign twice       = point_half + doubled;
  assign write       = write_q || move_q[2];
  assign write_place = move_q[2] ? {2'd0, axis_q[2]} : write_place_q;
  assign write_data  = move_q[2] ? Bits'(moved_q) : write_data_q;
  always_comb begin
    read_axis = axis_i;
    if (send_i && made) read_axis[3:2] = 2'b11;
    if (!send_i && of_spline) read_axis[3:2] = 2'b00;
    read_place = {send_i ? what_i : 2'd0, read_axis};
  end
  always_ff @(posedge clk_i) begin
    if (write) points[write_place] <= write_data;
    read_q  <= points[read_place];
    point_q <= read_q;
    moved_q <= twice[FineBits:1];
    if (what_q[1] == 2'd0) origin_q <= point_q[FineBits-1:0];
  end

  assign point_o = {send_q[1] && what_q[1] == 2'd1, axis_q[1], point_q[FineBits-1:0], origin_q};
  assign rate_o  = {send_q[1] && what_q[1] == 2'd2, axis_q[1], point_q[CoefBits-1:0]};

endmodule
`default_nettype wire
