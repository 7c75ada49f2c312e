// SPDX-License-Identifier: Apache-2.0
// rtl/pulse/sample_period.sv: every axis is loaded once in each period, 2^PeriodLog2 clocks after
// the load before; rates are read when they are there, and taken when all are read.
// control: SHORT_PERIOD s/if (tick_o) begin/if (count_q[5:1] == '1) begin/
// control: READS_NOTHING s/read_o = walks_q \&\& valid_q/read_o = walks_q/
// control: SKIPS_LAST s/assign last = .*/assign last = read_axis_o == 4'(Axes - 2);/
// control: NO_RESET s/walks_q     <= 1'b0;//
// control: NEVER_LATE s/!valid_i \&\& moving_q/1'b0/
`default_nettype none
module sample_period_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic made_i,
    input wire logic moves_i
);

  localparam int Axes = 3;
  localparam int PeriodLog2 = 6;

  logic valid_q;  // rates are made, and stay until they are taken
  logic read;
  logic [3:0] axis;
  logic taken;
  logic tick;
  logic late;
  logic [Axes-1:0] load;
  logic none;
  sample_period #(
      .Axes      (Axes),
      .PeriodLog2(PeriodLog2)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .valid_i(valid_q),
      .moves_i,
      .read_o(read),
      .read_axis_o(axis),
      .taken_o(taken),
      .tick_o(tick),
      .late_o(late),
      .load_o(load),
      .none_o(none)
  );

  logic started_q = 1'b0;
  logic loaded_q;  // axis 0, since the reset
  logic [PeriodLog2-1:0] since_q;  // its last load
  logic [2:0] tick_q;
  logic [1:0] read_q;
  logic [3:0] axis_q;
  logic [3:0] before_q;
  logic moved_q;  // a rate that was loaded since the last tick was not 0
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    read_q <= {read_q[0], read};
    tick_q <= rst_ni ? {tick_q[1:0], tick} : '0;
    before_q <= axis;
    axis_q <= before_q;
    if (!rst_ni) begin
      valid_q  <= 1'b0;
      loaded_q <= 1'b0;
      since_q  <= '0;
      moved_q  <= 1'b0;
    end else begin
      if (taken) valid_q <= 1'b0;
      else if (made_i) valid_q <= 1'b1;
      if (load[0]) loaded_q <= 1'b1;
      since_q <= load[0] ? 1 : since_q + 1'b1;
      if (tick) moved_q <= 1'b0;
      else if (load != '0 && !none && moves_i) moved_q <= 1'b1;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (loaded_q) begin
        Period : assert (load[0] == (since_q == 0));
        Second : assert (load[1] == (since_q == 1));
        Third : assert (load[2] == (since_q == 2));
      end
      First : assert (load[0] == tick_q[2]);
      if (read) ReadsWhatIsThere : assert (valid_q);
      if (taken) AllAreRead : assert (read && axis == 4'(Axes - 1));
      if (load != '0) ReadBefore : assert (none == !read_q[1]);
      if (load != '0 && !none) InOrder : assert (load == Axes'(1) << axis_q);
      Late : assert (late == (tick && !valid_q && moved_q));

      Loads : cover (load[2] && !none && loaded_q);
      Misses : cover (late);
    end
  end

endmodule
`default_nettype wire
