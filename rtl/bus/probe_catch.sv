// SPDX-License-Identifier: Apache-2.0
// Probe and home switches: the one that PROBE of hls/registers/registers.rdl waits for, and the
// notes of its event. Notes need no register: they go into the memory of register_file, which says
// when, at most 3 clocks later; so do the switches, all the time.
//
//   clock           0      2         3                 then with note_ready_i
//   pin             as asked
//   .. synchronised        as asked
//   note_data_o                      steps of axis 0   steps of axis 1, .., path, switches again
//   caught_o                                                                  1
//
// A level present on one rising edge of the clock suffices. caught_o stays until write_i.
`default_nettype none
module probe_catch #(
    parameter int Axes = 3  // [1, 9]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Pins
    input wire logic            probe_i,
    input wire logic [Axes-1:0] home_i,

    // Registers
    input  wire logic            write_i,    // PROBE
    input  wire logic [     5:0] command_i,
    input  wire logic [Axes-1:0] homed_i,
    output logic                 caught_o,

    // Notes
    input  wire logic        note_ready_i,
    output logic             notes_o,        // notes besides the switches
    output logic      [ 6:0] note_word_o,
    output logic      [31:0] note_data_o,
    input  wire logic [31:0] steps_i,        // steps of the axis in note_word_o
    input  wire logic [31:0] path_i,
    input  wire logic        path_changes_i  // its note waits
);

  logic probe;
  logic [Axes-1:0] home;
  synchroniser #(
      .Bits(Axes + 1)
  ) u_synchroniser (
      .clk_i,
      .rst_ni,
      .input_i ({probe_i, home_i}),
      .output_o({probe, home})
  );

  // The awaited event
  logic armed_q;
  logic high_q;
  logic [3:0] switch_q;
  logic [15:0] levels;
  always_comb begin
    levels = {probe, 15'd0};
    levels[Axes-1:0] = home;
  end

  // Notes: steps of each axis, then the path
  localparam logic [3:0] Path = 4'(Axes);
  logic notes_q;
  logic [3:0] note_q;
  logic noted;
  assign noted = note_ready_i && !(note_q == Path && path_changes_i);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      armed_q  <= 1'b0;
      notes_q  <= 1'b0;
      caught_o <= 1'b0;
    end else if (write_i) begin
      armed_q  <= command_i[registers_pkg::ProbeArmedLow];
      notes_q  <= 1'b0;
      caught_o <= 1'b0;
    end else if (armed_q && levels[switch_q] == high_q) begin
      armed_q <= 1'b0;
      notes_q <= 1'b1;
    end else if (notes_q && noted && note_q == Path) begin
      notes_q  <= 1'b0;
      caught_o <= 1'b1;
    end
    if (write_i) begin
      switch_q <= command_i[registers_pkg::ProbeSwitchLow+:4];
      high_q   <= command_i[registers_pkg::ProbeHighLow];
    end
    if (!notes_q) note_q <= '0;
    else if (noted) note_q <= note_q + 1'b1;
  end

  assign notes_o = notes_q;
  logic [31:0] switches;
  always_comb begin
    switches = 32'd0;
    switches[registers_pkg::SwitchesHomeLow+:Axes] = home;
    switches[registers_pkg::SwitchesProbeLow] = probe;
    switches[registers_pkg::SwitchesHomedLow+:Axes] = homed_i;
    if (!notes_q) begin
      note_word_o = registers_pkg::Switches;
      note_data_o = switches;
    end else if (note_q == Path) begin
      note_word_o = registers_pkg::CaughtPath;
      note_data_o = path_i;
    end else begin
      note_word_o = {1'b1, note_q, registers_pkg::AxisCaught};
      note_data_o = steps_i;
    end
  end

endmodule
`default_nettype wire
