// SPDX-License-Identifier: Apache-2.0
// rtl/time/stop_memory.sv, with any ticks under way, at most 3: a branch is announced with the
// first tick before which Lead - 1 ticks of path time have passed since the one in which its
// piece began, a first piece without one as if it had one with a wait of 1, and nothing else is;
// not before the branch under way was announced. It begins if time rests in that tick and in all
// since; its first step is that of its own, or of the last branch that had some.
// control: ANY_RATE s/loaded_q \&\& taken_steady/loaded_q/
// control: CHANGED s/tick_i \&\& !steady_i) begins_o/1'b0) begins_o/
// control: ON_ITS_WAY s/told_q \&\& calm_q < under_way_q/1'b0/
// control: EARLY s/left_q <= Count'(Lead - 1)/left_q <= Count'(Lead - 2)/
// control: EVERY_TICK s/passes = tick_i \&\& passed_i/passes = tick_i/
// control: ONLY_STEADY s/(loaded_q || first_i)/(loaded_q \&\& taken_steady || first_i)/
// control: OTHER_BANK s/if (accept \&\& fresh_q) bank_q/if (accept) bank_q/
// control: STALE s/else if (accept) fresh_q <= 1'b0;//
// control: NOT_LOADED s/(loaded_q || first_i)/1'b1/
// control: NOT_FIRST s/(loaded_q || first_i)/loaded_q/
// control: BLIND s/- Count'(passes);/;/
// control: NO_RESET s/due_q       <= 1'b0;//
// long: proved
`default_nettype none
module stop_memory_formal #(
    parameter int Steps = 2,
    parameter int Lead  = 6
) (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        stop_write_i,
    input wire logic        step_write_i,
    input wire logic [43:0] word_i,
    input wire logic        tick_taken_i,
    input wire logic        take_i,
    input wire logic        first_i,
    input wire logic        tick_i,
    input wire logic        steady_i,
    input wire logic        passed_i,
    input wire logic        step_ready_i
);

  logic [19:0] next_wait;
  logic begins;
  logic step_valid;
  logic [43:0] step;
  stop_memory #(
      .Steps(Steps),
      .Lead (Lead)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .stop_write_i,
      .step_write_i,
      .word_i,
      .tick_taken_i,
      .take_i,
      .first_i,
      .tick_i,
      .steady_i,
      .passed_i,
      .next_wait_o(next_wait),
      .begins_o(begins),
      .step_valid_o(step_valid),
      .step_ready_i,
      .step_o(step)
  );

  // Ticks between scaler and generator, the oldest first; path time from the last tick that the
  // generator took to the announcement
  localparam int Most = 3;
  logic started_q = 1'b0;
  logic [1:0] under_way_q;
  logic [1:0] place;
  logic [Most-1:0] way_steady_q;
  logic [Most-1:0] way_passed_q;
  logic [Most-1:0] way_steady;
  logic [Most-1:0] way_passed;
  logic [4:0] to_go_q;
  logic loaded_q;
  logic [19:0] wait_q;
  logic open_q;  // it has not been announced
  logic [19:0] due_wait_q;
  logic due_begins_q;  // as far as the generator knows
  logic counts;
  logic due;
  logic second_q;
  logic stop_q;  // a stop goes on, perhaps
  logic stop;
  logic [4:0] passing;  // path time under way
  logic rests;  // in all that is under way
  logic [Most-1:0] is_under_way;
  assign is_under_way = ~(3'b111 << under_way_q);
  assign passing = 5'(is_under_way[0] && way_passed_q[0]) + 5'(is_under_way[1] && way_passed_q[1]) +
      5'(is_under_way[2] && way_passed_q[2]);
  assign rests = (is_under_way & ~way_steady_q) == '0;
  assign stop = stop_q || (due && begins);
  assign due = open_q && to_go_q <= passing;
  assign counts = take_i && (loaded_q || first_i) && to_go_q == '0;
  assign place = under_way_q - 2'(tick_taken_i);
  assign way_steady = tick_taken_i ? way_steady_q >> 1 : way_steady_q;
  assign way_passed = tick_taken_i ? way_passed_q >> 1 : way_passed_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    way_steady_q <= way_steady;
    way_passed_q <= way_passed;
    if (tick_i) way_steady_q[place] <= steady_i;
    if (tick_i) way_passed_q[place] <= passed_i;
    if (!rst_ni) begin
      under_way_q <= '0;
      loaded_q <= 1'b0;
      open_q <= 1'b0;
      stop_q <= 1'b0;
      to_go_q <= '0;
      second_q <= 1'b0;
    end else begin
      under_way_q <= place + 2'(tick_i);
      if (stop_write_i) loaded_q <= 1'b1;
      else if (take_i) loaded_q <= 1'b0;
      if (counts) open_q <= 1'b1;
      else if (tick_i && due) open_q <= 1'b0;
      if (tick_i) stop_q <= stop && !steady_i;
      if (counts) second_q <= 1'b1;
      if (counts) to_go_q <= 5'(Lead - 1);
      else if (tick_taken_i && to_go_q != '0) to_go_q <= to_go_q - 5'(way_passed_q[0]);
    end
    if (stop_write_i) wait_q <= word_i[19:0];
    if (counts) begin
      due_wait_q   <= loaded_q ? wait_q : 20'd1;
      due_begins_q <= loaded_q && way_steady_q[0];
    end else if (tick_taken_i) begin
      due_begins_q <= due_begins_q && way_steady_q[0];
    end
  end

  // Steps, by one bit of the first one of each branch
  logic again;
  logic known_q;  // some came
  logic own_q;  // those of the branch before the next piece come
  logic [1:0] steps_q;  // .. and so many did
  logic first_q;  // the first one's bit
  logic expected_q;  // .. of the branch that began last
  logic whole_q;  // .. of which nothing is taken
  logic again_q;  // .. which has the steps of the one before
  assign again = word_i[20];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      known_q <= 1'b0;
      own_q   <= 1'b0;
      whole_q <= 1'b0;
    end else begin
      if (stop_write_i && !again) own_q <= 1'b1;
      else if (take_i) own_q <= 1'b0;
      if (step_write_i) known_q <= 1'b1;
      if (counts && loaded_q && way_steady_q[0]) whole_q <= 1'b1;
      else if (step_ready_i && step_valid) whole_q <= 1'b0;
    end
    if (stop_write_i) steps_q <= '0;
    else if (step_write_i) steps_q <= steps_q + 2'd1;
    if (step_write_i && steps_q == '0) first_q <= word_i[0];
    if (counts) expected_q <= first_q;
    if (!rst_ni) again_q <= 1'b0;
    else if (counts && loaded_q && way_steady_q[0]) again_q <= !own_q;
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      // A tick is taken after it is made; a piece begins in one; its words come between two.
      assume (under_way_q < 2'(Most) || !tick_i);
      assume (under_way_q != '0 || !tick_taken_i);
      assume (tick_taken_i || !take_i);
      // Where time does not rest a tick counts whole, but in stops.
      assume (!tick_i || steady_i || passed_i || stop);
      assume (!(take_i && (stop_write_i || step_write_i)));
      if (stop_write_i) assume (word_i[19:0] != '0);
      if (stop_write_i) assume (!step_write_i && !loaded_q && (known_q || !again));
      if (step_write_i) assume (own_q && steps_q != 2'(Steps));
      if (take_i) assume (!own_q || steps_q != '0);

      if (tick_i) begin
        Due : assert (next_wait == (due ? due_wait_q : '0));
        if (due) Begins : assert (begins == (due_begins_q && rests));
      end

      if (whole_q && step_valid) First : assert (step[0] == expected_q);

      Again : cover (whole_q && step_valid && again_q);
      Twice : cover (counts && second_q);
      Taken : cover (tick_i && next_wait != '0 && begins && step_valid);
      Passed : cover (tick_i && next_wait > 20'd1 && !begins);
    end
  end

endmodule
`default_nettype wire
