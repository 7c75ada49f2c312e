// SPDX-License-Identifier: Apache-2.0
// Inputs of the machine, probe, home switches and encoders, and their notes in the memory of
// register_file.
//
//   probe, home -> probe_catch ------------------------> notes
//   A, B        -> glitch_filter -> following_error <--> notes
//
// Each slot of the memory has one note. A caught probe's notes are first; encoders have all the
// others, and the levels of switches those that encoders leave.
`default_nettype none
module machine_inputs #(
    parameter int Axes     = 3,  // [1, 9]
    parameter int Encoders = 0   // [0, 15] 0: none; their pins: rtl/pulse/glitch_filter.sv
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Pins
    input wire logic            probe_i,
    input wire logic [Axes-1:0] home_i,
    input wire logic [Axes-1:0] encoder_a_i,
    input wire logic [Axes-1:0] encoder_b_i,

    // Registers: rtl/bus/probe_catch.sv
    input  wire logic            write_i,
    input  wire logic [     5:0] command_i,
    input  wire logic [Axes-1:0] homed_i,
    output logic                 caught_o,
    input  wire logic [    31:0] steps_i,
    input  wire logic [    31:0] path_i,
    input  wire logic            path_changes_i,

    // Memory: rtl/bus/register_file.sv
    input  wire logic        note_ready_i,
    output logic      [ 6:0] note_word_o,
    output logic      [31:0] note_data_o,
    input  wire logic [ 6:0] word_i,        // word of the request
    output logic      [ 6:0] kept_word_o,
    input  wire logic [31:0] kept_i,
    input  wire logic        kept_ready_i,  // a word is read, not by programs

    // Axes: rtl/bus/following_error.sv
    input  wire logic [2*Axes-1:0] step_counts_i,
    input  wire logic [  Axes-1:0] referenced_i,
    output logic                   encoder_o,
    output logic                   following_o,
    output logic      [       3:0] fault_axis_o
);

  initial if (Encoders < 0 || Encoders > 15) $fatal(1, "Encoders must be in [0, 15]");

  logic catches;
  logic follows;  // it writes in this slot
  logic [6:0] probe_word;
  logic [31:0] probe_data;
  logic [6:0] follow_word;
  logic [31:0] follow_data;
  probe_catch #(
      .Axes(Axes)
  ) u_probe (
      .clk_i,
      .rst_ni,
      .probe_i,
      .home_i,
      .write_i,
      .command_i,
      .homed_i,
      .caught_o,
      .note_ready_i(note_ready_i && !follows),
      .notes_o     (catches),
      .note_word_o (probe_word),
      .note_data_o (probe_data),
      .steps_i,
      .path_i,
      .path_changes_i
  );
  assign note_word_o = follows ? follow_word : probe_word;
  assign note_data_o = follows ? follow_data : probe_data;

  if (Encoders != 0) begin : g_encoders
    logic [Axes-1:0] a, b;
    logic [2*Axes-1:0] levels;
    synchroniser #(
        .Bits(2 * Axes)
    ) u_synchroniser (
        .clk_i,
        .rst_ni,
        .input_i ({encoder_a_i, encoder_b_i}),
        .output_o(levels)
    );
    glitch_filter #(
        .Bits  (2 * Axes),
        .Clocks(Encoders)
    ) u_filter (
        .clk_i,
        .rst_ni,
        .input_i (levels),
        .output_o({a, b})
    );
    // The place of the encoders is known when the memory is.
    logic works_q;
    always_ff @(posedge clk_i) works_q <= rst_ni && (works_q || note_ready_i);
    logic slot;
    logic write;
    assign slot = note_ready_i && !catches && kept_ready_i;
    assign follows = slot && write;
    following_error #(
        .Axes(Axes)
    ) u_following (
        .clk_i,
        .rst_ni      (works_q),
        .a_i         (a),
        .b_i         (b),
        .steps_i     (step_counts_i),
        .referenced_i,
        .slot_i      (slot),
        .read_word_o (kept_word_o),
        .data_i      (kept_i),
        .write_o     (write),
        .write_word_o(follow_word),
        .data_o      (follow_data),
        .encoder_o,
        .following_o,
        .axis_o      (fault_axis_o)
    );
    logic unused;
    assign unused = &{1'b0, word_i};
  end else begin : g_none
    assign follows      = 1'b0;
    assign follow_word  = '0;
    assign follow_data  = '0;
    assign kept_word_o  = word_i;
    assign encoder_o    = 1'b0;
    assign following_o  = 1'b0;
    assign fault_axis_o = '0;
    logic unused;
    assign unused = &{1'b0, encoder_a_i, encoder_b_i, kept_i, kept_ready_i, step_counts_i,
                      referenced_i, catches};
  end

endmodule
`default_nettype wire
