// SPDX-License-Identifier: Apache-2.0
// Origins and samples from displacements, one axis at a time; twin: hls/curves/arc.hpp.
//
//     fine = land ? end : origin + floor(d 2^k 2^GuardBits + 1/2)
//
// Origins of X Y Z of splines are made from the segment's start, with 2^lambda: as axes 12 to 14.
//
//   cycle       0                1, 2    3          4          5       ..      Axes + 6
//   target_i    2 sample                            d's axis
//   d_i         d, axis_i                written,   the last:  read, axis by axis
//   target_i    3 origin                 too                           sample_valid_o
//
// At most four samples wait in the memory of points. A complete one is read to the output when that
// is free: an axis in every clock in which no other point is read. taken_o: it has left the core.
`default_nettype none
module serial_lander #(
    parameter int CoefBits     = 36,  // [18, 36]
    parameter int PositionBits = 32,  // [16, 32]
    parameter int GuardBits    = 10,  // [2, 12]
    parameter int AuxAxes      = 0,   // [0, 6]
    parameter int Splines      = 1    // 0, 1
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Words from the bus: start or end of an axis
    input wire logic                                     write_start_i,
    input wire logic                                     write_end_i,
    input wire logic        [                       3:0] write_axis_i,
    input wire logic signed [PositionBits+GuardBits-1:0] write_data_i,

    input wire logic                       spline_i,       // the segment is a spline
    input wire logic        [         4:0] down_i,         // MaxStepExponent - k
    input wire logic        [         4:0] spline_down_i,  // MaxStepExponent - lambda
    input wire logic        [         1:0] target_i,
    input wire logic        [         3:0] axis_i,
    input wire logic signed [CoefBits-1:0] d_i,
    input wire logic                       land_i,

    output logic                                                 sample_valid_o,
    input  wire logic                                            sample_ready_i,
    output logic      [            (3+AuxAxes)*PositionBits-1:0] sample_position_o,
    output logic      [(3+AuxAxes)*(PositionBits+GuardBits)-1:0] sample_fine_o,
    output logic                                                 taken_o
);

  localparam int Axes = 3 + AuxAxes;
  localparam int FineBits = PositionBits + GuardBits;

  // The axis and its target, clocks 1 to 3.
  logic [1:0] target_q[3];
  logic [3:0] axis_q  [3];
  logic       land_q;
  always_ff @(posedge clk_i) begin
    target_q[0] <= rst_ni ? target_i : 2'd0;
    axis_q[0]   <= axis_i;
    land_q      <= land_i;
    for (int n = 1; n < 3; n = n + 1) begin
      target_q[n] <= rst_ni ? target_q[n-1] : 2'd0;
      axis_q[n]   <= axis_q[n-1];
    end
  end

  // Axes 0 to 8, and starts of splines.
  function automatic logic start_of_spline(input logic [3:0] axis);
    start_of_spline = (Splines != 0) && axis[3:2] == 2'b11;
  endfunction

  logic        [       4:0] down;
  logic signed [FineBits:0] doubled;
  assign down = start_of_spline(axis_i) ? spline_down_i : down_i;
  fine_scale #(
      .CoefBits (CoefBits),
      .FineBits (FineBits),
      .GuardBits(GuardBits)
  ) u_scale (
      .clk_i,
      .en_i     (1'b1),
      .d_i,
      .down_i   (down),
      .none_i   (land_q),
      .doubled_o(doubled)
  );

  // Origins, ends and the sample. Block RAM is slow, a register follows it.
  (* ram_style = "block", no_rw_check *)
  logic signed [FineBits-1:0] points                          [128];
  logic signed [FineBits-1:0] read_q;
  logic signed [FineBits-1:0] point_q;
  logic signed [  FineBits:0] point_half;
  logic signed [  FineBits:0] twice;
  logic signed [FineBits-1:0] fine_q;
  logic                       write;
  logic                       of_sample;
  logic        [         3:0] start_axis;
  logic        [         3:0] origin_axis;
  logic        [         6:0] write_place;
  logic        [         6:0] read_place;
  logic signed [FineBits-1:0] write_data;
  logic        [         1:0] written_q;  // samples, modulo 4
  logic        [         1:0] walked_q;
  logic                       walks;
  logic        [         3:0] walk_q;
  assign point_half = {point_q, 1'b1};
  assign twice = point_half + doubled;
  assign of_sample = target_q[2] == 2'd2;
  assign write = write_start_i || write_end_i || target_q[2][1];
  assign start_axis   = (Splines != 0 && spline_i && write_axis_i < 4'd3) ? write_axis_i | 4'd12
                                                                          : write_axis_i;
  assign origin_axis = start_of_spline(axis_q[2]) ? axis_q[2] & 4'd3 : axis_q[2];
  assign write_data = target_q[2][1] ? fine_q : write_data_i;
  always_comb begin
    write_place = of_sample ? {1'b1, written_q, axis_q[2]} : {3'b000, origin_axis};
    if (write_start_i) write_place = {3'b000, start_axis};
    if (write_end_i) write_place = {3'b001, write_axis_i};
    read_place = walks ? {1'b1, walked_q, walk_q} : {2'b00, land_i, axis_i};
  end
  always_ff @(posedge clk_i) begin
    if (write) points[write_place] <= write_data;
    read_q  <= points[read_place];
    point_q <= read_q;
    fine_q  <= twice[FineBits:1];
  end

  // The walk through the axes of a complete sample
  logic       walking_q;
  logic       last;
  logic       arrives;
  logic       free;
  logic [1:0] walks_q;
  logic [3:0] place_q   [2];
  assign walks   = walking_q && !target_i[1];
  assign last    = walk_q == 4'(Axes - 1);
  assign arrives = walks_q[1] && place_q[1] == 4'(Axes - 1);
  assign free    = walks_q == 2'b00 && (!sample_valid_o || sample_ready_i);
  assign taken_o = sample_valid_o && sample_ready_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      written_q      <= 2'd0;
      walked_q       <= 2'd0;
      walking_q      <= 1'b0;
      walk_q         <= 4'd0;
      walks_q        <= 2'b00;
      sample_valid_o <= 1'b0;
    end else begin
      if (of_sample && axis_q[2] == 4'(Axes - 1)) written_q <= written_q + 2'd1;
      if (walks && last) walked_q <= walked_q + 2'd1;
      if (walking_q) walking_q <= !(walks && last);
      else walking_q <= written_q != walked_q && free;
      if (walks) walk_q <= last ? 4'd0 : walk_q + 4'd1;
      walks_q        <= {walks_q[0], walks};
      sample_valid_o <= arrives || (sample_valid_o && !sample_ready_i);
    end
  end
  always_ff @(posedge clk_i) begin
    place_q[0] <= walk_q;
    place_q[1] <= place_q[0];
  end

  logic half;
  logic [PositionBits-1:0] floor;
  logic [PositionBits-1:0] position;
  assign half     = point_q[GuardBits-1];
  assign floor    = point_q[FineBits-1:GuardBits];
  assign position = floor + PositionBits'(half);
  for (genvar a = 0; a < Axes; a++) begin : g_axis
    logic [    FineBits-1:0] axis_fine_q;
    logic [PositionBits-1:0] axis_position_q;
    always_ff @(posedge clk_i) begin
      if (walks_q[1] && place_q[1] == 4'(a)) begin
        axis_fine_q     <= point_q;
        axis_position_q <= position;
      end
    end
    assign sample_fine_o[a*FineBits+:FineBits]             = axis_fine_q;
    assign sample_position_o[a*PositionBits+:PositionBits] = axis_position_q;
  end

endmodule
`default_nettype wire
