// SPDX-License-Identifier: Apache-2.0
// rtl/bus/wishbone_port.sv before registers that answer in two clocks: an access is answered within
// two clocks, once, by ack or err, as the registers did; a part of a word reaches no register.
// control: WRITES_PARTS s/asks \&\& !part;/asks;/
// control: HANGS_ON_PARTS s/ || part_q;/;/
// control: ACKS_ERRORS s/done_i \&\& !error_i/done_i/
// control: ANSWERS_TWICE s/ \&\& !part_q;/;/
`default_nettype none
module wishbone_port_formal (
    input wire logic       clk_i,
    input wire logic       rst_ni,
    input wire logic       ask_i,
    input wire logic       we_i,
    input wire logic [3:0] sel_i,
    input wire logic       error_i
);

  // A master whose access stays until it is answered.
  logic stb_q;
  logic we_q;
  logic [3:0] sel_q;
  logic ack;
  logic err;
  logic valid;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) stb_q <= 1'b0;
    else if (!stb_q || ack || err) stb_q <= ask_i;
    if (!stb_q || ack || err) begin
      we_q  <= we_i;
      sel_q <= sel_i;
    end
  end

  // Registers: rtl/bus/register_file.sv
  logic works_q;
  logic done_q;
  logic error_q;
  always_ff @(posedge clk_i) begin
    works_q <= rst_ni && valid && !works_q && !done_q;
    done_q  <= rst_ni && works_q;
    if (works_q) error_q <= error_i;
  end

  wishbone_port u_dut (
      .clk_i,
      .rst_ni,
      .cyc_i(stb_q),
      .stb_i(stb_q),
      .we_i(we_q),
      .adr_i(7'd0),
      .dat_i(32'd0),
      .sel_i(sel_q),
      .ack_o(ack),
      .err_o(err),
      .valid_o(valid),
      .done_i(done_q),
      .error_i(error_q),
      .data_i(32'd0)
  );

  logic started_q = 1'b0;
  logic ran_q;
  logic [1:0] waits_q;
  logic part;
  assign part = we_q && sel_q != 4'b1111;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    ran_q     <= rst_ni;
    if (!rst_ni || !stb_q || ack || err) waits_q <= '0;
    else waits_q <= waits_q + 1'b1;
  end

  always_comb begin
    if (!started_q) assume (!rst_ni);
    if (started_q && ran_q && rst_ni) begin
      In_time : assert (!stb_q || ack || err || waits_q < 2'd2);
      One : assert (!(ack && err));
      Asked : assert (!(ack || err) || (stb_q && waits_q != 2'd0));
      Error_told : assert (!(ack || err) || err == (part || error_q));
      Whole_words : assert (!valid || !part);
      Acked : cover (ack);
      Refused : cover (err && !part);
      Part : cover (err && part);
    end
  end

endmodule
`default_nettype wire
