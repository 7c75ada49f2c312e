// SPDX-License-Identifier: Apache-2.0
// The first clocks of spline_anchor: the segment's words pass, three clocks for each axis, and
// go into its memories; then v and phi.
//
//   time_i    1 .. 9            3 .. 11                          8      12
//   axis_o    0 0 0 1 1 1 ..
//   writes                      2c | 3a, b | a, c of an axis     v      phi
//
//   memory   places
//   a        3a: axis, a: 4 + axis, phi: 15
//   b        v: 3, phi: 7
//   c        b: axis, c: 4 + axis, 2c: 8 + axis, phi: 12
`default_nettype none
module anchor_opening #(
    parameter int Bits           = 36,  // [18, 36]
    parameter int ParameterGuard = 0    // [0, 8]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic                                  begin_i,
    input wire logic        [                    7:0] time_i,
    input wire logic                                  fresh_i,    // v = 0, phi = theta
    input wire logic signed [               Bits-1:0] theta_i,
    input wire logic signed [               Bits-1:0] phi_end_i,
    // The growth of v, in time 6, with ParameterGuard fraction bits more
    input wire logic signed [Bits+ParameterGuard-1:0] moved_i,

    output logic             [     1:0] axis_o,
    input  wire logic signed [Bits-1:0] a_i,
    input  wire logic signed [Bits-1:0] b_i,
    input  wire logic signed [Bits-1:0] c_i,

    output logic                   three_a_there_o,
    output logic                   a_there_o,
    output logic        [     1:0] there_axis_o,
    output logic signed [Bits-1:0] three_a_o,
    output logic signed [Bits-1:0] a_o,

    output logic                   a_write_o,
    output logic        [     3:0] a_place_o,
    output logic signed [Bits-1:0] a_word_o,
    output logic                   b_write_o,
    output logic        [     2:0] b_place_o,
    output logic signed [Bits-1:0] b_word_o,
    output logic                   c_write_o,
    output logic        [     3:0] c_place_o,
    output logic signed [Bits-1:0] c_word_o
);

  logic        [     1:0] turn_q;
  logic        [     1:0] before_turn_q;
  logic                   open_q;  // axis_o is in use
  logic                   there_q;
  logic        [     1:0] row;
  logic signed [Bits-1:0] b_q;
  logic signed [Bits-1:0] c_q;
  logic signed [Bits-1:0] twice_a;
  logic signed [Bits-1:0] twice_c;
  logic signed [Bits-1:0] phi;
  logic                   v_now_q;
  logic                   v_there_q;
  logic                   phi_there_q;
  logic        [     7:0] time_copy;  // a clock late
  local_copy #(
      .Bits(8)
  ) u_time (
      .clk_i,
      .data_i(time_i),
      .data_o(time_copy)
  );
  // v and half of its last bit in the products: there the cut rounds it.
  localparam int FineBits = Bits + ParameterGuard;
  localparam logic [FineBits-1:0] One = {{(FineBits - 1) {1'b0}}, 1'b1};
  localparam logic signed [FineBits-1:0] Half = (One << ParameterGuard) >> 1;
  logic signed [FineBits-1:0] v_q;
  logic signed [FineBits-1:0] v_moved;
  assign v_moved = v_q + moved_i;

  assign twice_a = {a_o[Bits-2:0], 1'b0};
  assign twice_c = {c_q[Bits-2:0], 1'b0};
  assign phi     = fresh_i ? theta_i : phi_end_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) open_q <= 1'b0;
    else if (begin_i) open_q <= 1'b1;
    else if (axis_o == 2'd2 && turn_q == 2'd2) open_q <= 1'b0;
  end
  always_ff @(posedge clk_i) begin
    if (begin_i) begin
      axis_o <= 2'd0;
      turn_q <= 2'd0;
    end else begin
      turn_q <= (turn_q == 2'd2) ? 2'd0 : turn_q + 2'd1;
      if (turn_q == 2'd2) axis_o <= axis_o + 2'd1;
    end
    there_q         <= open_q;
    three_a_there_o <= open_q && turn_q == 2'd1;
    a_there_o       <= open_q && turn_q == 2'd2;
    there_axis_o    <= axis_o;
    before_turn_q   <= turn_q;
    a_o             <= a_i;
    b_q             <= b_i;
    c_q             <= c_i;
    three_a_o       <= a_o + twice_a;
    v_now_q         <= time_copy == 8'd4;
    v_there_q       <= v_now_q;
    phi_there_q     <= time_copy == 8'd9;
    if (v_now_q) v_q <= fresh_i ? Half : v_moved;
  end

  assign row = before_turn_q - 2'd1;
  always_ff @(posedge clk_i) begin
    a_write_o <= three_a_there_o || a_there_o || phi_there_q;
    b_write_o <= v_there_q || phi_there_q;
    c_write_o <= there_q || phi_there_q;
    if (phi_there_q) begin
      a_place_o <= 4'd15;
      a_word_o  <= phi;
      b_place_o <= 3'd7;
      b_word_o  <= phi;
      c_place_o <= 4'd12;
      c_word_o  <= phi;
    end else begin
      a_place_o <= {row, there_axis_o};
      a_word_o  <= a_there_o ? a_o : three_a_o;
      b_place_o <= 3'd3;
      b_word_o  <= v_q[FineBits-1:ParameterGuard];
      c_place_o <= (before_turn_q == 2'd0) ? {2'd2, there_axis_o} : {row, there_axis_o};
      c_word_o  <= (before_turn_q == 2'd0) ? twice_c : a_there_o ? c_q : b_q;
    end
  end

endmodule
`default_nettype wire
