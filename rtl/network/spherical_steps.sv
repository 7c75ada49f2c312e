// SPDX-License-Identifier: Apache-2.0
// Segments in, integration steps out: loader, sequencer, network, lengths and origins.
// Twin: SphericalKernel::load and ::step in hls/spherical_kernel.hpp.
//
// A step starts when there is room for it, and lasts (rtl/control/taylor_sequencer.sv)
//
//     Order (Digits + 3) + 7 clocks,  Digits = ceil(CoefBits / 2)
//
//   rate_valid_o     Axes clocks: advance_o of rate_axis_o
//   point_write_o    Axes clocks: origin_o and end_o of point_axis_o
//   zeroth_o         one clock: x_o .. h_o are n and t at the step's start
//   collect_o        Order clocks: x_o .. z_o are the coefficients of order_o; with Mode 1 angle_o
//                    is that of the angle's sine (odd orders) or cosine (even orders)
//   done_o           with the last collect_o: last_o, k_o, offset_o, stride_o are the step's
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

    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic [47:0] segment_data_i,
    output logic      [15:0] empty_segments_o,

    input  wire logic                               room_i,
    output logic                                    done_o,
    output logic                                    last_o,
    output logic      [                        4:0] k_o,
    output logic      [curvecore_pkg::StepBits-1:0] offset_o,
    output logic      [  curvecore_pkg::StepBits:0] stride_o,

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

  logic                       segment_there;
  logic        [        47:0] segment_length;
  logic        [CoefBits-1:0] segment_theta;
  logic        [         4:0] segment_k;
  logic        [         5:0] unused_lambda;
  logic                       unused_kind;
  logic signed [CoefBits-1:0] tangent;
  logic signed [CoefBits-1:0] normal;
  logic signed [CoefBits-1:0] segment_advance;
  logic signed [FineBits-1:0] segment_start;
  logic signed [FineBits-1:0] segment_end;
  logic                       rate_valid;
  logic        [         3:0] rate_axis;
  logic                       point_write;
  logic        [         3:0] point_axis;
  logic signed [FineBits-1:0] origin;

  // A step of the present segment, or the first of the next.  The start is a register: it reaches
  // far.
  logic                       ready;
  logic                       start;
  logic                       fresh_q;  // the next step is the first of its segment
  logic                       load_q;  // the present step is
  logic                       take_segment;
  logic        [CoefBits-1:0] theta_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fresh_q      <= 1'b1;
      start        <= 1'b0;
      take_segment <= 1'b0;
    end else begin
      if (done_o) fresh_q <= last_o;
      start        <= ready && !done_o && !start && room_i && (segment_there || !fresh_q);
      take_segment <= ready && !done_o && !start && room_i && segment_there && fresh_q;
    end
  end
  always_ff @(posedge clk_i) begin
    if (start) load_q <= fresh_q;
    if (take_segment) begin
      theta_q <= segment_theta;
      k_o     <= segment_k;
    end
  end

  segment_loader #(
      .CoefBits(CoefBits),
      .FineBits(FineBits),
      .AuxAxes (AuxAxes)
  ) u_loader (
      .clk_i,
      .rst_ni,
      .valid_i(segment_valid_i),
      .ready_o(segment_ready_o),
      .data_i(segment_data_i),
      .segment_valid_o(segment_there),
      .take_i(take_segment),
      .length_o(segment_length),
      .theta_o(segment_theta),
      .k_o(segment_k),
      .lambda_o(unused_lambda),
      .kind_o(unused_kind),
      .empty_segments_o,
      .rate_axis_i(rate_axis),
      .tangent_o(tangent),
      .normal_o(normal),
      .advance_o(segment_advance),
      .point_axis_i(point_axis),
      .start_o(segment_start),
      .end_o(segment_end)
  );

  step_meter u_meter (
      .clk_i,
      .rst_ni,
      .load_i(take_segment),
      .length_i(segment_length),
      .k_i(segment_k),
      .next_i(start),
      .last_o,
      .offset_o,
      .stride_o
  );

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
      .start_i(start),
      .fresh_i(fresh_q),
      .theta_i(theta_q),
      .ready_o(ready),
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
    case (rate_axis)
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
    initial_normal_q  <= normal;
    initial_tangent_q <= tangent;
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
      .start_i(start),
      .fresh_i(fresh_q),
      .k_i(k_o),
      .rate_valid_o(rate_valid),
      .rate_axis_o(rate_axis),
      .sum_i(sum),
      .advance_i(segment_advance),
      .write_o(point_write),
      .point_axis_o(point_axis),
      .segment_start_i(segment_start),
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
    rate_axis_o  <= rate_axis;
    advance_o    <= segment_advance;
    point_axis_o <= point_axis;
    origin_o     <= origin;
    end_o        <= segment_end;
  end

  // The angle from the step's start: sine and cosine from 0 and 1.
  if (Mode == 1) begin : g_angle
    logic signed [CoefBits-1:0] sine;
    logic signed [CoefBits-1:0] cosine;
    sine_cosine_network #(
        .CoefBits(CoefBits)
    ) u_angle (
        .clk_i,
        .load_i(start),
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
