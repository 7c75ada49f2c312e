// SPDX-License-Identifier: Apache-2.0
// rtl/queue/skid_buffer.sv: words come out as they went in, none lost, doubled or overtaken, and
// the handshake keeps its promises.  Words are numbered; the buffer cannot know.
// control: LOSES_WORD s/full_q <= valid_o .*;/full_q <= 1'b0;/
// control: DOUBLES_WORD s/full_q <= valid_o .*;/full_q <= valid_o;/
// control: NO_RESET s/if (!rst_ni)/if (1'b0)/
`default_nettype none
module skid_buffer_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic valid_i,
    input wire logic ready_i
);

  localparam int Bits = 4;

  logic [Bits-1:0] sent_q;
  logic [Bits-1:0] received_q;
  logic ready;
  logic valid;
  logic [Bits-1:0] data;

  skid_buffer #(
      .Bits(Bits)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .valid_i,
      .ready_o(ready),
      .data_i (sent_q),
      .valid_o(valid),
      .ready_i,
      .data_o (data)
  );

  logic started_q = 1'b0;
  logic kept_valid_q;  // an offer that was not taken in the cycle before
  logic kept_input_q;
  logic blocked_q;
  always_ff @(posedge clk_i) begin
    started_q    <= 1'b1;
    kept_valid_q <= rst_ni && valid && !ready_i;
    kept_input_q <= rst_ni && valid_i && !ready;
    blocked_q    <= rst_ni && ready_i;
    if (!rst_ni) begin
      sent_q     <= '0;
      received_q <= '0;
    end else begin
      if (valid_i && ready) sent_q <= sent_q + 1'b1;
      if (valid && ready_i) received_q <= received_q + 1'b1;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (kept_input_q) assume (valid_i);

      if (valid) InOrder : assert (data == received_q);
      if (kept_valid_q) KeepsOffer : assert (valid);
      if (blocked_q) NeverBlocksForTwo : assert (ready);

      SetsAside : cover (!ready && valid_i);
      Streams : cover (received_q == 4'd3 && ready && valid);
    end
  end

endmodule
`default_nettype wire
