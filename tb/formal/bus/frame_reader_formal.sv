// SPDX-License-Identifier: Apache-2.0
// rtl/line/frame_reader.sv with any bytes, behind registers that answer in two clocks: no bytes
// stop it; a request stays until it is answered, and is no write of EXPECT; an answer is closed
// once, after a byte of it.
// control: HANGS_ON_A_BYTE s/takes = !last;/takes = !last \&\& !low_q[7];/
// control: LEAVES_EARLY s/(!asks || done_i)/1/
// control: WRITES_NUMBERS s/writes_q \&\& !expects/writes_q/; s/ || expects}/}/
// control: CLOSES_NOTHING s/Finish \&\& answered_q/Finish/
// control: CLOSES_TWICE s/(!answered_q || ready_i) state_q/(write_o) state_q/
`default_nettype none
module frame_reader_formal (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        read_valid_i,
    input wire logic [ 7:0] read_i,
    input wire logic        ready_i,
    input wire logic [31:0] data_i
);

  logic next;
  logic data_valid;
  logic [7:0] data;
  logic close;
  logic valid;
  logic write;
  logic [6:0] word;
  logic [31:0] written;

  // Registers: rtl/bus/register_file.sv
  logic works_q;
  logic done_q;
  always_ff @(posedge clk_i) begin
    works_q <= rst_ni && valid && !works_q && !done_q;
    done_q  <= rst_ni && works_q;
  end

  frame_reader u_dut (
      .clk_i,
      .rst_ni,
      .read_valid_i,
      .read_i,
      .next_o      (next),
      .data_valid_o(data_valid),
      .data_o      (data),
      .close_o     (close),
      .ready_i,
      .valid_o     (valid),
      .write_o     (write),
      .word_o      (word),
      .data32_o    (written),
      .done_i      (done_q),
      .data32_i    (data_i)
  );

  logic started_q = 1'b0;
  logic ran_q;
  logic [3:0] waits_q;  // clocks without progress in which every party was ready
  logic goes_on;
  logic asked_q;
  logic [39:0] request_q;
  logic said_q;  // a byte since the last close
  assign goes_on = next || done_q || ((data_valid || close) && ready_i);
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    ran_q     <= rst_ni;
    if (!rst_ni || goes_on) waits_q <= '0;
    else if (read_valid_i && ready_i) waits_q <= waits_q + 1'b1;
    asked_q   <= rst_ni && valid && !done_q;
    request_q <= {write, word, written};
    if (!rst_ni || (close && ready_i)) said_q <= 1'b0;
    else if (data_valid && ready_i) said_q <= 1'b1;
  end

  always_comb begin
    if (!started_q) assume (!rst_ni);
    if (started_q && ran_q && rst_ni) begin
      Goes_on : assert (waits_q < 4'd8);
      Stays : assert (!asked_q || (valid && request_q == {write, word, written}));
      No_number : assert (!(valid && write) || word != registers_pkg::Expect);
      Closed_behind_a_byte : assert (!close || said_q);
      One : assert (!(close && data_valid));
      Reads : cover (valid && done_q && !write);
      Writes : cover (valid && done_q && write && word == registers_pkg::SegmentHi);
      Closes : cover (close && ready_i);
    end
  end

endmodule
`default_nettype wire
