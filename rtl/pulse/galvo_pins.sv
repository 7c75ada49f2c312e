// SPDX-License-Identifier: Apache-2.0
// Pins of a scan head: rtl/pulse/xy2_100.sv, or nothing with Galvo = 0. A sample that is taken axis
// by axis goes out whole.
`default_nettype none
module galvo_pins #(
    parameter int Galvo      = 0,   // 0, 1
    parameter int Axes       = 3,   // [3, 9]
    parameter int FineBits   = 42,  // [18, 44] bits of a position
    parameter int PeriodLog2 = 9    // [7, 20] with Galvo
) (
    input  wire logic                     clk_i,
    input  wire logic                     rst_ni,
    input  wire logic                     tick_i,
    input  wire logic                     sample_taken_i,
    input  wire logic [Axes*FineBits-1:0] sample_i,
    input  wire logic                     by_axis_i,
    input  wire logic [              3:0] axis_i,          // its position is a clock later
    input  wire logic [     FineBits-1:0] position_i,
    output logic                          clock_o,
    output logic                          sync_o,
    output logic      [              2:0] data_o
);

  initial if (Galvo != 0 && Galvo != 1) $fatal(1, "Galvo must be 0 or 1");

  if (Galvo == 1) begin : gen_galvo
    logic [Axes*FineBits-1:0] gathered;
    sample_gather #(
        .Axes    (Axes),
        .FineBits(FineBits)
    ) u_gather (
        .clk_i,
        .axis_i,
        .position_i,
        .sample_o(gathered)
    );
    xy2_100 #(
        .Axes      (Axes),
        .FineBits  (FineBits),
        .PeriodLog2(PeriodLog2)
    ) u_frames (
        .clk_i,
        .rst_ni,
        .tick_i,
        .sample_taken_i,
        .sample_i(by_axis_i ? gathered : sample_i),
        .clock_o,
        .sync_o,
        .data_o
    );
  end else begin : gen_none
    logic unused;
    assign unused  = &{clk_i, rst_ni, tick_i, sample_taken_i, sample_i,
                       by_axis_i, axis_i, position_i};
    assign clock_o = 1'b0;
    assign sync_o = 1'b0;
    assign data_o = '0;
  end

endmodule
`default_nettype wire
