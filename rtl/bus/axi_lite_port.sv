// SPDX-License-Identifier: Apache-2.0
// AXI4-Lite port of the registers. One access at a time; if a write and a read wait, the one that
// did not go last goes. Registers are whole words: a write with strobes missing is an error, and so
// is an access that the registers refuse (SLVERR).
//
//   clock               0     1     2     3     4
//   awvalid_i, wvalid_i 1     1     1     1
//   valid_o                   1     1     1
//   done_i                                1
//   awready_o, wready_o                   1
//   bvalid_o                                    1     until bready_i
//
// Reads alike, with arvalid_i, arready_o and rvalid_o.
`default_nettype none
module axi_lite_port (
    input wire logic clk_i,
    input wire logic rst_ni,

    // AXI4-Lite; the low two bits of addresses are ignored
    input  wire logic        awvalid_i,
    output logic             awready_o,
    input  wire logic [ 8:0] awaddr_i,
    input  wire logic        wvalid_i,
    output logic             wready_o,
    input  wire logic [31:0] wdata_i,
    input  wire logic [ 3:0] wstrb_i,
    output logic             bvalid_o,
    input  wire logic        bready_i,
    output logic      [ 1:0] bresp_o,
    input  wire logic        arvalid_i,
    output logic             arready_o,
    input  wire logic [ 8:0] araddr_i,
    output logic             rvalid_o,
    input  wire logic        rready_i,
    output logic      [31:0] rdata_o,
    output logic      [ 1:0] rresp_o,

    // Requests: rtl/bus/register_file.sv
    output logic             valid_o,
    output logic             write_o,
    output logic      [ 6:0] word_o,
    output logic      [31:0] data_o,
    input  wire logic        done_i,
    input  wire logic        error_i,
    input  wire logic [31:0] data_i
);

  logic busy_q;
  logic write_q;  // the present access, or the one before
  logic part_q;  // write of a part of a word
  logic writes;
  logic starts;
  logic ends;
  assign writes = awvalid_i && wvalid_i && !(arvalid_i && write_q);
  assign starts = !busy_q && !bvalid_o && !rvalid_o && (writes || arvalid_i);
  assign ends   = busy_q && (done_i || part_q);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      busy_q   <= 1'b0;
      write_q  <= 1'b0;
      part_q   <= 1'b0;
      bvalid_o <= 1'b0;
      rvalid_o <= 1'b0;
    end else begin
      if (starts) begin
        busy_q  <= 1'b1;
        write_q <= writes;
        part_q  <= writes && wstrb_i != 4'b1111;
      end else if (ends) begin
        busy_q <= 1'b0;
      end
      if (ends && write_q) bvalid_o <= 1'b1;
      else if (bready_i) bvalid_o <= 1'b0;
      if (ends && !write_q) rvalid_o <= 1'b1;
      else if (rready_i) rvalid_o <= 1'b0;
    end
  end

  assign valid_o   = busy_q && !part_q;
  assign write_o   = write_q;
  assign word_o    = write_q ? awaddr_i[8:2] : araddr_i[8:2];
  assign data_o    = wdata_i;
  assign awready_o = ends && write_q;
  assign wready_o  = ends && write_q;
  assign arready_o = ends && !write_q;
  assign bresp_o   = {error_i || part_q, 1'b0};
  assign rresp_o   = {error_i, 1'b0};
  assign rdata_o   = data_i;

endmodule
`default_nettype wire
