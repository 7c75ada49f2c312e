// SPDX-License-Identifier: Apache-2.0
// Counts of encoders, and the distance of each axis from its steps: the registers ENCODER,
// FOLLOWING and their neighbours, which are words of the memory of register_file. That reads and
// writes one of them in each clock of slot_i. One adder serves all axes, in 8 slots each; a word
// read in a slot is added in the next clock:
//
//   slot   reads      adds to sum_q                writes
//   0                                              FOLLOWING_WORST, of the axis before
//   1      ENCODER    an edge
//   2
//   3      FOLLOWING  (as it is, or 0)             ENCODER
//   4      RATIO      counts, for a step
//   5      RATIO      steps, for an edge
//   6      WORST      (compared)
//   7      LIMIT      (compared)                   FOLLOWING
//
// A visit compares pins and count with those of the last visit. So no step or edge is lost if those
// of an axis are a round apart, 8 Axes slots; two edges or two steps within one are the fault
// encoder. Axes without a limit have no fault.
`default_nettype none
module following_error #(
    parameter int Axes = 3  // [1, 9]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Axes; A leads B when an encoder counts up
    input wire logic [  Axes-1:0] a_i,
    input wire logic [  Axes-1:0] b_i,
    input wire logic [2*Axes-1:0] steps_i,      // low bits of their counts
    input wire logic [  Axes-1:0] referenced_i,

    // The memory
    input  wire logic        slot_i,
    output logic      [ 6:0] read_word_o,
    input  wire logic [31:0] data_i,        // word of the last clock
    output logic             write_o,
    output logic      [ 6:0] write_word_o,
    output logic      [31:0] data_o,

    // Faults, for one clock, of this axis
    output logic       encoder_o,
    output logic       following_o,
    output logic [3:0] axis_o
);

  // The slot and its axis; the word that it read is there when read_q is 1
  logic [2:0] slot_q;
  logic [2:0] read_slot_q;
  logic read_q;
  logic [3:0] axis_q;
  logic visit;
  assign visit = slot_i && slot_q == 3'd1;
  always_ff @(posedge clk_i) begin
    read_q      <= rst_ni && slot_i;
    read_slot_q <= slot_q;
    if (!rst_ni) begin
      slot_q <= '0;
      axis_q <= '0;
    end else if (slot_i) begin
      slot_q <= slot_q + 1'b1;
      if (slot_q == 3'd0) axis_q <= axis_q == 4'(Axes - 1) ? '0 : axis_q + 1'b1;
    end
  end

  // Changes on the present axis
  logic [Axes-1:0] here;  // one of them
  logic [3:0] now;
  logic [3:0] was;
  logic [4*Axes-1:0] all;
  logic [4*Axes-1:0] seen_q;
  logic [1:0] steps;
  logic [1:0] pins;
  logic referenced;
  logic was_referenced;
  logic [Axes-1:0] were_q;  // referenced at the last visit
  assign here = Axes'(1) << axis_q;
  always_comb begin
    now = '0;
    was = '0;
    for (int a = 0; a < Axes; a++) begin
      all[4*a+:4] = {a_i[a], b_i[a], steps_i[2*a+:2]};
      now = now | (all[4*a+:4] & {4{here[a]}});
      was = was | (seen_q[4*a+:4] & {4{here[a]}});
    end
  end
  assign steps = now[1:0] - was[1:0];
  assign pins = now[3:2] ^ was[3:2];
  assign referenced = (referenced_i & here) != '0;
  assign was_referenced = (were_q & here) != '0;
  logic step_q, step_back_q;
  logic edge_q, edge_back_q;
  logic bad_q;  // counts are invalid
  logic counts_q;  // the axis is referenced
  logic fresh_q;  // referenced since the last visit
  always_ff @(posedge clk_i) begin
    for (int a = 0; a < Axes; a++) begin
      if (!rst_ni || (visit && here[a])) seen_q[4*a+:4] <= all[4*a+:4];
    end
    if (!rst_ni) were_q <= '0;
    else if (visit) were_q <= (were_q & ~here) | (referenced_i & here);
    if (visit) begin
      step_q      <= steps[0];
      step_back_q <= steps[1];
      edge_q      <= pins[1] != pins[0];
      edge_back_q <= now[3] == was[2];
      bad_q       <= pins == 2'b11 || steps == 2'b10;
      counts_q    <= referenced;
      fresh_q     <= referenced && !was_referenced;
    end
  end

  // The adder. Comparisons: sum_q is above the word that was read, both unsigned. Without a carry a
  // sum_q >= 0 is above it if it is more, one below 0 also if the word is not below 0.
  logic signed [31:0] sum_q;
  logic signed [31:0] first;
  logic signed [31:0] second;
  logic signed [31:0] sum;
  logic minus;
  logic carry;
  logic adds;
  logic compares;
  logic beyond;
  logic limits;
  logic worse_q;
  assign compares = read_slot_q[2] && read_slot_q[1];
  assign adds = read_q && !compares && read_slot_q != 3'd0 && read_slot_q != 3'd2;
  always_comb begin
    first  = sum_q;
    second = data_i;
    minus  = 1'b0;
    carry  = 1'b0;
    case (read_slot_q)
      3'd1: first = edge_q ? {{31{edge_back_q}}, 1'b1} : '0;
      3'd3: begin
        first = '0;
        if (fresh_q) second = '0;
      end
      3'd4: begin
        second = step_q && counts_q ? {16'd0, data_i[15:0]} : '0;
        minus  = step_back_q;
        carry  = step_back_q;
      end
      3'd5: begin
        second = edge_q && counts_q ? 32'($signed(data_i[31:16])) : '0;
        minus  = !edge_back_q;
        carry  = !edge_back_q;
      end
      default: minus = sum_q[31] == data_i[31];
    endcase
    sum = first + (second ^ {32{minus}}) + 32'(carry);
  end
  assign beyond = sum[31] == sum_q[31];
  assign limits = read_q && read_slot_q == 3'd7 && counts_q && data_i != '0;
  always_ff @(posedge clk_i) begin
    if (adds) sum_q <= sum;
    if (!rst_ni) worse_q <= 1'b0;
    else if (read_q && read_slot_q == 3'd6) worse_q <= fresh_q || (beyond && counts_q);
    axis_o      <= axis_q;
    encoder_o   <= rst_ni && limits && bad_q;
    following_o <= rst_ni && limits && beyond;
  end

  // Words of the memory
  always_comb begin
    case (slot_q)
      3'd1:    read_word_o = registers_pkg::Encoder0;
      3'd3:    read_word_o = registers_pkg::Following0;
      3'd6:    read_word_o = registers_pkg::FollowingWorst0;
      3'd7:    read_word_o = registers_pkg::FollowingLimit0;
      default: read_word_o = registers_pkg::EncoderRatio0;
    endcase
    read_word_o = read_word_o + 7'(axis_q);
    case (slot_q)
      3'd0:    write_word_o = registers_pkg::FollowingWorst0;
      3'd3:    write_word_o = registers_pkg::Encoder0;
      default: write_word_o = registers_pkg::Following0;
    endcase
    write_word_o = write_word_o + 7'(axis_q);
    case (slot_q)
      3'd0:    write_o = worse_q;
      3'd3,
      3'd7:    write_o = 1'b1;
      default: write_o = 1'b0;
    endcase
  end
  assign data_o = sum_q;

endmodule
`default_nettype wire
