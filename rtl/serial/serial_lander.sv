// SPDX-License-Identifier: Apache-2.0
// Displacements, one axis at a time, into origins and samples; twin: hls/spherical_kernel.hpp.
//
//     fine = land ? end : origin + floor(d 2^k 2^GuardBits + 1/2)
//
// Origins of X Y Z of splines are made from the segment's start, with 2^lambda: as axes 12 to 14.
//
//   cycle       0                1, 2    3     4                  5
//   target_i    2 sample
//   d_i         d, axis_i                      sample_o complete
//   target_i    3 origin                       origin written
//
// The sample is complete with its last axis; it moves on to the output as soon as that is free.
// taken_o: it has left the core.
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

    // From the bus: start or end words of an axis
    input wire logic                                     write_start_i,
    input wire logic                                     write_end_i,
    input wire logic        [                       3:0] write_axis_i,
    input wire logic signed [PositionBits+GuardBits-1:0] write_data_i,

    input wire logic                       spline_i,       // of the segment
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

  // The axis and what becomes of it, clocks 1 to 3.
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

  // Origins and ends. Block RAM is slow, a register follows it.
  (* ram_style = "block", no_rw_check *)
  logic signed [FineBits-1:0] points      [32];
  logic signed [FineBits-1:0] read_q;
  logic signed [FineBits-1:0] point_q;
  logic signed [  FineBits:0] point_half;
  logic signed [  FineBits:0] twice;
  logic signed [FineBits-1:0] fine_q;
  logic                       write;
  logic        [         3:0] start_axis;
  logic        [         3:0] origin_axis;
  logic        [         4:0] write_place;
  logic signed [FineBits-1:0] write_data;
  assign point_half = {point_q, 1'b1};
  assign twice = point_half + doubled;
  assign write = write_start_i || write_end_i || target_q[2] == 2'd3;
  assign start_axis   = (Splines != 0 && spline_i && write_axis_i < 4'd3) ? write_axis_i | 4'd12
                                                                          : write_axis_i;
  assign origin_axis = start_of_spline(axis_q[2]) ? axis_q[2] & 4'd3 : axis_q[2];
  assign write_data = target_q[2] == 2'd3 ? fine_q : write_data_i;
  always_comb begin
    write_place = {1'b0, origin_axis};
    if (write_start_i) write_place = {1'b0, start_axis};
    if (write_end_i) write_place = {1'b1, write_axis_i};
  end
  always_ff @(posedge clk_i) begin
    if (write) points[write_place] <= write_data;
    read_q  <= points[{land_i, axis_i}];
    point_q <= read_q;
    fine_q  <= twice[FineBits:1];
  end

  logic signed [FineBits-1:0] half;
  logic signed [FineBits-1:0] rounded;
  assign half    = {{PositionBits{1'b0}}, 1'b1, {(GuardBits - 1) {1'b0}}};
  assign rounded = fine_q + half;

  logic                         full_q;
  logic                         move;
  logic                         complete;
  logic [    Axes*FineBits-1:0] fine;
  logic [Axes*PositionBits-1:0] position;
  for (genvar a = 0; a < Axes; a++) begin : g_axis
    logic [    FineBits-1:0] axis_fine_q;
    logic [PositionBits-1:0] axis_position_q;
    always_ff @(posedge clk_i) begin
      if (target_q[2] == 2'd2 && axis_q[2] == 4'(a)) begin
        axis_fine_q     <= fine_q;
        axis_position_q <= rounded[FineBits-1:GuardBits];
      end
    end
    assign fine[a*FineBits+:FineBits]             = axis_fine_q;
    assign position[a*PositionBits+:PositionBits] = axis_position_q;
  end

  assign complete = target_q[2] == 2'd2 && axis_q[2] == 4'(Axes - 1);
  assign taken_o  = sample_valid_o && sample_ready_i;
  assign move     = full_q && (!sample_valid_o || sample_ready_i);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      full_q         <= 1'b0;
      sample_valid_o <= 1'b0;
    end else begin
      full_q         <= complete || (full_q && !move);
      sample_valid_o <= move || (sample_valid_o && !sample_ready_i);
    end
  end
  always_ff @(posedge clk_i) begin
    if (move) begin
      sample_fine_o     <= fine;
      sample_position_o <= position;
    end
  end

endmodule
`default_nettype wire
