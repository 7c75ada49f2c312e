// SPDX-License-Identifier: Apache-2.0
// The number of words that a queue of the motion still takes.
`default_nettype none
module queue_room #(
    parameter int Words = 1024  // [16, 65536]
) (
    input  wire logic        clk_i,
    input  wire logic        rst_ni,
    input  wire logic        put_i,
    input  wire logic        leave_i,
    output logic      [15:0] room_o
);

  localparam int First = (Words < 65536) ? Words : 65535;
  localparam int Bits = $clog2(First + 1);
  logic [Bits-1:0] room_q;
  assign room_o = 16'(room_q);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) room_q <= Bits'(First);
    else if (put_i != leave_i) room_q <= room_q + {{(Bits - 1) {put_i}}, 1'b1};
  end

endmodule
`default_nettype wire
