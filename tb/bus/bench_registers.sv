// SPDX-License-Identifier: Apache-2.0
// The registers behind a bus under test, beside a motion that stands and has room for segments, but
// none for pieces.
`default_nettype none
module bench_registers (
    input  wire logic        clk_i,
    input  wire logic        rst_ni,
    input  wire logic        valid_i,
    input  wire logic        write_i,
    input  wire logic [ 6:0] word_i,
    input  wire logic [31:0] data_i,
    output logic             done_o,
    output logic             error_o,
    output logic      [31:0] data_o
);

  register_file #(
      .Axes(3)
  ) u_file (
      .clk_i,
      .rst_ni,
      .valid_i,
      .write_i,
      .word_i,
      .data_i,
      .done_o,
      .error_o,
      .data_o,
      .off_i(1'b1),
      .segment_ready_i(1'b1),
      .profile_ready_i(1'b0),
      .sample_ready_i(1'b0),
      .control_ready_i(1'b1),
      .reference_ready_i(1'b0),
      .state_i(32'd0),
      .axes_i(32'd0),
      .room_i(32'd0),
      .samples_i(32'd0),
      .outputs_i(32'd0),
      .path_changes_i(1'b0),
      .path_i(64'd0),
      .rate_i(17'd0),
      .steps_i(32'd0),
      .note_ready_o(),
      .note_word_i(registers_pkg::Switches),
      .note_data_i(32'd0),
      .kept_word_i(word_i),
      .kept_o(),
      .kept_ready_o(),
      .read_next_i(1'b0),
      .read_word_i(7'd0),
      .setting_o()
  );

endmodule
`default_nettype wire
