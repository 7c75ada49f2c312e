// SPDX-License-Identifier: Apache-2.0
// The words of a cubic at the start of an integration step, on one 18 x 18 multiplier: load, anchor
// and the step's v and phi of hls/curves/spline.hpp, its twin.
//
//     v <- v + q(1) / 2^s                    slope  b + 3a v           W = 2 slope / 2^s
//     mean = b + 3a v / 2                    V = c + 2 mean v          N = V.V
//     m = N phi    z = 1 - m phi             phi <- phi + z phi / 2
//     S = phi^2    Q = -S phi    R = -3 S    d = ((a v + b) v + c) v
//
//   cycle       0    1 .. 9       8 .. 15   32 .. 90    92   102   112   127 131 135
//   begin_i     1                                                                    fresh_i
//   axis_o           0 0 0 1 ..                                                      a_i, b_i, c_i
//   load_o                        6a'       V, W, phi         R    Q                 with word_o
//   step_a_there_o                a'                                                 with word_o
//   start_o                                             1
//   d_there_o                                                            1   1   1   d_o, d_axis_o
//
// phi_end_i and moved_i are read up to cycle 11, theta_i in it, s_i from cycle 1 on.  With
// Anchor = 0 only a segment's first step has the loads from V on; else Again and start_o
// come in cycle 3.
// Every operation is a sum of products (folded_sum), rounded once, and an addition; the operands
// pass in cycles 9 to 128.
`default_nettype none
module spline_anchor #(
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int ParameterGuard = 0,   // [0, 8]
    parameter int Anchor         = 1,   // 0: V W phi Q R are loaded with a segment only
    parameter int Own            = 1,   // 0, 1: as in folded_sum, with factors_o and product_i
    parameter int Form           = 0    // 0 portable, 1 ECP5
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic                       begin_i,
    input wire logic                       fresh_i,    // first step of its segment
    input wire logic        [         4:0] s_i,        // lambda - k
    input wire logic signed [CoefBits-1:0] theta_i,    // phi of the segment
    input wire logic signed [CoefBits-1:0] phi_end_i,
    input wire logic signed [CoefBits-1:0] moved_i,

    output logic             [         1:0] axis_o,
    input  wire logic signed [CoefBits-1:0] a_i,
    input  wire logic signed [CoefBits-1:0] b_i,
    input  wire logic signed [CoefBits-1:0] c_i,

    // To the network
    output logic        [spline_pkg::LoadBits-1:0] load_o,
    output logic                                   start_o,
    output logic signed [            CoefBits-1:0] word_o,

    // To the sampler and the origin
    output logic        [         2:0] step_a_there_o,  // word_o is a' of the axis
    output logic                       d_there_o,
    output logic        [         1:0] d_axis_o,
    output logic signed [CoefBits-1:0] d_o,

    output logic      [37:0] factors_o,
    input  wire logic [35:0] product_i
);

  initial if (CoefBits < 18 || CoefBits > 36) $fatal(1, "CoefBits must be in [18, 36]");
  initial
    if (ParameterGuard < 0 || ParameterGuard > 8) $fatal(1, "ParameterGuard must be in [0, 8]");
  initial if (Anchor < 0 || Anchor > 1) $fatal(1, "Anchor must be 0 or 1");
  initial if (Own < 0 || Own > 1) $fatal(1, "Own must be 0 or 1");
  initial if (Form < 0 || Form > 1) $fatal(1, "Form must be 0 or 1");

  localparam int Bits = CoefBits;

  // Time since begin_i; 0: at rest.
  logic [7:0] time_q;
  logic       fresh_q;
  logic       quiet_q;  // the network goes on with its own words
  logic [4:0] s_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) time_q <= 8'd0;
    else if (begin_i) time_q <= 8'd1;
    else if (time_q == 8'd136) time_q <= 8'd0;
    else if (time_q != 8'd0) time_q <= time_q + 8'd1;
  end
  always_ff @(posedge clk_i) begin
    if (begin_i) begin
      fresh_q <= fresh_i;
      quiet_q <= !fresh_i && Anchor == 0;
    end
    s_q <= s_i;
  end

  logic [3:0] op;
  logic [1:0] op_axis;
  logic       run;
  logic [1:0] part;
  logic       first;
  logic       drop;
  logic       run_end;
  logic [3:0] a_index;
  logic [2:0] b_index;
  anchor_program u_program (
      .clk_i,
      .rst_ni,
      .time_i(time_q),
      .op_o(op),
      .op_axis_o(op_axis),
      .run_o(run),
      .part_o(part),
      .first_o(first),
      .drop_o(drop),
      .end_o(run_end),
      .a_index_o(a_index),
      .b_index_o(b_index)
  );

  // Operands.  A: 3a, a, mean or e or f, V of each axis and N, -m, z or S, phi;  B: V, v, phi.
  logic signed [Bits-1:0] a_memory                                 [16];
  logic signed [Bits-1:0] b_memory                                 [ 8];
  logic        [     5:0] opening;
  logic        [     5:0] tag;  // tag of total, 3 clocks before it
  logic        [    77:0] total;
  logic        [    41:0] half;
  logic signed [Bits-1:0] a;
  logic signed [Bits-1:0] b;
  assign a = a_memory[a_index];
  assign b = b_memory[b_index];
  folded_sum #(
      .Bits(Bits),
      .TagBits(6),
      .Own(Own),
      .Form(Form)
  ) u_sum (
      .clk_i,
      .valid_i(run),
      .part_i(part),
      .first_i(first),
      .drop_i(drop),
      .tag_i({op, op_axis}),
      .unsigned_i(1'b0),
      .a_i(a),
      .b_i(b),
      .opening_o(opening),
      .half_i(half),
      .tag_o(tag),
      .total_o(total),
      .factors_o,
      .product_i
  );

  // The rounding of an operation; its shift, in a register: a tag is there before its total.
  localparam logic [41:0] One = 42'd1;
  logic        [     3:0] opening_kind;
  logic        [     3:0] kind_q;
  logic        [     1:0] axis_q;
  logic        [     2:0] shape_q;
  logic signed [Bits-1:0] sum;
  assign opening_kind = opening[5:2];
  always_comb begin
    case (opening_kind)
      anchor_pkg::Mean: half = One << (Bits - 1);
      anchor_pkg::V:    half = One << (Bits - 4);
      anchor_pkg::M:    half = One << (Bits - 3);
      anchor_pkg::Z:    half = One << (Bits - 7);
      anchor_pkg::Phi:  half = One << (Bits + 3);
      default:          half = One << (Bits - 2);
    endcase
    case (shape_q)
      3'd1:    sum = total[Bits+:Bits];
      3'd2:    sum = total[Bits-3+:Bits];
      3'd3:    sum = total[Bits-2+:Bits];
      3'd4:    sum = total[Bits-6+:Bits];
      3'd5:    sum = total[Bits+4+:Bits];
      default: sum = total[Bits-1+:Bits];
    endcase
  end
  always_ff @(posedge clk_i) begin
    {kind_q, axis_q} <= tag;
    case (tag[5:2])
      anchor_pkg::Mean: shape_q <= 3'd1;
      anchor_pkg::V:    shape_q <= 3'd2;
      anchor_pkg::M:    shape_q <= 3'd3;
      anchor_pkg::Z:    shape_q <= 3'd4;
      anchor_pkg::Phi:  shape_q <= 3'd5;
      default:          shape_q <= 3'd0;
    endcase
  end

  // The addition: b, c, 2c of each axis, phi.
  logic signed [Bits-1:0] c_memory  [16];
  logic        [     3:0] c_index;
  logic        [     3:0] c_index_q;
  logic                   alone;
  logic                   alone_q;
  always_comb begin
    c_index = {2'd0, tag[1:0]};
    alone   = 1'b0;
    case (tag[5:2])
      anchor_pkg::Mean, anchor_pkg::Slope, anchor_pkg::E: ;
      anchor_pkg::F:                                      c_index = {2'd1, tag[1:0]};
      anchor_pkg::V:                                      c_index = {2'd2, tag[1:0]};
      anchor_pkg::Phi:                                    c_index = 4'd12;
      default:                                            alone = 1'b1;
    endcase
  end

  logic        [     5:0] there_q;  // clocks since the operation's last
  logic        [     3:0] sum_kind_q;
  logic        [     1:0] sum_axis_q;
  logic                   minus_q;
  logic signed [Bits-1:0] sum_q;
  logic signed [Bits-1:0] addend_q;
  logic        [     1:0] made_axis_q;
  logic signed [Bits-1:0] result_q;
  logic                   v_there_q;
  logic                   slope_there_q;
  logic                   phi_there_q;
  logic                   square_there_q;
  logic                   q_there_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      there_q        <= 6'd0;
      v_there_q      <= 1'b0;
      slope_there_q  <= 1'b0;
      phi_there_q    <= 1'b0;
      square_there_q <= 1'b0;
      q_there_q      <= 1'b0;
      d_there_o      <= 1'b0;
    end else begin
      there_q        <= {there_q[4:0], run_end};
      v_there_q      <= there_q[5] && sum_kind_q == anchor_pkg::V;
      slope_there_q  <= there_q[5] && sum_kind_q == anchor_pkg::Slope;
      phi_there_q    <= there_q[5] && sum_kind_q == anchor_pkg::Phi;
      square_there_q <= there_q[5] && sum_kind_q == anchor_pkg::S;
      q_there_q      <= there_q[5] && sum_kind_q == anchor_pkg::Q;
      d_there_o      <= there_q[5] && sum_kind_q == anchor_pkg::D;
    end
  end
  always_ff @(posedge clk_i) begin
    c_index_q   <= c_index;
    alone_q     <= alone;
    sum_q       <= sum;
    addend_q    <= alone_q ? '0 : c_memory[c_index_q];
    sum_kind_q  <= kind_q;
    sum_axis_q  <= axis_q;
    minus_q     <= kind_q == anchor_pkg::M || kind_q == anchor_pkg::Q;
    result_q    <= minus_q ? addend_q - sum_q : addend_q + sum_q;
    made_axis_q <= sum_axis_q;
  end

  // Into the memories: at first the segment's words, then the results.
  logic signed [Bits+ParameterGuard-1:0] scaled;
  logic                                  three_a_there;
  logic                                  a_there;
  logic        [                    1:0] there_axis;
  logic signed [               Bits-1:0] three_a;
  logic signed [               Bits-1:0] segment_a;
  logic                                  open_a;
  logic        [                    3:0] open_a_place;
  logic signed [               Bits-1:0] open_a_word;
  logic                                  open_b;
  logic        [                    2:0] open_b_place;
  logic signed [               Bits-1:0] open_b_word;
  logic                                  open_c;
  logic        [                    3:0] open_c_place;
  logic signed [               Bits-1:0] open_c_word;
  anchor_opening #(
      .Bits(Bits),
      .ParameterGuard(ParameterGuard)
  ) u_opening (
      .clk_i,
      .rst_ni,
      .begin_i,
      .time_i(time_q),
      .fresh_i(fresh_q),
      .theta_i,
      .phi_end_i,
      .moved_i(scaled),
      .axis_o,
      .a_i,
      .b_i,
      .c_i,
      .three_a_there_o(three_a_there),
      .a_there_o(a_there),
      .there_axis_o(there_axis),
      .three_a_o(three_a),
      .a_o(segment_a),
      .a_write_o(open_a),
      .a_place_o(open_a_place),
      .a_word_o(open_a_word),
      .b_write_o(open_b),
      .b_place_o(open_b_place),
      .b_word_o(open_b_word),
      .c_write_o(open_c),
      .c_place_o(open_c_place),
      .c_word_o(open_c_word)
  );

  logic       result_a_q;
  logic       result_b_q;
  logic [3:0] result_a_place;
  logic [3:0] result_a_place_q;
  logic [2:0] result_b_place_q;
  always_comb begin
    result_a_place = {2'd2, sum_axis_q};
    case (sum_kind_q)
      anchor_pkg::V:                result_a_place = {2'd3, sum_axis_q};
      anchor_pkg::N:                result_a_place = 4'd3;
      anchor_pkg::M:                result_a_place = 4'd7;
      anchor_pkg::Z, anchor_pkg::S: result_a_place = 4'd11;
      anchor_pkg::Phi:              result_a_place = 4'd15;
      default:                      ;
    endcase
  end
  always_ff @(posedge clk_i) begin
    result_a_q <= there_q[5] && sum_kind_q != anchor_pkg::Q;
    result_b_q <= there_q[5] && (sum_kind_q == anchor_pkg::V || sum_kind_q == anchor_pkg::Phi);
    result_a_place_q <= result_a_place;
    result_b_place_q <= (sum_kind_q == anchor_pkg::V) ? {1'b0, sum_axis_q} : 3'd7;
  end

  logic        [     3:0] a_place;
  logic signed [Bits-1:0] a_word;
  logic        [     2:0] b_place;
  logic signed [Bits-1:0] b_word;
  assign a_place = open_a ? open_a_place : result_a_place_q;
  assign a_word  = open_a ? open_a_word : result_q;
  assign b_place = open_b ? open_b_place : result_b_place_q;
  assign b_word  = open_b ? open_b_word : result_q;
  always_ff @(posedge clk_i) begin
    if (open_a || result_a_q) a_memory[a_place] <= a_word;
    if (open_b || result_b_q) b_memory[b_place] <= b_word;
    if (open_c) c_memory[open_c_place] <= open_c_word;
  end

  anchor_words #(
      .CoefBits(CoefBits),
      .ParameterGuard(ParameterGuard)
  ) u_words (
      .clk_i,
      .rst_ni,
      .time_i(time_q),
      .quiet_i(quiet_q),
      .s_i(s_q),
      .moved_i,
      .three_a_there_i(three_a_there),
      .a_there_i(a_there),
      .open_axis_i(there_axis),
      .three_a_i(three_a),
      .a_i(segment_a),
      .scaled_o(scaled),
      .v_there_i(v_there_q),
      .slope_there_i(slope_there_q),
      .phi_there_i(phi_there_q),
      .square_there_i(square_there_q),
      .q_there_i(q_there_q),
      .result_axis_i(made_axis_q),
      .result_i(result_q),
      .load_o,
      .start_o,
      .step_a_there_o,
      .word_o
  );

  assign d_axis_o = made_axis_q;
  assign d_o      = result_q;

endmodule
`default_nettype wire
