// SPDX-License-Identifier: Apache-2.0
// rtl/bus/register_file.sv: a request that stays is answered in two clocks, once, after a reset in
// 2^7 more, or where programs read or the path changes, in one more besides those clocks; PATH_LO
// is not read while it changes; a push is taken once, or is an error, and not while programs read;
// a note waits for two clocks at most.
// control: WAITS_FOR_ROOM s/works_q <= filled/works_q <= segment_ready_i \&\& filled/
// control: ANSWERS_TWICE s/ \&\& !done_o \&\& !waits/ \&\& !waits/
// control: NO_RESET s/works_q <= 1'b0;//
// control: TAKES_QUIETLY s/(write_q && !taken)/1'b0/
// control: NOTES_WHEN_IDLE s/(!valid_i || done_o ||/(!valid_i ||/
// control: NOTES_WAIT_FOR_OTHERS s/ || (waits \&\& !works_q))/)/
// control: PUSHES_LONG s/works_q \&\& \(write_q \&\& word_q == registers_pkg::SegmentHi\)/\1/
// control: MEETS_PROGRAMS s/ \&\& !(read_next_i \&\& write_i)//
// control: TORN s/read_q || path_changes_i/read_q/
// control: READS_WAIT_TWICE s/(read_next_i \&\& write_i)/read_next_i/
`default_nettype none
module register_file_formal (
    input wire logic       clk_i,
    input wire logic       rst_ni,
    input wire logic       ask_i,
    input wire logic       write_i,
    input wire logic [6:0] word_i,
    input wire logic       segment_ready_i,
    input wire logic       profile_ready_i,
    input wire logic       sample_ready_i,
    input wire logic       control_ready_i,
    input wire logic       reference_ready_i,
    input wire logic       off_i,
    input wire logic       read_next_i,
    input wire logic       path_changes_i
);

  // A shell: a request stays until it is done.
  logic valid_q;
  logic write_q;
  logic [6:0] word_q;
  logic done;
  logic error;
  logic segment_valid;
  logic profile_valid;
  logic sample_valid;
  logic note_ready;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (!valid_q || done) valid_q <= ask_i;
    if (!valid_q || done) begin
      write_q <= write_i;
      word_q  <= word_i;
    end
  end
  register_file u_dut (
      .clk_i,
      .rst_ni,
      .valid_i(valid_q),
      .write_i(write_q),
      .word_i(word_q),
      .data_i(32'd0),
      .done_o(done),
      .error_o(error),
      .off_i,
      .segment_valid_o(segment_valid),
      .segment_ready_i,
      .profile_valid_o(profile_valid),
      .profile_ready_i,
      .sample_valid_o(sample_valid),
      .sample_ready_i,
      .control_ready_i,
      .reference_ready_i,
      .state_i(32'd0),
      .axes_i(32'd0),
      .room_i(32'd0),
      .samples_i(32'd0),
      .outputs_i(32'd0),
      .path_i(64'd0),
      .path_changes_i,
      .rate_i(17'd0),
      .steps_i(32'd0),
      .note_ready_o(note_ready),
      .note_word_i(7'd0),
      .note_data_i(32'd0),
      .kept_word_i(7'd0),
      .read_next_i,
      .read_word_i(7'd0)
  );

  logic started_q = 1'b0;
  logic [7:0] since_q;  // clocks since the reset, 2^7 at most
  logic [1:0] waited_q;  // clocks of the request in which programs do not read
  logic read;  // they read, they read in the clock before, and in that before it
  logic [2:0] read_q;
  assign read = read_q[0];
  logic [1:0] since_asked_q;  // all of them, 2 at most
  logic undisturbed_q;  // programs did not read, nor did the path change, since it was asked
  logic [1:0] notes_wait_q;  // clocks
  logic pushed_q;  // of the request at hand: a push was taken
  logic refused_q;
  logic [1:0] changes_q;  // it changed in the clock before, in that before it
  logic push;
  logic taken;
  assign push = segment_valid || profile_valid || sample_valid;
  assign taken = (segment_valid && segment_ready_i) || (profile_valid && profile_ready_i) ||
      (sample_valid && sample_ready_i);
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!rst_ni) since_q <= '0;
    else if (!since_q[7]) since_q <= since_q + 1'b1;
    if (!rst_ni || !valid_q || done || !since_q[7]) waited_q <= '0;
    else if (!read && !path_changes_i) waited_q <= waited_q + 1'b1;
    read_q <= {read_q[1:0], read_next_i};
    undisturbed_q <= !rst_ni || !valid_q || done || !since_q[7] ||
        (undisturbed_q && !read && !path_changes_i);
    changes_q <= {changes_q[0], path_changes_i};
    if (!rst_ni || !valid_q || done || !since_q[7]) since_asked_q <= '0;
    else if (!since_asked_q[1]) since_asked_q <= since_asked_q + 1'b1;
    if (!rst_ni || note_ready || !since_q[7]) notes_wait_q <= '0;
    else notes_wait_q <= notes_wait_q + 1'b1;
    if (!rst_ni || done) begin
      pushed_q  <= 1'b0;
      refused_q <= 1'b0;
    end else begin
      if (taken) pushed_q <= 1'b1;
      if (push && !taken) refused_q <= 1'b1;
    end
  end

  always_comb begin
    if (!started_q) assume (!rst_ni);
    if (changes_q == 2'b10 || read_q[2:1] == 2'b10)  // programs leave two clocks
      assume (!read && !path_changes_i);
    if (read) assume (!path_changes_i);
    if (started_q && rst_ni) begin
      In_time : assert (!(valid_q && !done && waited_q == 2'd3));
      At_once : assert (!(valid_q && !done && waited_q == 2'd2 && (undisturbed_q || !write_q)));
      Only_asked : assert (!done || valid_q);
      Not_sooner : assert (!done || since_asked_q == 2'd2);
      Undisturbed : assert (!(push && read));
      Push_asked : assert (!push || (valid_q && write_q && !done));
      Pushed_once : assert (!(push && (pushed_q || refused_q)));
      Whole : assert (!(done && !write_q && word_q == registers_pkg::PathLo && changes_q[1]));
      Refused_is_error : assert (!(done && refused_q && !error));
      Taken_is_none : assert (!(done && pushed_q && error));
      Noted : assert (note_ready || notes_wait_q != 2'd2);
      Answered : cover (done && !error);
      Refused : cover (done && error && refused_q);
      Waited : cover (done && word_q == registers_pkg::PathLo && !undisturbed_q);
      Pushed : cover (done && pushed_q);
    end
  end

endmodule
`default_nettype wire
