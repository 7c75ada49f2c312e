// SPDX-License-Identifier: Apache-2.0
// The engine's large memory, limb by limb: queues of words and stop branches.
//
//   clock       0       1       2
//   address_i   1       1               limbs of the address, low one first
//   write_i                     1       at the address, which goes on by one
//   read_i                      1       the same
//   limb_o                              1       what was read, a clock behind
`default_nettype none
module engine_store #(
    parameter int Limbs = 26112,  // [16, 262144], with Form 2 65536 at most
    parameter int Form  = 0       // 2: SPRAM of UP5K
) (
    input wire logic clk_i,

    input wire logic        address_i,
    input wire logic        high_i,     // data_i is the address' second limb
    input wire logic        write_i,
    input wire logic [15:0] data_i,

    input  wire logic        read_i,
    output logic      [15:0] limb_o
);

  localparam int PlaceBits = $clog2(Limbs);

  logic [17:0] address_q;
  always_ff @(posedge clk_i) begin
    if (address_i) begin
      if (high_i) address_q[17:15] <= data_i[2:0];
      else address_q <= {3'd0, data_i[14:0]};
    end else if (write_i || read_i) begin
      address_q <= address_q + 1'b1;
    end
  end

  single_port_memory #(
      .Bits (16),
      .Words(Limbs),
      .Form (Form)
  ) u_memory (
      .clk_i,
      .write_i,
      .place_i(address_q[PlaceBits-1:0]),
      .word_i (data_i),
      .word_o (limb_o)
  );

  logic unused_address;
  assign unused_address = &{1'b0, address_q};

endmodule
`default_nettype wire
