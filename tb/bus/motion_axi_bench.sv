// SPDX-License-Identifier: Apache-2.0
// motion_axi, with the signal names that cocotbext-axi looks for.
`default_nettype none
module motion_axi_bench (
    input  wire logic        clk,
    input  wire logic        rst_n,
    input  wire logic        s_axi_awvalid,
    output logic             s_axi_awready,
    input  wire logic [ 8:0] s_axi_awaddr,
    input  wire logic [ 2:0] s_axi_awprot,
    input  wire logic        s_axi_wvalid,
    output logic             s_axi_wready,
    input  wire logic [31:0] s_axi_wdata,
    input  wire logic [ 3:0] s_axi_wstrb,
    output logic             s_axi_bvalid,
    input  wire logic        s_axi_bready,
    output logic      [ 1:0] s_axi_bresp,
    input  wire logic        s_axi_arvalid,
    output logic             s_axi_arready,
    input  wire logic [ 8:0] s_axi_araddr,
    input  wire logic [ 2:0] s_axi_arprot,
    output logic             s_axi_rvalid,
    input  wire logic        s_axi_rready,
    output logic      [31:0] s_axi_rdata,
    output logic      [ 1:0] s_axi_rresp,
    input  wire logic        segment_tvalid,
    output logic             segment_tready,
    input  wire logic [63:0] segment_tdata,
    input  wire logic        profile_tvalid,
    output logic             profile_tready,
    input  wire logic [63:0] profile_tdata,
    output logic      [ 2:0] step,
    output logic      [ 2:0] direction
);

  motion_axi #(
      .ProfileQueueWords(512),
      .PeriodLog2       (8),
      .SamplesAhead     (15)
  ) u_motion (
      .clk_i           (clk),
      .rst_ni          (rst_n),
      .awvalid_i       (s_axi_awvalid),
      .awready_o       (s_axi_awready),
      .awaddr_i        (s_axi_awaddr),
      .wvalid_i        (s_axi_wvalid),
      .wready_o        (s_axi_wready),
      .wdata_i         (s_axi_wdata),
      .wstrb_i         (s_axi_wstrb),
      .bvalid_o        (s_axi_bvalid),
      .bready_i        (s_axi_bready),
      .bresp_o         (s_axi_bresp),
      .arvalid_i       (s_axi_arvalid),
      .arready_o       (s_axi_arready),
      .araddr_i        (s_axi_araddr),
      .rvalid_o        (s_axi_rvalid),
      .rready_i        (s_axi_rready),
      .rdata_o         (s_axi_rdata),
      .rresp_o         (s_axi_rresp),
      .segment_tvalid_i(segment_tvalid),
      .segment_tready_o(segment_tready),
      .segment_tdata_i (segment_tdata),
      .profile_tvalid_i(profile_tvalid),
      .profile_tready_o(profile_tready),
      .profile_tdata_i (profile_tdata),
      .estop_i         (1'b0),
      .limit_i         (3'd0),
      .probe_i         (1'b0),
      .home_i          (3'd0),
      .step_o          (step),
      .direction_o     (direction),
      .enable_o        (),
      .galvo_clock_o   (),
      .galvo_sync_o    (),
      .galvo_data_o    ()
  );

endmodule
`default_nettype wire
