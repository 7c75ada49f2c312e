// SPDX-License-Identifier: Apache-2.0
// CRC-32 of IEEE 802.3 of the bytes since a start, a bit a clock.
//
//   clock    0      1 .. 8   9
//   valid_i  byte
//   busy_o          1        0
//   crc_o                    of it too; Good behind a message and its own CRC, low byte first
`default_nettype none
module serial_crc (
    input  wire logic        clk_i,
    input  wire logic        rst_ni,
    input  wire logic        start_i,
    input  wire logic        valid_i,
    input  wire logic [ 7:0] byte_i,
    output logic             busy_o,
    output logic      [31:0] crc_o,
    output logic             good_o
);

  localparam logic [31:0] Polynomial = 32'hedb88320;
  localparam logic [31:0] Good = 32'h2144df1c;
  logic [31:0] register_q;
  logic [ 3:0] bits_q;
  assign busy_o = bits_q != '0;
  assign crc_o  = ~register_q;
  assign good_o = crc_o == Good;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) bits_q <= '0;
    else if (valid_i) bits_q <= 4'd8;
    else if (busy_o) bits_q <= bits_q - 1'b1;
    if (!rst_ni || start_i) register_q <= '1;
    else if (valid_i) register_q[7:0] <= register_q[7:0] ^ byte_i;
    else if (busy_o) register_q <= (register_q >> 1) ^ (register_q[0] ? Polynomial : '0);
  end

endmodule
`default_nettype wire
