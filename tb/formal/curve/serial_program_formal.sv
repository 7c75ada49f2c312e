// SPDX-License-Identifier: Apache-2.0
// rtl/serial/serial_program.sv as serial_sequencer.sv issues it: no operation reads a word that an
// earlier one has yet to write (folded_datapath.sv: nine clocks, as c four), whatever the parts and
// the samples under way.
// configuration: order_2 Order=2 AuxAxes=4 Mode=0 Splines=1
// configuration: order_6 Order=6 AuxAxes=0 Mode=0 Splines=0
// configuration: order_12 Order=12 AuxAxes=6 Mode=1 Splines=1
// long: proved.order_12
// control: WAIT_MISSING s/61'h101501a01a0b801b/61'h001501a01a0b801b/
// control: MARK_MISSING s/61'h0c1101b0a0081501/61'h041101b0a0081501/
// control: TENTH_CLOCK
// forget: u_core.u_dut.net_place_q u_core.u_dut.net_frame_q unless u_core.u_dut.net_busy_o
// forget: u_core.u_dut.net_order_q unless u_core.u_dut.net_busy_o
// forget: u_core.u_dut.follow_q unless u_core.u_dut.slice_q
// forget: u_core.u_dut.fetched u_core.u_dut.fetched_net_q unless u_core.u_dut.fetched_valid_q
// forget: u_core.u_dut.fetched_context_q unless u_core.u_dut.fetched_valid_q
// forget: u_core.u_dut.fetched_i_q unless u_core.u_dut.fetched_valid_q
// forget: u_core.u_dut.word u_core.u_dut.net_q u_core.u_dut.context_q unless u_core.u_dut.valid_q
// forget: u_core.u_dut.i_q unless u_core.u_dut.valid_q
`default_nettype none
module serial_program_formal #(
    parameter int Order   = 3,
    parameter int AuxAxes = 1,
    parameter int Mode    = 1,
    parameter int Splines = 1
) (
    input wire logic       clk_i,
    input wire logic       rst_ni,
    input wire logic [2:0] act_i,
    input wire logic       user_take_i
);

  localparam int Bits = 8 + Splines;
`ifdef TENTH_CLOCK
  localparam int Clocks = 10;
`else
  localparam int Clocks = 9;
`endif
  localparam int ClocksOfC = 4;

  logic spline;
  logic [Bits-1:0] a_address;
  logic [Bits-1:0] b_address;
  logic [Bits-1:0] c_address;
  logic [Bits-1:0] d_address;
  logic more;
  logic [1:0] target;
  serial_environment #(
      .Order(Order),
      .AuxAxes(AuxAxes),
      .Mode(Mode),
      .Splines(Splines)
  ) u_core (
      .clk_i,
      .rst_ni,
      .act_i,
      .land_i(1'b0),
      .take_i(user_take_i),
      .net_start_o(),
      .net_busy_o(),
      .spline_o(spline),
      .sample_o(),
      .sample_take_o(),
      .context_o(),
      .free_o(),
      .quiet_o(),
      .issued_o(),
      .held_o(),
      .a_address_o(a_address),
      .b_address_o(b_address),
      .c_address_o(c_address),
      .d_address_o(d_address),
      .more_o(more),
      .target_o(target)
  );

  // Where the last operations write, if they do; the youngest in the low bits.
  localparam int Entry = Bits + 1;
  logic [(Clocks-1)*Entry-1:0] written_q;
  logic [Bits-1:0] place;
  assign place = (target == 2'd1) ? d_address : '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) written_q <= '0;
    else written_q <= {written_q[(Clocks-2)*Entry-1:0], target == 2'd1, place};
  end

  logic early;
  logic early_c;
  always_comb begin
    early   = 1'b0;
    early_c = 1'b0;
    for (int n = 0; n < Clocks - 1; n = n + 1) begin
      if (written_q[n*Entry+:Entry] == {1'b1, a_address}) early = 1'b1;
      if (written_q[n*Entry+:Entry] == {1'b1, b_address}) early = 1'b1;
      if (n < ClocksOfC - 1 && written_q[n*Entry+:Entry] == {1'b1, c_address}) early_c = 1'b1;
    end
  end

  logic started_q = 1'b0;
  logic low_q = 1'b0;  // reset in the clock before
  logic reset_q = 1'b0;  // and in that before it
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    low_q     <= !rst_ni;
    reset_q   <= low_q;
  end
  always_comb begin
    if (!started_q || (low_q && !reset_q)) assume (!rst_ni);
    if (started_q && rst_ni) begin
      if (target != 2'd0 || more) begin
        There : assert (!early);
        ThereAsC : assert (!early_c);
      end
      Sum : cover (more && spline);
      Sample : cover (target == 2'd2 && written_q != '0);
    end
  end

endmodule
`default_nettype wire
