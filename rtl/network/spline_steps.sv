// SPDX-License-Identifier: Apache-2.0
// Integration steps along splines: anchor, network and origins.
// Twin: SplineCurve::load and ::step in hls/curves/spline.hpp.
//
// Cycles from start_i on:
//
//   rate_o    12 .. 11 + AuxAxes    auxiliary axes
//   point_o   16 .. 15 + AuxAxes    auxiliary axes
//             131, 135, 139         X, Y, Z; Anchor 0 with Mode 0: 13, 14, 15
//   write_o   rtl/network/spline_bank.sv, with Mode 1
//             10, 13, 16            a' of an axis
//             34 .. 79              V, B' = W / 8; Anchor 0: 5, 6 in all but the first step
//             98 ..                 the terms, with Mode 0 too; the last a clock after done_o
//   done_o    92 + the network's    Anchor 0: 3 in all but the first step
//
// The network's clocks are in rtl/control/spline_sequencer.sv; with Order 6, CoefBits 36, Mode 1
// and Anchor 1 they are 306.  The next step begins 2 clocks after done_o.  The segment's words
// follow segment_axis_o in the same clock and segment_point_o a clock later
// (rtl/control/step_starter.sv), theta_i, k_i and lambda_i a clock after start_i.
`default_nettype none
module spline_steps #(
    parameter int Order          = 6,   // [2, 12]
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int FineBits       = 42,  // [18, 44]
    parameter int GuardBits      = 10,  // [2, 12]
    parameter int AuxAxes        = 0,   // [0, 6]
    parameter int Mode           = 1,   // 0 series, 1 polynomial
    parameter int ParameterGuard = 0,   // [0, 8]
    parameter int Anchor         = 1,   // 0, 1
    parameter int Form           = 0    // 0 portable, 1 ECP5
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic start_i,
    input  wire logic fresh_i,  // the step is the first of its segment
    output logic      ready_o,  // no step is under way
    output logic      done_o,

    // The segment
    input  wire logic        [CoefBits-1:0] theta_i,          // phi
    input  wire logic        [         4:0] k_i,
    input  wire logic        [         4:0] lambda_i,
    output logic             [         3:0] segment_axis_o,
    input  wire logic signed [CoefBits-1:0] a_i,
    input  wire logic signed [CoefBits-1:0] b_i,
    input  wire logic signed [CoefBits-1:0] c_i,              // auxiliary axes: advance
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

  initial if (Order < 2 || Order > 12) $fatal(1, "Order must be in [2, 12]");
  initial if (CoefBits < 18 || CoefBits > 36) $fatal(1, "CoefBits must be in [18, 36]");
  initial if (FineBits < 18 || FineBits > 44) $fatal(1, "FineBits must be in [18, 44]");
  initial if (GuardBits < 2 || GuardBits > 12) $fatal(1, "GuardBits must be in [2, 12]");
  initial if (AuxAxes < 0 || AuxAxes > 6) $fatal(1, "AuxAxes must be in [0, 6]");
  initial if (Mode < 0 || Mode > 1) $fatal(1, "Mode must be 0 or 1");
  initial if (Anchor < 0 || Anchor > 1) $fatal(1, "Anchor must be 0 or 1");
  initial if (Form < 0 || Form > 1) $fatal(1, "Form must be 0 or 1");

  logic load_q;  // the present step is the first of its segment
  always_ff @(posedge clk_i) begin
    if (start_i) load_q <= fresh_i;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) ready_o <= 1'b1;
    else if (start_i) ready_o <= 1'b0;
    else if (done_o) ready_o <= 1'b1;
  end

  logic        [spline_pkg::LoadBits-1:0] load;
  logic                                   start_network;
  logic signed [            CoefBits-1:0] word;
  logic signed [            CoefBits-1:0] phi_end;
  logic signed [            CoefBits-1:0] moved;
  // The anchor's multiplier later becomes the network's; with Anchor 0 each has its own.
  localparam int Guest = (Anchor != 0) ? 1 : 0;
  logic [37:0] anchor_factors;
  logic [37:0] network_factors;
  logic [35:0] product;
  if (Guest != 0) begin : g_shared
    half_product #(
        .Form(Form)
    ) u_product (
        .clk_i,
        .factors_i(anchor_factors | network_factors),
        .product_o(product)
    );
  end else begin : g_own
    logic unused;
    assign unused  = &{anchor_factors, network_factors};
    assign product = '0;
  end

  logic        [         4:0] difference;
  logic        [         2:0] a_there;
  logic        [         1:0] anchor_axis;
  logic                       d_there;
  logic        [         1:0] d_axis;
  logic signed [CoefBits-1:0] d;
  assign difference = lambda_i - k_i;
  spline_anchor #(
      .CoefBits(CoefBits),
      .ParameterGuard(ParameterGuard),
      .Anchor(Anchor),
      .Own(1 - Guest),
      .Form(Form)
  ) u_anchor (
      .clk_i,
      .rst_ni,
      .begin_i(start_i),
      .fresh_i,
      .s_i(difference),
      .theta_i(theta_i),
      .phi_end_i(phi_end),
      .moved_i(moved),
      .axis_o(anchor_axis),
      .a_i,
      .b_i,
      .c_i,
      .load_o(load),
      .start_o(start_network),
      .word_o(word),
      .step_a_there_o(a_there),
      .d_there_o(d_there),
      .d_axis_o(d_axis),
      .d_o(d),
      .factors_o(anchor_factors),
      .product_i(product)
  );

  logic                   unused_ready;
  logic [   CoefBits+4:0] q;
  logic [3*CoefBits+14:0] x;
  logic [3*CoefBits+14:0] v;
  logic [3*CoefBits+14:0] w;
  spline_network #(
      .Order(Order),
      .CoefBits(CoefBits),
      .Mode(Mode),
      .Anchor(Anchor),
      .Guest(Guest),
      .Form(Form)
  ) u_network (
      .clk_i,
      .rst_ni,
      .load_i(load),
      .initial_i(word),
      .start_i(start_network),
      .ready_o(unused_ready),
      .done_o,
      .q_o(q),
      .x_o(x),
      .v_o(v),
      .w_o(w),
      .moved_o(moved),
      .phi_end_o(phi_end),
      .factors_o(network_factors),
      .product_i(product)
  );

  spline_bank #(
      .CoefBits(CoefBits),
      .Mode(Mode)
  ) u_bank (
      .clk_i,
      .rst_ni,
      .bank_i,
      .a_there_i(a_there),
      .a_i(word),
      .q_i(q),
      .x_i(x),
      .v_i(v),
      .w_i(w),
      .write_o,
      .words_o
  );

  // Auxiliary axes pass after the anchor has read the others.
  logic [4:0] time_q;
  logic       aux;
  logic [3:0] aux_axis;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) time_q <= 5'd31;
    else if (start_i) time_q <= 5'd1;
    else if (time_q != 5'd31) time_q <= time_q + 5'd1;
  end
  assign aux            = time_q >= 5'd11 && time_q < 5'(11 + AuxAxes);
  assign aux_axis       = time_q[3:0] - 4'd8;
  assign segment_axis_o = aux ? aux_axis : {2'b00, anchor_axis};

  logic                       rate_there_q;
  logic        [         3:0] rate_axis_q;
  logic signed [CoefBits-1:0] rate_q;
  assign rate_o = {rate_there_q, rate_axis_q, rate_q};
  always_ff @(posedge clk_i) begin
    rate_there_q <= rst_ni && aux;
    rate_axis_q  <= aux_axis;
    rate_q       <= c_i;
  end

  // X Y Z come from the cubic, when the anchor has them.  With Anchor 0 and Mode 0 they continue
  // from the step before as the auxiliary axes do, and pass just before those.
  localparam int Chained = (Anchor == 0 && Mode == 0) ? 1 : 0;
  logic                       xyz_there;
  logic        [         1:0] xyz_axis;
  logic signed [CoefBits-1:0] xyz_d;
  if (Chained != 0) begin : g_chained
    logic unused;
    assign unused = &{d_there, d_axis, d};
    always_ff @(posedge clk_i) begin
      if (!rst_ni) xyz_there <= 1'b0;
      else xyz_there <= time_q >= 5'd8 && time_q < 5'd11;
    end
    assign xyz_axis = rate_axis_q[1:0];
    spline_move #(
        .CoefBits(CoefBits)
    ) u_move (
        .clk_i,
        .x_i(x),
        .axis_i(aux_axis[1:0]),
        .d_o(xyz_d)
    );
  end else begin : g_cubic
    assign xyz_there = d_there;
    assign xyz_axis  = d_axis;
    assign xyz_d     = d;
  end

  logic                       point_there;
  logic        [         3:0] point_axis;
  logic signed [FineBits-1:0] origin;
  logic                       origin_there;
  logic        [         3:0] origin_axis;
  logic signed [CoefBits-1:0] origin_d;
  assign origin_there = rate_there_q || xyz_there;
  assign origin_axis  = xyz_there ? {2'b00, xyz_axis} : rate_axis_q;
  assign origin_d     = xyz_there ? xyz_d : rate_q;
  spline_origin #(
      .CoefBits (CoefBits),
      .FineBits (FineBits),
      .GuardBits(GuardBits),
      .Chained  (Chained)
  ) u_origin (
      .clk_i,
      .rst_ni,
      .fresh_i(load_q),
      .k_i,
      .lambda_i,
      .there_i(origin_there),
      .axis_i(origin_axis),
      .d_i(origin_d),
      .read_axis_o(segment_point_o),
      .write_o(point_there),
      .point_axis_o(point_axis),
      .segment_start_i(start_point_i),
      .origin_o(origin)
  );
  logic signed [FineBits-1:0] end_q[2];
  assign point_o = {point_there, point_axis, end_q[1], origin};
  always_ff @(posedge clk_i) begin
    end_q[0] <= end_point_i;
    end_q[1] <= end_q[0];
  end

endmodule
`default_nettype wire
