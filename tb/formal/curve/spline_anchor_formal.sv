// SPDX-License-Identifier: Apache-2.0
// rtl/anchor/spline_anchor.sv: every begin starts the network once, in the cycle of the table in
// its header, and gives every word in its cycle and in no other; at rest, where a begin finds it,
// nothing comes. A reset lasts two clocks, and starts nothing. Anchor 0: a segment's first step has
// what every step has with 1.
// control: LOSES_BEGIN s/else if (begin_i) time_q/else if (begin_i \&\& !quiet_q) time_q/
// control: ALWAYS_LOUD s/quiet_q <= !fresh_i \&\& Anchor == 0/quiet_q <= 1'b0/
// control: LOSES_WORD s/sum_kind_q == anchor_pkg::Slope;/sum_kind_q == anchor_pkg::E;/
// control: ENDS_EARLY s/time_q == 8'd136) time_q/time_q == 8'd80) time_q/
// control: NO_RESET s/there_q        <= 6'd0;/there_q        <= {there_q[4:0], run_end};/
// forget: u_dut.u_program.op_q u_dut.u_program.op_axis_q unless u_dut.u_program.run_q
`default_nettype none
module spline_anchor_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic begin_i,
    input wire logic fresh_i
);

  localparam int Clocks = 136;

  logic [spline_pkg::LoadBits-1:0] load;
  logic [2:0] six_a;
  logic [2:0] v;
  logic [2:0] w;
  logic phi;
  logic q;
  logic r;
  logic again;
  logic start_network;
  logic [2:0] step_a;
  logic d;
  logic [1:0] d_axis;
  logic [1:0] axis;
  logic [17:0] word;
  logic [17:0] d_word;
  logic [37:0] factors;
  spline_anchor #(
      .CoefBits(18),
      .Anchor  (0)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .begin_i,
      .fresh_i,
      .s_i('0),
      .theta_i('0),
      .phi_end_i('0),
      .moved_i('0),
      .axis_o(axis),
      .a_i('0),
      .b_i('0),
      .c_i('0),
      .load_o(load),
      .start_o(start_network),
      .word_o(word),
      .step_a_there_o(step_a),
      .d_there_o(d),
      .d_axis_o(d_axis),
      .d_o(d_word),
      .factors_o(factors),
      .product_i('0)
  );
  assign six_a = load[spline_pkg::SixA+:3];
  assign v     = load[spline_pkg::V+:3];
  assign w     = load[spline_pkg::W+:3];
  assign phi   = load[spline_pkg::Phi];
  assign q     = load[spline_pkg::Q];
  assign r     = load[spline_pkg::R];
  assign again = load[spline_pkg::Again];
  logic unused;
  assign unused = ^{axis, word, d_word, factors};

  logic started_q = 1'b0;
  logic low_q = 1'b0;  // reset in the clock before
  logic reset_q = 1'b0;  // and in that before it
  logic [7:0] cycle_q;  // 0: at rest
  logic loud_q;  // the network is loaded anew
  logic quiet;
  logic rest;
  assign rest  = cycle_q == 8'd0;
  assign quiet = !loud_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    low_q     <= !rst_ni;
    reset_q   <= low_q;
    if (!rst_ni) loud_q <= 1'b0;
    else if (begin_i) loud_q <= fresh_i;
    if (!rst_ni) cycle_q <= '0;
    else if (begin_i) cycle_q <= 8'd1;
    else if (rest || cycle_q == 8'(Clocks)) cycle_q <= '0;
    else cycle_q <= cycle_q + 8'd1;
  end

  always_comb begin
    if (!started_q || (low_q && !reset_q)) assume (!rst_ni);
    if (!rst_ni || !rest) assume (!begin_i);
    if (started_q && rst_ni) begin
      Start : assert (start_network == (cycle_q == (quiet ? 8'd3 : 8'd92)));
      Again : assert (again == (cycle_q == 8'd3 && quiet));
      SixA : assert (six_a == {cycle_q == 8'd14, cycle_q == 8'd11, cycle_q == 8'd8});
      StepA : assert (step_a == {cycle_q == 8'd15, cycle_q == 8'd12, cycle_q == 8'd9});
      V : assert (v == ({3{loud_q}} & {cycle_q == 8'd40, cycle_q == 8'd36, cycle_q == 8'd32}));
      W : assert (w == ({3{loud_q}} & {cycle_q == 8'd76, cycle_q == 8'd65, cycle_q == 8'd48}));
      Phi : assert (phi == (loud_q && cycle_q == 8'd90));
      R : assert (r == (loud_q && cycle_q == 8'd102));
      Q : assert (q == (loud_q && cycle_q == 8'd112));
      D : assert (d == (cycle_q == 8'd127 || cycle_q == 8'd131 || cycle_q == 8'd135));
      if (d) AxisOfD : assert (d_axis == cycle_q[3:2] + 2'd1);

      WholeStep : cover (cycle_q == 8'(Clocks) && quiet);
    end
  end

endmodule
`default_nettype wire
