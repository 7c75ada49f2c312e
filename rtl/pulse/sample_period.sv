// SPDX-License-Identifier: Apache-2.0
// The sample period, 2^PeriodLog2 clocks, endless: once in each the rates of all axes are loaded,
// one per clock.
//
//   clock          0        1    2    3    ..   Axes     Axes + 2
//   tick_o         1
//   read_o         0        1    1    1    ..   1
//   read_axis_o             0    1    2         Axes-1
//   load_o                            axis 0    ..       axis Axes - 1
//   taken_o                                     1
//
// A period without rates stops all axes in place: they continue with the next. That is a jerk if
// they were moving: late_o.
`default_nettype none
module sample_period #(
    parameter int Axes       = 3,  // [1, 9]
    parameter int PeriodLog2 = 13  // [6, 20]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic       valid_i,      // rates are present
    input  wire logic       moves_i,      // the one that is loaded is not 0
    output logic            read_o,
    output logic      [3:0] read_axis_o,
    output logic            taken_o,

    output logic            tick_o,
    output logic            late_o,
    output logic [Axes-1:0] load_o,
    output logic            none_o   // the load has no rates
);

  logic [PeriodLog2-1:0] count_q;
  logic walks_q;
  logic [Axes-1:0] next_q;  // axis of the next load_o
  logic valid_q;
  logic moving_q;
  logic last;
  assign tick_o = count_q == '1;
  assign late_o = tick_o && !valid_i && moving_q;
  assign last = read_axis_o == 4'(Axes - 1);
  assign read_o = walks_q && valid_q;
  assign taken_o = read_o && last;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      count_q     <= '0;
      walks_q     <= 1'b0;
      valid_q     <= 1'b0;
      moving_q    <= 1'b0;
      read_axis_o <= '0;
      next_q      <= '0;
      load_o      <= '0;
    end else begin
      count_q <= count_q + 1'b1;
      if (tick_o) begin
        walks_q  <= 1'b1;
        valid_q  <= valid_i;
        moving_q <= 1'b0;
      end else begin
        if (last) walks_q <= 1'b0;
        if (load_o != '0 && valid_q && moves_i) moving_q <= 1'b1;
      end
      if (walks_q) read_axis_o <= last ? '0 : read_axis_o + 1'b1;
      next_q <= walks_q ? Axes'(1) << read_axis_o : '0;
      load_o <= next_q;
    end
  end
  always_ff @(posedge clk_i) none_o <= !valid_q;

endmodule
`default_nettype wire
