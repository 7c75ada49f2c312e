// SPDX-License-Identifier: Apache-2.0
// rtl/queue/frame_room.sv beside the queue that it watches: it is full exactly when fewer words
// than a frame's would fit, counted from the words that entered and left; and the queue never holds
// more than the counted room, but does hold as many.
// control: EARLY s/words_q > CountBits/words_q >= CountBits/
// control: FORGETS_OUTPUT s/Most = Depth + 2 - Frame/Most = Depth - Frame/
// control: BOTH_AT_ONCE s/if (put_i != take_i)/if (put_i || take_i)/
// control: NARROW s/\$clog2(Depth + 3)/$clog2(Depth)/
// control: NO_RESET s/words_q <= '0;/words_q <= words_q;/
`default_nettype none
module frame_room_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic put_i,
    input wire logic take_i
);

  localparam int Depth = 4;
  localparam int Frame = 3;
  localparam logic [5:0] Room = 6'd6;  // includes the queue's output registers

  logic ready;
  logic valid;
  logic data;
  word_queue #(
      .Bits (1),
      .Depth(Depth)
  ) u_queue (
      .clk_i,
      .rst_ni,
      .valid_i(put_i),
      .ready_o(ready),
      .data_i (1'b0),
      .valid_o(valid),
      .ready_i(take_i),
      .data_o (data)
  );
  logic full;
  frame_room #(
      .Depth(Depth),
      .Frame(Frame)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .put_i (put_i && ready),
      .take_i(valid && take_i),
      .full_o(full)
  );
  logic unused;
  assign unused = data;

  logic started_q = 1'b0;
  logic [5:0] words_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!rst_ni) words_q <= '0;
    else words_q <= words_q + {5'b0, put_i && ready} - {5'b0, valid && take_i};
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      Full : assert (full == (words_q + 6'(Frame) > Room));
      Fits : assert (words_q <= Room);

      AllRoom : cover (words_q == Room);
      Empties : cover (words_q == 6'd0 && !full);
    end
  end

endmodule
`default_nettype wire
