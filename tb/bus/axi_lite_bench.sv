// SPDX-License-Identifier: Apache-2.0
// Registers behind AXI4-Lite, with the signal names that cocotbext-axi looks for.
`default_nettype none
module axi_lite_bench (
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
    output logic      [ 1:0] s_axi_rresp
);

  logic valid;
  logic write;
  logic [6:0] word;
  logic [31:0] data;
  logic done;
  logic error;
  logic [31:0] answer;
  axi_lite_port u_port (
      .clk_i(clk),
      .rst_ni(rst_n),
      .awvalid_i(s_axi_awvalid),
      .awready_o(s_axi_awready),
      .awaddr_i(s_axi_awaddr),
      .wvalid_i(s_axi_wvalid),
      .wready_o(s_axi_wready),
      .wdata_i(s_axi_wdata),
      .wstrb_i(s_axi_wstrb),
      .bvalid_o(s_axi_bvalid),
      .bready_i(s_axi_bready),
      .bresp_o(s_axi_bresp),
      .arvalid_i(s_axi_arvalid),
      .arready_o(s_axi_arready),
      .araddr_i(s_axi_araddr),
      .rvalid_o(s_axi_rvalid),
      .rready_i(s_axi_rready),
      .rdata_o(s_axi_rdata),
      .rresp_o(s_axi_rresp),
      .valid_o(valid),
      .write_o(write),
      .word_o(word),
      .data_o(data),
      .done_i(done),
      .error_i(error),
      .data_i(answer)
  );
  bench_registers u_registers (
      .clk_i  (clk),
      .rst_ni (rst_n),
      .valid_i(valid),
      .write_i(write),
      .word_i (word),
      .data_i (data),
      .done_o (done),
      .error_o(error),
      .data_o (answer)
  );

endmodule
`default_nettype wire
