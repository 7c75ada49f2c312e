// SPDX-License-Identifier: Apache-2.0
// rtl/bus/axi_lite_port.sv before registers that answer in two clocks: a write and a read that wait
// are both taken within 8 clocks in which no response waits, each has one response, which stays
// until it is taken, and is the registers'; a part of a word reaches no register.
// control: READS_STARVE s/ \&\& !(arvalid_i \&\& write_q)//
// control: FORGETS_RESPONSE s/else if (bready_i) bvalid_o/else bvalid_o/
// control: STARTS_EARLY s/!busy_q \&\& !bvalid_o \&\& !rvalid_o/!busy_q/
// control: WRITES_PARTS s/busy_q \&\& !part_q/busy_q/
// control: HANGS_ON_PARTS s/(done_i || part_q)/done_i/
// control: NO_RESET s/busy_q   <= 1'b0;//
`default_nettype none
module axi_lite_port_formal (
    input wire logic       clk_i,
    input wire logic       rst_ni,
    input wire logic       write_i,   // begins to ask
    input wire logic       read_i,
    input wire logic [3:0] wstrb_i,
    input wire logic       bready_i,
    input wire logic       rready_i,
    input wire logic       error_i
);

  // A master whose requests stay.
  logic aw_q;
  logic w_q;
  logic ar_q;
  logic [3:0] wstrb_q;
  logic awready;
  logic wready;
  logic arready;
  logic bvalid;
  logic rvalid;
  logic [1:0] bresp;
  logic [1:0] rresp;
  logic valid;
  logic write;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      aw_q <= 1'b0;
      w_q  <= 1'b0;
      ar_q <= 1'b0;
    end else begin
      aw_q <= aw_q ? !awready : write_i;
      w_q  <= w_q ? !wready : aw_q && !awready;
      ar_q <= ar_q ? !arready : read_i;
    end
    if (!w_q) wstrb_q <= wstrb_i;
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

  axi_lite_port u_dut (
      .clk_i,
      .rst_ni,
      .awvalid_i(aw_q),
      .awready_o(awready),
      .awaddr_i(9'd0),
      .wvalid_i(w_q),
      .wready_o(wready),
      .wdata_i(32'd0),
      .wstrb_i(wstrb_q),
      .bvalid_o(bvalid),
      .bready_i,
      .bresp_o(bresp),
      .arvalid_i(ar_q),
      .arready_o(arready),
      .araddr_i(9'd0),
      .rvalid_o(rvalid),
      .rready_i,
      .rresp_o(rresp),
      .valid_o(valid),
      .write_o(write),
      .done_i(done_q),
      .error_i(error_q),
      .data_i(32'd0)
  );

  logic started_q = 1'b0;
  logic ran_q;
  logic [3:0] write_waits_q;  // clocks without a response that waits
  logic [3:0] read_waits_q;
  logic written_q;  // taken in the clock before
  logic read_q;
  logic part_q;  // a part: the last write
  logic bwaits_q;
  logic rwaits_q;
  logic [1:0] bresp_q;
  logic [1:0] rresp_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    ran_q     <= rst_ni;
    written_q <= rst_ni && aw_q && awready;
    read_q    <= rst_ni && ar_q && arready;
    bwaits_q  <= rst_ni && bvalid && !bready_i;
    rwaits_q  <= rst_ni && rvalid && !rready_i;
    bresp_q   <= bresp;
    rresp_q   <= rresp;
    if (aw_q && awready) part_q <= wstrb_q != 4'b1111;
    if (!rst_ni || !(aw_q && w_q) || awready) write_waits_q <= '0;
    else if (!bvalid && !rvalid) write_waits_q <= write_waits_q + 1'b1;
    if (!rst_ni || !ar_q || arready) read_waits_q <= '0;
    else if (!bvalid && !rvalid) read_waits_q <= read_waits_q + 1'b1;
  end

  always_comb begin
    if (!started_q) assume (!rst_ni);
    if (started_q && ran_q && rst_ni) begin
      Write_in_time : assert (write_waits_q < 4'd8);
      Read_in_time : assert (read_waits_q < 4'd8);
      Together : assert (awready == wready && (!awready || (aw_q && w_q)));
      Asked : assert (!arready || ar_q);
      Write_answered : assert (bvalid == (written_q || bwaits_q));
      Read_answered : assert (rvalid == (read_q || rwaits_q));
      Write_stays : assert (!bwaits_q || bresp == bresp_q);
      Read_stays : assert (!rwaits_q || rresp == rresp_q);
      Error_told : assert (!written_q || bresp[1] == (part_q || error_q));
      Whole_words : assert (!(valid && write) || wstrb_q == 4'b1111);
      Error : cover (rvalid && rresp[1]);
      Part_beside_read : cover (written_q && part_q && ar_q);
    end
  end

endmodule
`default_nettype wire
