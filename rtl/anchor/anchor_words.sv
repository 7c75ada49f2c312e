// SPDX-License-Identifier: Apache-2.0
// The words that spline_anchor makes, brought to the network's scale and loaded into it:
//
//     6a' = 6a / 4^s    a' = a / 4^s    W = 2 slope / 2^s    R = floor(-3 S / 4 + 1/2)
//
//   cycle                                 0    1    2       5
//   v, phi, q_there_i with result_i       1    V, Phi, Q, word_o                    of load_o
//   square_there_i with result_i          1         R, word_o
//   three_a_there_i, a_there_i            1                 SixA, step_a_there, word_o
//   slope_there_i with result_i           1                 W, word_o
//
// scaled_o: moved_i / 2^s in cycle 6 of time_i, with ParameterGuard fraction bits more.  start_o in
// cycle 92; with quiet_i in cycle 3.
`default_nettype none
module anchor_words #(
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int ParameterGuard = 0    // [0, 8]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic        [         7:0] time_i,
    input wire logic                       quiet_i,
    input wire logic        [         4:0] s_i,
    input wire logic signed [CoefBits-1:0] moved_i,

    input  wire logic                                      three_a_there_i,
    input  wire logic                                      a_there_i,
    input  wire logic        [                        1:0] open_axis_i,
    input  wire logic signed [               CoefBits-1:0] three_a_i,
    input  wire logic signed [               CoefBits-1:0] a_i,
    output logic signed      [CoefBits+ParameterGuard-1:0] scaled_o,

    input wire logic                       v_there_i,
    input wire logic                       slope_there_i,
    input wire logic                       phi_there_i,
    input wire logic                       square_there_i,
    input wire logic                       q_there_i,
    input wire logic        [         1:0] result_axis_i,
    input wire logic signed [CoefBits-1:0] result_i,

    output logic        [spline_pkg::LoadBits-1:0] load_o,
    output logic                                   start_o,
    output logic        [                     2:0] step_a_there_o,
    output logic signed [            CoefBits-1:0] word_o
);

  localparam int Bits = CoefBits;

  logic three_there_q;
  always_ff @(posedge clk_i) three_there_q <= rst_ni && square_there_i;

  // One scale for all words.
  logic signed [Bits-1:0] x;
  logic        [     5:0] shift;
  localparam int Lift = (ParameterGuard > 3) ? 1 + ParameterGuard : 4;
  logic [3:0] less;
  always_comb begin
    x     = moved_i;
    shift = {1'b0, s_i};
    less  = 4'(Lift - 1 - ParameterGuard);
    if (slope_there_i || three_a_there_i) less = 4'(Lift - 4);
    if (slope_there_i) x = result_i;
    if (three_a_there_i) x = three_a_i;
    if (a_there_i) begin
      x    = a_i;
      less = 4'(Lift - 1);
    end
    if (three_a_there_i || a_there_i) shift = {s_i, 1'b0};
  end
  step_scale #(
      .Bits(Bits),
      .Lift(Lift),
      .OutBits(Bits + ParameterGuard)
  ) u_scale (
      .clk_i,
      .x_i(x),
      .less_i(less),
      .shift_i(shift),
      .y_o(scaled_o)
  );

  logic [3:0] slope_scaled_q;
  logic [3:0] three_a_scaled_q;
  logic [3:0] a_scaled_q;
  logic [1:0] axis_q[4];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      slope_scaled_q   <= 4'd0;
      three_a_scaled_q <= 4'd0;
      a_scaled_q       <= 4'd0;
    end else begin
      slope_scaled_q   <= {slope_scaled_q[2:0], slope_there_i};
      three_a_scaled_q <= {three_a_scaled_q[2:0], three_a_there_i};
      a_scaled_q       <= {a_scaled_q[2:0], a_there_i};
    end
  end
  always_ff @(posedge clk_i) begin
    axis_q[0] <= slope_there_i ? result_axis_i : open_axis_i;
    axis_q[1] <= axis_q[0];
    axis_q[2] <= axis_q[1];
    axis_q[3] <= axis_q[2];
  end

  // floor(-3 S / 4 + 1/2)
  logic signed [Bits+1:0] square_wide;
  logic signed [Bits+1:0] square_twice;
  logic signed [Bits+1:0] two;
  logic signed [Bits+1:0] three_q;
  logic signed [Bits+1:0] minus_three;
  assign square_wide  = (Bits + 2)'(result_i);
  assign square_twice = {result_i[Bits-1], result_i, 1'b0};
  assign two          = (Bits + 2)'(3'sd2);
  assign minus_three  = two - three_q;
  always_ff @(posedge clk_i) three_q <= square_wide + square_twice;

  logic [7:0] time_copy;  // a clock late
  local_copy #(
      .Bits(8)
  ) u_time (
      .clk_i,
      .data_i(time_i),
      .data_o(time_copy)
  );

  logic       from_scale;
  logic [1:0] late_axis;
  logic [2:0] scaled_axis;
  logic [2:0] result_axis;
  assign from_scale  = slope_scaled_q[3] || three_a_scaled_q[3] || a_scaled_q[3];
  assign late_axis   = axis_q[3];
  assign scaled_axis = 3'b001 << late_axis;
  assign result_axis = 3'b001 << result_axis_i;

  logic [2:0] load_six_a_q;
  logic [2:0] load_v_q;
  logic [2:0] load_w_q;
  logic load_phi_q;
  logic load_q_q;
  logic load_r_q;
  logic again_q;
  assign load_o = {again_q, load_r_q, load_q_q, load_phi_q, load_w_q, load_v_q, load_six_a_q};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      load_six_a_q   <= 3'd0;
      load_v_q       <= 3'd0;
      load_w_q       <= 3'd0;
      load_phi_q     <= 1'b0;
      load_q_q       <= 1'b0;
      load_r_q       <= 1'b0;
      again_q        <= 1'b0;
      start_o        <= 1'b0;
      step_a_there_o <= 3'd0;
    end else begin
      load_six_a_q   <= three_a_scaled_q[3] ? scaled_axis : 3'd0;
      step_a_there_o <= a_scaled_q[3] ? scaled_axis : 3'd0;
      load_v_q       <= (v_there_i && !quiet_i) ? result_axis : 3'd0;
      load_w_q       <= (slope_scaled_q[3] && !quiet_i) ? scaled_axis : 3'd0;
      load_phi_q     <= phi_there_i && !quiet_i;
      load_q_q       <= q_there_i && !quiet_i;
      load_r_q       <= three_there_q && !quiet_i;
      again_q        <= quiet_i && time_copy == 8'd1;
      start_o        <= quiet_i ? time_copy == 8'd1 : time_copy == 8'd90;
    end
  end
  always_ff @(posedge clk_i) begin
    word_o <= result_i;
    if (from_scale) word_o <= scaled_o[Bits-1:0];
    if (three_there_q) word_o <= minus_three[Bits+1:2];
  end

endmodule
`default_nettype wire
