// SPDX-License-Identifier: Apache-2.0
// rtl/control/step_starter.sv: one step at a time, only with room, of one kind; a step is the first
// of its segment exactly if the one before was the last of its own; nothing gets stuck while
// words come: one is taken, or a step starts.  Words are free.
// control: TWICE s/ \&\& start_o == 2'b00 / /
// control: NO_ROOM s/ \&\& room_i / /
// control: STUCK s/(there || !fresh_o)/there/
// control: NEVER_FRESH s/if (done_i) fresh_o <= last_o;/fresh_o <= fresh_o \&\& !done_i;/
// control: NO_RESET s/fresh_o <= 1'b1;/fresh_o <= fresh_o;/
`default_nettype none
module step_starter_formal (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        segment_valid_i,
    input wire logic [47:0] segment_data_i,
    input wire logic        room_i,
    input wire logic        done_i,
    input wire logic [ 3:0] rate_axis_i,
    input wire logic [ 3:0] point_axis_i
);

  logic       segment_ready;
  logic       busy_q;
  logic [1:0] start;
  logic       fresh;
  logic       last;
  logic       spline;
  step_starter #(
      .CoefBits(18),
      .FineBits(18)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .segment_valid_i,
      .segment_ready_o(segment_ready),
      .segment_data_i,
      .empty_segments_o(),
      .room_i,
      .ready_i(!busy_q),
      .done_i,
      .start_o(start),
      .fresh_o(fresh),
      .last_o(last),
      .offset_o(),
      .stride_o(),
      .spline_o(spline),
      .theta_o(),
      .k_o(),
      .lambda_o(),
      .rate_axis_i,
      .tangent_o(),
      .normal_o(),
      .advance_o(),
      .cubic_axis_i('0),
      .a_o(),
      .b_o(),
      .c_o(),
      .point_axis_i,
      .point_o(),
      .end_o()
  );

  logic started_q = 1'b0;
  logic room_q;
  logic first_q;  // the next step must be the first of its segment
  logic [1:0] start_q;
  logic [3:0] idle_q;
  logic [1:0] within_q;  // clocks in which a step of the present segment could have started
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    room_q    <= room_i;
    start_q   <= start;
    if (!rst_ni) begin
      busy_q   <= 1'b0;
      first_q  <= 1'b1;
      idle_q   <= '0;
      within_q <= '0;
      start_q  <= 2'b00;
    end else begin
      if (start != 2'b00) busy_q <= 1'b1;
      else if (done_i) busy_q <= 1'b0;
      if (done_i) first_q <= last;
      within_q <= within_q + 2'd1;
      if (start != 2'b00 || busy_q || !room_i || first_q) within_q <= '0;
      idle_q <= idle_q + 4'd1;
      if (start != 2'b00 || busy_q || !room_i || !segment_valid_i || segment_ready) idle_q <= '0;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (!busy_q) assume (!done_i);

      OneKind : assert (start != 2'b11);
      if (start != 2'b00) OneAtATime : assert (!busy_q);
      if (start != 2'b00) WithRoom : assert (room_q);
      if (start != 2'b00) FirstOfItsSegment : assert (fresh == first_q);
      if (start_q != 2'b00) Kind : assert (spline == start_q[1]);
      if (within_q == 2'd3) GoesOn : assert (1'b0);
      if (idle_q == 4'd6) NeverStuck : assert (1'b0);

      Goes : cover (start != 2'b00 && !fresh);
      Changes : cover (start[0] && fresh && spline);
    end
  end

endmodule
`default_nettype wire
