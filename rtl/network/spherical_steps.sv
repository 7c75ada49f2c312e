// SPDX-License-Identifier: Apache-2.0
// Integration steps along lines, arcs and helices: sequencer, network and origins.
// Twin: ArcCurve::load and ::step in hls/curves/arc.hpp.
//
// A step lasts (rtl/control/taylor_sequencer.sv)
//
//     Order (Digits + 3) + 7 clocks,  Digits = ceil(CoefBits / 2)
//
//   rate_o, point_o   Axes clocks
//   write_o           rtl/network/arc_bank.sv; the last up to two clocks after done_o
//   done_o            with the last order
//
// The segment's words follow segment_axis_o in the same clock and segment_point_o a clock later
// (rtl/control/step_starter.sv), theta_i and k_i a clock after start_i.
`default_nettype none
module spherical_steps #(
    parameter int Order     = 6,   // [2, 12]
    parameter int CoefBits  = 36,  // [18, 36]
    parameter int FineBits  = 42,  // [18, 44]
    parameter int GuardBits = 10,  // [2, 12]
    parameter int AuxAxes   = 0,   // [0, 6]
    parameter int Mode      = 0    // 0 series, 1 polynomial
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic start_i,
    input  wire logic fresh_i,  // the step is the first of its segment
    output logic      ready_o,  // no step is under way
    output logic      done_o,

    // The segment
    input  wire logic        [CoefBits-1:0] theta_i,
    input  wire logic        [         4:0] k_i,
    output logic             [         3:0] segment_axis_o,
    input  wire logic signed [CoefBits-1:0] tangent_i,
    input  wire logic signed [CoefBits-1:0] normal_i,
    input  wire logic signed [CoefBits-1:0] advance_i,
    output logic             [         3:0] segment_point_o,
    input  wire logic signed [FineBits-1:0] start_point_i,
    input  wire logic signed [FineBits-1:0] end_point_i,

    // Outputs to the banks of the rates {there, axis, rate}, of the points {there, axis, end,
    // origin}, of the sampler (rtl/sampler/bank_pkg.sv)
    input  wire logic [                         1:0] bank_i,
    output logic      [                CoefBits+4:0] rate_o,
    output logic      [              2*FineBits+4:0] point_o,
    output logic      [          bank_pkg::Bits-1:0] write_o,
    output logic      [bank_pkg::Lanes*CoefBits-1:0] words_o
);

  logic load_q;  // the present step is the first of its segment
  always_ff @(posedge clk_i) begin
    if (start_i) load_q <= fresh_i;
  end

  logic [riemann_pkg::ExpansionBits-1:0] control;
  logic                                  zeroth;
  logic                                  collect;
  logic [                           3:0] order;
  taylor_sequencer #(
      .Order(Order),
      .Bits (CoefBits)
  ) u_sequencer (
      .clk_i,
      .rst_ni,
      .start_i,
      .fresh_i,
      .theta_i,
      .ready_o,
      .control_o(control),
      .zeroth_there_o(zeroth),
      .collect_there_o(collect),
      .order_there_o(order),
      .done_o
  );

  logic                       rate_valid;
  logic                       point_write;
  logic        [         3:0] point_axis;
  logic signed [FineBits-1:0] origin;

  // The unit vectors are loaded a clock after their axes pass.
  logic        [         2:0] axis;
  logic        [         2:0] initial_load_q;
  logic signed [CoefBits-1:0] initial_normal_q;
  logic signed [CoefBits-1:0] initial_tangent_q;
  logic signed [CoefBits-1:0] sum_x;
  logic signed [CoefBits-1:0] sum_y;
  logic signed [CoefBits-1:0] sum_z;
  logic signed [CoefBits-1:0] sum;
  always_comb begin
    axis = 3'b000;
    sum  = '0;
    case (segment_axis_o)
      4'd0: begin
        axis = 3'b001;
        sum  = sum_x;
      end
      4'd1: begin
        axis = 3'b010;
        sum  = sum_y;
      end
      4'd2: begin
        axis = 3'b100;
        sum  = sum_z;
      end
      default: ;
    endcase
  end
  always_ff @(posedge clk_i) begin
    initial_load_q    <= (rate_valid && load_q) ? axis : 3'b000;
    initial_normal_q  <= normal_i;
    initial_tangent_q <= tangent_i;
  end

  logic signed [CoefBits-1:0] x, y, z, f, g, h;
  spherical_network #(
      .CoefBits(CoefBits)
  ) u_network (
      .clk_i,
      .control_i(control),
      .load_i(initial_load_q),
      .normal_i(initial_normal_q),
      .tangent_i(initial_tangent_q),
      .x_o(x),
      .y_o(y),
      .z_o(z),
      .f_o(f),
      .g_o(g),
      .h_o(h),
      .sum_x_o(sum_x),
      .sum_y_o(sum_y),
      .sum_z_o(sum_z)
  );

  step_origin #(
      .CoefBits (CoefBits),
      .FineBits (FineBits),
      .GuardBits(GuardBits),
      .AuxAxes  (AuxAxes)
  ) u_origin (
      .clk_i,
      .rst_ni,
      .start_i,
      .fresh_i,
      .k_i,
      .rate_valid_o(rate_valid),
      .rate_axis_o(segment_axis_o),
      .sum_i(sum),
      .advance_i,
      .read_axis_o(segment_point_o),
      .write_o(point_write),
      .point_axis_o(point_axis),
      .segment_start_i(start_point_i),
      .origin_o(origin)
  );

  // To the banks.
  logic                       rate_there_q;
  logic        [         3:0] rate_axis_q;
  logic signed [CoefBits-1:0] rate_q;
  logic                       point_there_q;
  logic        [         3:0] point_axis_q;
  logic signed [FineBits-1:0] origin_q;
  logic signed [FineBits-1:0] end_q;
  assign rate_o  = {rate_there_q, rate_axis_q, rate_q};
  assign point_o = {point_there_q, point_axis_q, end_q, origin_q};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      rate_there_q  <= 1'b0;
      point_there_q <= 1'b0;
    end else begin
      rate_there_q  <= rate_valid;
      point_there_q <= point_write;
    end
  end
  always_ff @(posedge clk_i) begin
    rate_axis_q  <= segment_axis_o;
    rate_q       <= advance_i;
    point_axis_q <= point_axis;
    origin_q     <= origin;
    end_q        <= end_point_i;
  end
  logic [CoefBits-1:0] angle;
  arc_bank #(
      .CoefBits(CoefBits),
      .Mode(Mode)
  ) u_bank (
      .clk_i,
      .rst_ni,
      .bank_i,
      .rate_i(rate_o),
      .zeroth_i(zeroth),
      .collect_i(collect),
      .order_i(order),
      .xyz_i({z, y, x}),
      .fgh_i({h, g, f}),
      .angle_i(angle),
      .write_o,
      .words_o
  );

  // The angle from the step's start: sine and cosine from 0 and 1.
  if (Mode == 1) begin : g_angle
    logic signed [CoefBits-1:0] sine;
    logic signed [CoefBits-1:0] cosine;
    logic [riemann_pkg::ExpansionBits-1:0] expansion;  // begins afresh in every step
    always_comb begin
      expansion                       = control;
      expansion[riemann_pkg::Advance] = 1'b0;
    end
    sine_cosine_network #(
        .CoefBits(CoefBits)
    ) u_angle (
        .clk_i,
        .control_i({start_i, expansion}),
        .sine_i({CoefBits{1'b0}}),
        .cosine_i({2'b01, {(CoefBits - 2) {1'b0}}}),
        .y_o(sine),
        .z_o(cosine)
    );
    assign angle = order[0] ? sine : cosine;
  end else begin : g_no_angle
    assign angle = '0;
  end

endmodule
`default_nettype wire
