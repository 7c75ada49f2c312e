// SPDX-License-Identifier: Apache-2.0
// rtl/queue/sample_queue.sv: every sample that the sampler has under way finds a place; samples
// come out as they went in; nothing gets stuck. Words are numbered, modulo more than the queue
// holds; a sample is one or two.
// configuration: words_1 Words=1 Block=0
// configuration: words_2 Words=2 Block=1
// control: OVERFLOWS s/(Depth - 3)/(Depth + 2)/
// control: LOSES_SAMPLE s/next_write = push_i ?/next_write = push_i \&\& data_i != 5 ?/
// control: DOUBLES_SAMPLE s/next_read  = fetch ?/next_read  = fetch \&\& ready_i ?/
// control: NO_ROOM s/room_o <= admitted_q/room_o <= \&admitted_q \&\& admitted_q/
// control: NO_RESET s/count_q      <= '0;/count_q <= count_q;/
// long: proved.words_2
`default_nettype none
module sample_queue_formal #(
    parameter int Words = 1,  // 1, 2
    parameter int Block = 1   // 0, 1
) (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic request_i,
    input wire logic push_i,
    input wire logic ready_i
);

  localparam int Bits = 2 + Words;
  localparam int Depth = 4;  // fewer than cores have

  logic [Bits-1:0] admitted_q;
  logic [Bits-1:0] pushed_q;
  logic [Bits-1:0] received_q;
  logic room;
  logic valid;
  logic [Bits-1:0] data;

  sample_queue #(
      .Bits (Bits),
      .Depth(Depth),
      .Words(Words),
      .Block(Block)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .admit_i(request_i && room),
      .room_o (room),
      .push_i,
      .data_i (pushed_q),
      .valid_o(valid),
      .ready_i,
      .data_o (data),
      .leave_i(valid && ready_i && (Words == 1 || received_q[0]))
  );

  logic [Bits-1:0] under_way;
  logic [Bits-1:0] held;
  logic [Bits-1:0] all;
  assign under_way = admitted_q - pushed_q;
  assign held      = pushed_q - received_q;
  assign all       = admitted_q - received_q;

  logic started_q = 1'b0;
  logic kept_q;  // an offer that was not taken in the cycle before
  logic [2:0] hidden_q;  // a sample is inside, but not offered
  logic [3:0] empty_q;  // nothing is admitted, nor is there room
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    kept_q    <= rst_ni && valid && !ready_i;
    hidden_q  <= {hidden_q[1:0], rst_ni && held != '0 && !valid};
    empty_q   <= {empty_q[2:0], rst_ni && all == '0 && !room};
    if (!rst_ni) begin
      admitted_q <= '0;
      pushed_q   <= '0;
      received_q <= '0;
    end else begin
      if (request_i && room) admitted_q <= admitted_q + Bits'(Words);
      if (push_i) pushed_q <= pushed_q + 1'b1;
      if (valid && ready_i) received_q <= received_q + 1'b1;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (under_way == '0) assume (!push_i);

      HoldsWhatFits : assert (held <= Bits'(Words * Depth));
      AdmitsWhatFits : assert (all <= Bits'(Words * Depth));
      if (valid) InOrder : assert (data == received_q);
      if (valid) NothingInvented : assert (held != '0);
      if (kept_q) KeepsOffer : assert (valid);
      if (hidden_q == '1) NeverStuck : assert (valid);
      if (empty_q == '1) GivesRoom : assert (room);

      Fills : cover (held >= Bits'(Words * (Depth - 1)) && !room);
      Streams : cover (received_q == Bits'(7) && valid && ready_i && push_i);
    end
  end

endmodule
`default_nettype wire
