// SPDX-License-Identifier: Apache-2.0
// rtl/queue/word_queue.sv: words come out as they went in, none lost, doubled or overtaken; offers
// stay; nothing gets stuck. Words are numbered, modulo more than the queue holds.
// control: LOSES_WORD s/assign write = .*/assign write = valid_i \&\& ready_o \&\& data_i != 4'd9;/
// control: OVERFLOWS s/assign ready_o = .*/assign ready_o = 1'b1;/
// control: DOUBLES_WORD s/if (read) read_q/if (read \&\& ready_i) read_q/
// control: NO_RESET s/valid_o <= 1'b0;//
`default_nettype none
module word_queue_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic valid_i,
    input wire logic ready_i
);

  localparam int Bits = 4;
  localparam int Depth = 4;

  logic [Bits-1:0] sent_q;
  logic [Bits-1:0] received_q;
  logic ready;
  logic valid;
  logic [Bits-1:0] data;

  word_queue #(
      .Bits (Bits),
      .Depth(Depth)
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

  logic [Bits-1:0] held;
  assign held = sent_q - received_q;

  logic hidden;  // a word is inside, but not offered
  assign hidden = rst_ni && held != '0 && !valid;

  logic started_q = 1'b0;
  logic kept_q;  // an offer that was not taken in the cycle before
  logic [1:0] hidden_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    kept_q    <= rst_ni && valid && !ready_i;
    hidden_q  <= {hidden_q[0], hidden};
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
      HoldsWhatFits : assert (held <= 4'(Depth + 2));
      TakesWhatFits : assert (ready || held >= 4'(Depth));
      if (valid) InOrder : assert (data == received_q);
      if (valid) NothingInvented : assert (held != '0);
      if (kept_q) KeepsOffer : assert (valid);
      if (hidden_q == '1) NeverStuck : assert (valid);

      Fills : cover (held == 4'(Depth + 2) && !ready);
      Streams : cover (received_q == 4'd12 && valid && ready && valid_i && ready_i);
    end
  end

endmodule
`default_nettype wire
