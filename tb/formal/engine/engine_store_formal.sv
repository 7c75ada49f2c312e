// SPDX-License-Identifier: Apache-2.0
// rtl/engine/engine_store.sv: a limb is read as it was written last, wherever that was, while the
// address goes on with each limb. One place, any, is followed; the address' limbs come in any order
// with reads and writes.
// control: STAYS s/write_i || read_i/write_i/
// control: HIGH_LOST s/if (high_i) address_q\[17:15\] <= data_i\[2:0\];/if (high_i) ;/
// control: LOW_KEEPS_HIGH s/address_q <= {3'd0, data_i\[14:0\]}/address_q[14:0] <= data_i[14:0]/
// control: WRITES_BESIDE s/\(address_q\[PlaceBits-1:0\]\)),/\1 ^ PlaceBits'(write_i)),/
// control: WRITES_READS s/\.write_i,/.write_i(write_i || read_i),/
`default_nettype none
module engine_store_formal (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        address_i,
    input wire logic        high_i,
    input wire logic        write_i,
    input wire logic        read_i,
    input wire logic [15:0] data_i
);

  localparam int Limbs = 16;

  logic [15:0] limb;
  engine_store #(
      .Limbs(Limbs)
  ) u_dut (
      .clk_i,
      .address_i,
      .high_i,
      .write_i,
      .data_i,
      .read_i,
      .limb_o(limb)
  );

  (* hierconn *) logic [17:0] \u_dut.address_q ;
  (* anyconst *) logic [17:0] followed;
  logic [17:0] address_q;
  logic addressed_q;  // its low limb came, after which the high one may
  logic [15:0] value_q;  // at the place that is followed
  logic written_q;
  logic read_q;  // of it
  logic [15:0] read_value_q;
  logic started_q = 1'b0;
  logic there;
  assign there = addressed_q && address_q == followed;
  always_ff @(posedge clk_i) begin
    started_q    <= 1'b1;
    read_q       <= rst_ni && read_i && !write_i && !address_i && there && written_q;
    read_value_q <= value_q;
    if (!rst_ni) begin
      addressed_q <= 1'b0;
      written_q   <= 1'b0;
    end else begin
      if (address_i && !high_i) begin
        addressed_q <= 1'b1;
        address_q   <= {3'd0, data_i[14:0]};
      end else if (address_i) begin
        address_q <= {data_i[2:0], address_q[14:0]};
      end else if (write_i || read_i) begin
        address_q <= address_q + 18'd1;
      end
      if (write_i && there) begin
        written_q <= 1'b1;
        value_q   <= data_i;
      end
    end
  end

  always_comb begin
    assume (followed < 18'(Limbs));
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      // Ports are told one thing a clock, of places that there are.
      assume (!(address_i && (write_i || read_i)) && !(write_i && read_i));
      if (write_i || read_i) assume (addressed_q && address_q < 18'(Limbs));

      if (addressed_q) Goes : assert (\u_dut.address_q == address_q);
      if (read_q) LastWritten : assert (limb == read_value_q);

      ReadsLater : cover (read_q && limb == 16'h1234 && address_q == 18'd5 && !there);
    end
  end

endmodule
`default_nettype wire
