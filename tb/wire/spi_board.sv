// SPDX-License-Identifier: Apache-2.0
// The virtual board's RTL (sysc/virtual/virtual_board.cpp) behind SPI's pins.
`default_nettype none
module spi_board #(
    parameter int PeriodLog2 = 13,
    parameter     Program    = "",
    parameter     Data       = ""
) (
    input  wire logic       clk_i,
    input  wire logic       rst_ni,
    input  wire logic       cs_ni,
    input  wire logic       sclk_i,
    input  wire logic       mosi_i,
    output logic            miso_o,
    output logic      [2:0] step_o,
    output logic      [2:0] direction_o
);

  logic in_valid;
  logic [7:0] in;
  logic out_valid;
  logic out_ready;
  logic [7:0] out;
  spi_line u_line (
      .clk_i,
      .rst_ni,
      .cs_ni,
      .sclk_i,
      .mosi_i,
      .miso_o,
      .byte_valid_o(in_valid),
      .byte_o      (in),
      .byte_valid_i(out_valid),
      .byte_ready_o(out_ready),
      .byte_i      (out)
  );
  motion_board #(
      .ClockHertz       (5_120_000),
      .PeriodLog2       (PeriodLog2),
      .SegmentQueueWords(4096),
      .Program          (Program),
      .Data             (Data)
  ) u_board (
      .clk_i,
      .rst_ni,
      .byte_valid_i (in_valid),
      .byte_ready_o (),
      .byte_i       (in),
      .byte_valid_o (out_valid),
      .byte_ready_i (out_ready),
      .byte_o       (out),
      .estop_i      (1'b0),
      .limit_i      (3'd0),
      .probe_i      (1'b0),
      .home_i       (3'd0),
      .encoder_a_i  (3'd0),
      .encoder_b_i  (3'd0),
      .step_o,
      .direction_o,
      .enable_o     (),
      .output_o     (),
      .pwm_o        (),
      .galvo_clock_o(),
      .galvo_sync_o (),
      .galvo_data_o ()
  );

endmodule
`default_nettype wire
