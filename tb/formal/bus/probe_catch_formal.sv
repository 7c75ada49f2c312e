// SPDX-License-Identifier: Apache-2.0
// rtl/bus/probe_catch.sv: a level that an armed switch has on one edge of the clock is caught, and
// nothing else is; then every axis and the path are noted, once and in order, with their values on
// that clock, the path on the first one that does not change it.
// control: BLINKS s/armed_q \&\& levels/armed_q \&\& note_ready_i \&\& levels/
// control: ANY_LEVEL s/ == high_q/ != 2'd2/
// control: ANY_SWITCH s/levels\[switch_q\]/(levels != 16'd0)/
// control: SKIPS s/else if (noted) note_q/else note_q/
// control: SAYS_IT_EARLY s/ \&\& note_q == Path//
// control: TORN s/ \&\& !(note_q == Path \&\& path_changes_i)//
// control: FORGETS_IT s/else if (armed_q/else if (caught_o) caught_o <= 1'b0; else if (armed_q/
`default_nettype none
module probe_catch_formal (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        probe_i,
    input wire logic [ 1:0] home_i,
    input wire logic        write_i,
    input wire logic [ 5:0] command_i,
    input wire logic        note_ready_i,
    input wire logic [31:0] steps_i,
    input wire logic [31:0] path_i,
    input wire logic        path_changes_i
);

  logic caught;
  logic [6:0] word;
  logic [31:0] data;
  probe_catch #(
      .Axes(2)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .probe_i,
      .home_i,
      .write_i,
      .command_i,
      .homed_i(2'b00),
      .caught_o(caught),
      .note_ready_i,
      .note_word_o(word),
      .note_data_o(data),
      .steps_i,
      .path_i,
      .path_changes_i
  );

  // The pins, two clocks ago
  logic [2:0] first_q;
  logic [2:0] pins_q;
  logic started_q = 1'b0;
  // What is to be noted next: 0, 1 an axis, 2 the path, 3 nothing; 4 all was
  logic [2:0] next_q;
  logic waits_q;
  logic [4:0] for_q;
  logic there;
  always_comb begin
    case (for_q[3:0])
      4'd0:    there = pins_q[0] == for_q[4];
      4'd1:    there = pins_q[1] == for_q[4];
      4'd15:   there = pins_q[2] == for_q[4];
      default: there = !for_q[4];
    endcase
  end
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    first_q   <= rst_ni ? {probe_i, home_i} : 3'b111;
    pins_q    <= rst_ni ? first_q : 3'b111;
    if (write_i) for_q <= command_i[4:0];
    if (!rst_ni) begin
      waits_q <= 1'b0;
      next_q  <= 3'd3;
    end else if (write_i) begin
      waits_q <= command_i[5];
      next_q  <= 3'd3;
    end else if (waits_q && there) begin
      waits_q <= 1'b0;
      next_q  <= 3'd0;
    end else if (note_ready_i) begin
      if (next_q < 3'd2) next_q <= next_q + 3'd1;
      if (next_q == 3'd2 && !path_changes_i) next_q <= 3'd4;
    end
  end

  logic switches;
  assign switches = word == registers_pkg::Switches;
  always_comb begin
    if (!started_q) assume (!rst_ni);
    if (started_q && rst_ni) begin
      Caught : assert (caught == (next_q == 3'd4));
      Switches : assert (switches == (next_q >= 3'd3));
      Levels : assert (!switches || data[9:0] == {pins_q[2], 7'd0, pins_q[1:0]});
      First : assert (next_q != 3'd0 || (word == 7'd67 && data == steps_i));
      Second : assert (next_q != 3'd1 || (word == 7'd71 && data == steps_i));
      Path : assert (next_q != 3'd2 || (word == registers_pkg::CaughtPath && data == path_i));
      Catches : cover (caught && for_q == 5'h1f);
      Waits : cover (waits_q && for_q == 5'h00);
    end
  end

endmodule
`default_nettype wire
