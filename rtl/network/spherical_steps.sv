// SPDX-License-Identifier: Apache-2.0
// Integration steps along lines, arcs and helices: sequencer, network and origins.
// Twin: SphericalKernel::load and ::step in hls/spherical_kernel.hpp.
//
// A step lasts (rtl/control/taylor_sequencer.sv)
//
//     Order (Digits + 3) + 7 clocks,  Digits = ceil(CoefBits / 2)
//
//   rate_valid_o     Axes clocks: advance_o of rate_axis_o
//   point_write_o    Axes clocks: origin_o and end_o of point_axis_o
//   zeroth_o         one clock: x_o .. h_o are n and t at the step's start
//   collect_o        Order clocks: x_o .. z_o are the coefficients of order_o; with Mode 1 angle_o
//                    is that of the angle's sine (odd orders) or cosine (even orders)
//   done_o           with the last collect_o
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
    output logic      ready_o,  // none is under way
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

    output logic                       rate_valid_o,
    output logic        [         3:0] rate_axis_o,
    output logic signed [CoefBits-1:0] advance_o,
    output logic                       point_write_o,
    output logic        [         3:0] point_axis_o,
    output logic signed [FineBits-1:0] origin_o,
    output logic signed [FineBits-1:0] end_o,

    output logic                       zeroth_o,
    output logic                       collect_o,
    output logic        [         3:0] order_o,
    output logic signed [CoefBits-1:0] x_o,
    output logic signed [CoefBits-1:0] y_o,
    output logic signed [CoefBits-1:0] z_o,
    output logic signed [CoefBits-1:0] f_o,
    output logic signed [CoefBits-1:0] g_o,
    output logic signed [CoefBits-1:0] h_o,
    output logic signed [CoefBits-1:0] angle_o
);

  logic load_q;  // the present step is the first of its segment
  always_ff @(posedge clk_i) begin
    if (start_i) load_q <= fresh_i;
  end

  logic       take;
  logic       close;
  logic       triple;
  logic       step;
  logic       last_digit;
  logic [1:0] digit;
  logic       advance;
  logic       zeroth;
  logic       collect;
  logic       first;
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
      .take_o(take),
      .close_o(close),
      .triple_o(triple),
      .step_o(step),
      .last_o(last_digit),
      .digit_o(digit),
      .advance_o(advance),
      .zeroth_o(zeroth),
      .collect_o(collect),
      .first_o(first),
      .zeroth_there_o(zeroth_o),
      .collect_there_o(collect_o),
      .order_there_o(order_o),
      .done_o
  );

  logic                       rate_valid;
  logic                       point_write;
  logic        [         3:0] point_axis;
  logic signed [FineBits-1:0] origin;

  // While the axes pass by, their unit vectors are loaded, a clock later.
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

  spherical_network #(
      .CoefBits(CoefBits)
  ) u_network (
      .clk_i,
      .load_i(initial_load_q),
      .normal_i(initial_normal_q),
      .tangent_i(initial_tangent_q),
      .take_i(take),
      .close_i(close),
      .triple_i(triple),
      .step_i(step),
      .last_i(last_digit),
      .digit_i(digit),
      .advance_i(advance),
      .zeroth_i(zeroth),
      .collect_i(collect),
      .first_i(first),
      .x_o,
      .y_o,
      .z_o,
      .f_o,
      .g_o,
      .h_o,
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
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      rate_valid_o  <= 1'b0;
      point_write_o <= 1'b0;
    end else begin
      rate_valid_o  <= rate_valid;
      point_write_o <= point_write;
    end
  end
  always_ff @(posedge clk_i) begin
    rate_axis_o  <= segment_axis_o;
    advance_o    <= advance_i;
    point_axis_o <= point_axis;
    origin_o     <= origin;
    end_o        <= end_point_i;
  end

  // The angle from the step's start: sine and cosine from 0 and 1.
  if (Mode == 1) begin : g_angle
    logic signed [CoefBits-1:0] sine;
    logic signed [CoefBits-1:0] cosine;
    sine_cosine_network #(
        .CoefBits(CoefBits)
    ) u_angle (
        .clk_i,
        .load_i(start_i),
        .sine_i({CoefBits{1'b0}}),
        .cosine_i({2'b01, {(CoefBits - 2) {1'b0}}}),
        .take_i(take),
        .close_i(close),
        .triple_i(triple),
        .step_i(step),
        .last_i(last_digit),
        .digit_i(digit),
        .advance_i(1'b0),
        .zeroth_i(zeroth),
        .collect_i(collect),
        .first_i(first),
        .y_o(sine),
        .z_o(cosine)
    );
    assign angle_o = order_o[0] ? sine : cosine;
  end else begin : g_no_angle
    assign angle_o = '0;
  end

endmodule
`default_nettype wire
