// SPDX-License-Identifier: Apache-2.0
// rtl/time/stop_memory.sv, with any ticks under way, at most 16: a branch is announced StopLead
// ticks after the one in which its piece began, a first piece without one as if it had one with a
// wait of 1, and nothing else is; not before the branch under way was announced. It begins if that
// tick had the rate 1.
// control: ANY_RATE s/ \&\& full_i//
// control: EARLY s/Count'(Lead - 1)/Count'(Lead - 2)/
// control: ONLY_FULL s/(loaded_q || first_i)/(loaded_q \&\& full_i || first_i)/
// control: NOT_LOADED s/(loaded_q || first_i)/1'b1/
// control: NOT_FIRST s/(loaded_q || first_i)/loaded_q/
// control: BLIND s/- Count'(tick_i);/;/
// control: NO_RESET s/due_q       <= 1'b0;//
// long: proved
`default_nettype none
module stop_memory_formal #(
    parameter int Steps = 2
) (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        stop_write_i,
    input wire logic        step_write_i,
    input wire logic [43:0] word_i,
    input wire logic        tick_taken_i,
    input wire logic        take_i,
    input wire logic        first_i,
    input wire logic        full_i,
    input wire logic        tick_i,
    input wire logic        step_ready_i
);

  logic [19:0] next_wait;
  logic begins;
  logic step_valid;
  logic [43:0] step;
  stop_memory #(
      .Steps(Steps)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .stop_write_i,
      .step_write_i,
      .word_i,
      .tick_taken_i,
      .take_i,
      .first_i,
      .full_i,
      .tick_i,
      .next_wait_o(next_wait),
      .begins_o(begins),
      .step_valid_o(step_valid),
      .step_ready_i,
      .step_o(step)
  );

  // Ticks between scaler and generator; ticks from the generator to the announcement
  logic started_q = 1'b0;
  logic [4:0] under_way_q;
  logic [5:0] to_go_q;
  logic loaded_q;
  logic [19:0] wait_q;
  logic [5:0] since_q;  // ticks since the last one that counted, 33 at most
  logic due_q;
  logic [19:0] due_wait_q;
  logic due_begins_q;
  logic counts;
  logic due;
  logic second_q;
  assign due    = due_q && to_go_q == {1'b0, under_way_q};
  assign counts = take_i && (loaded_q || first_i) && since_q > 6'd32;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!rst_ni) begin
      under_way_q <= '0;
      loaded_q <= 1'b0;
      since_q  <= 6'd33;
      due_q    <= 1'b0;
      second_q <= 1'b0;
    end else begin
      under_way_q <= under_way_q + {4'b0, tick_i} - {4'b0, tick_taken_i};
      if (stop_write_i) loaded_q <= 1'b1;
      else if (take_i) loaded_q <= 1'b0;
      if (counts) since_q <= 6'd1;
      else if (tick_taken_i && since_q <= 6'd32) since_q <= since_q + 1'b1;
      if (counts) due_q <= 1'b1;
      else if (tick_i && due) due_q <= 1'b0;
      if (counts) second_q <= 1'b1;
    end
    if (stop_write_i) wait_q <= word_i[19:0];
    if (counts) begin
      to_go_q      <= 6'd31;
      due_wait_q   <= loaded_q ? wait_q : 20'd1;
      due_begins_q <= loaded_q && full_i;
    end else if (tick_taken_i) begin
      to_go_q <= to_go_q - 1'b1;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      // A tick is taken after it is made; a piece begins in one; its words come between two.
      assume (under_way_q < 5'd16 || !tick_i);
      assume (under_way_q != '0 || !tick_taken_i);
      assume (tick_taken_i || !take_i);
      assume (!(take_i && (stop_write_i || step_write_i)));
      if (stop_write_i) assume (word_i[19:0] != '0);

      if (tick_i) begin
        Due : assert (next_wait == (due ? due_wait_q : '0));
        if (due) Begins : assert (begins == due_begins_q);
      end

      Twice : cover (counts && second_q);
      Taken : cover (tick_i && next_wait != '0 && begins && step_valid);
      Passed : cover (tick_i && next_wait > 20'd1 && !begins);
    end
  end

endmodule
`default_nettype wire
