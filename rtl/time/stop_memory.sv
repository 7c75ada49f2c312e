// SPDX-License-Identifier: Apache-2.0
// Stop branches as they pass: the one that a stop may take, the time when it begins, its steps.
// Twin: StopSchedule of hls/stop_schedule.hpp, tick by tick.
//
//   loader -> bank of the next one      piece begins, at rest: it is the present one
//             bank of the present one -> steps -> time scaler, which takes them from the tick on
//                                        that is StopLead ticks of path time after that; some are
//                                        on their way already
//
// If time does not rest in that tick or in one until then the branch only reports the time until
// the next one, and so does a program's first piece without one. A branch without steps of its own,
// again, has those that were loaded last.
//
// step_valid_o comes 3 clocks after the last step was taken.
`default_nettype none
module stop_memory #(
    parameter int Steps = words_pkg::StopSteps,  // most steps of a branch, a power of two
    parameter int Lead  = words_pkg::StopLead    // ticks, more than are ever under way
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Words of the branch before the next piece
    input wire logic        stop_write_i,
    input wire logic        step_write_i,
    input wire logic [43:0] word_i,

    // Ticks as the generator takes them; with take_i the next piece begins
    input wire logic tick_taken_i,
    input wire logic take_i,
    input wire logic first_i,       // it is a program's first

    // Ticks as the scaler takes them: next_wait_o belongs to the next one, begins_o with it
    input  wire logic        tick_i,
    input  wire logic        steady_i,      // time rests in it
    input  wire logic        passed_i,      // a tick of path time begins in it
    output logic      [19:0] next_wait_o,
    output logic             begins_o,
    output logic             step_valid_o,
    input  wire logic        step_ready_i,
    output logic      [43:0] step_o
);

  localparam int Address = $clog2(Steps);
  localparam int Count = $clog2(Lead + 2);

  // What is known of the ticks under way, in their order, 16 at most
  localparam int Way = words_pkg::IdleTicks;
  logic [1:0] marks[Way];
  logic [$clog2(Way)-1:0] next_q;
  logic [$clog2(Way)-1:0] first_q;
  logic passes;
  logic taken_steady;
  logic taken_passed;
  logic taken_passes;
  assign passes = tick_i && passed_i;
  assign {taken_steady, taken_passed} = marks[first_q];
  assign taken_passes = tick_taken_i && taken_passed;
  always_ff @(posedge clk_i) begin
    if (tick_i) marks[next_q] <= {steady_i, passed_i};
    if (!rst_ni) begin
      next_q  <= '0;
      first_q <= '0;
    end else begin
      next_q  <= next_q + ($clog2(Way))'(tick_i);
      first_q <= first_q + ($clog2(Way))'(tick_taken_i);
    end
  end

  // The branch before the next piece
  logic bank_q;  // its own
  logic fresh_q;  // .. has steps that no branch has begun with
  logic own;  // the word is of a branch with steps of its own
  logic loaded_q;
  logic [19:0] loaded_wait_q;
  logic [Address-1:0] write_q;
  logic tells;
  logic accept;
  logic [Count-1:0] gap_q;  // path time since the last report, Lead - 1 at most
  logic apart;
  assign own    = stop_write_i && !word_i[words_pkg::StopAgainLow];
  assign apart  = gap_q == Count'(Lead - 1);
  assign tells  = take_i && (loaded_q || first_i) && apart;
  assign accept = take_i && loaded_q && taken_steady && apart;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      bank_q   <= 1'b0;
      fresh_q  <= 1'b0;
      loaded_q <= 1'b0;
      gap_q    <= Count'(Lead - 1);
    end else begin
      if (accept && fresh_q) bank_q <= !bank_q;
      if (own) fresh_q <= 1'b1;
      else if (accept) fresh_q <= 1'b0;
      if (stop_write_i) loaded_q <= 1'b1;
      else if (take_i) loaded_q <= 1'b0;
      if (tells) gap_q <= '0;
      else if (taken_passes && !apart) gap_q <= gap_q + 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (stop_write_i) begin
      loaded_wait_q <= word_i[words_pkg::StopWaitBits-1:0];
      write_q       <= '0;
    end else if (step_write_i) begin
      write_q <= write_q + 1'b1;
    end
  end

  // Time when it is due: path time of the ticks that the scaler takes before. All of them since the
  // piece began rest if those since the last one that does not are as many.
  logic [Count-1:0] under_way_q;  // between scaler and generator
  logic [Count-1:0] calm_q;  // since a tick that does not rest, Lead - 1 at most
  logic told_q;
  logic due_q;
  logic [Count-1:0] left_q;
  logic [19:0] wait_q;
  assign next_wait_o = (due_q && left_q == '0) ? wait_q : '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      under_way_q <= '0;
      calm_q      <= '0;
      told_q      <= 1'b0;
      due_q       <= 1'b0;
    end else begin
      under_way_q <= under_way_q + Count'(passes) - Count'(taken_passes);
      if (tick_i && !steady_i) calm_q <= '0;
      else if (passes && calm_q != Count'(Lead - 1)) calm_q <= calm_q + 1'b1;
      told_q <= tells;
      if (told_q) due_q <= 1'b1;
      else if (tick_i && left_q == '0) due_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (tells) wait_q <= loaded_q ? loaded_wait_q : 20'd1;
    if (tells) begins_o <= accept;
    else if (told_q && calm_q < under_way_q) begins_o <= 1'b0;
    else if (tick_i && !steady_i) begins_o <= 1'b0;
    if (told_q) left_q <= Count'(Lead - 1) - under_way_q - Count'(passes);
    else if (passes && left_q != '0) left_q <= left_q - 1'b1;
  end

  // Steps: block RAM is slow, so a register follows it.
  logic [43:0] steps[2**(Address+1)];
  logic [43:0] step_q;
  logic [Address-1:0] read_q;
  logic reads_q;
  logic read_valid_q;
  always_ff @(posedge clk_i) begin
    if (step_write_i) steps[{bank_q, write_q}] <= word_i;
    step_q <= steps[{!bank_q, read_q}];
    step_o <= step_q;
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      reads_q      <= 1'b0;
      read_valid_q <= 1'b0;
      step_valid_o <= 1'b0;
    end else begin
      reads_q      <= accept || (step_valid_o && step_ready_i);
      read_valid_q <= reads_q && !accept;
      step_valid_o <= (read_valid_q || (step_valid_o && !step_ready_i)) && !accept;
    end
  end
  always_ff @(posedge clk_i) begin
    if (accept) read_q <= '0;
    else if (step_valid_o && step_ready_i) read_q <= read_q + 1'b1;
  end

endmodule
`default_nettype wire
