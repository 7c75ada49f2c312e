// SPDX-License-Identifier: Apache-2.0
// CRC-32 of IEEE 802.3 over the bytes since a start, a bit a clock.
//
//   clock    0      1 .. 8   9
//   valid_i  byte
//   busy_o          1        0
//   crc_o                    low byte of it; with drain_i instead of a byte: the next one
//   good_o                   behind a message and its own CRC, low byte first
`default_nettype none
module serial_crc (
    input  wire logic       clk_i,
    input  wire logic       rst_ni,
    input  wire logic       start_i,
    input  wire logic       valid_i,
    input  wire logic       drain_i,
    input  wire logic [7:0] byte_i,
    output logic            busy_o,
    output logic      [7:0] crc_o,
    output logic            good_o
);

  localparam logic [31:0] Polynomial = 32'hedb88320;
  localparam logic [31:0] Good = 32'hdebb20e3;
  logic [31:0] register_q;
  logic [7:0] byte_q;
  logic [3:0] bits_q;
  logic drains_q;
  logic feedback;
  assign busy_o   = bits_q != '0;
  assign feedback = !drains_q && (register_q[0] ^ byte_q[0]);
  assign crc_o    = ~register_q[7:0];
  assign good_o   = register_q == Good;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) bits_q <= '0;
    else if (valid_i || drain_i) bits_q <= 4'd8;
    else if (busy_o) bits_q <= bits_q - 1'b1;
    if (!busy_o) drains_q <= drain_i;
    byte_q <= valid_i ? byte_i : byte_q >> 1;
    if (!rst_ni || start_i) register_q <= '1;
    else if (busy_o) register_q <= (register_q >> 1) ^ (feedback ? Polynomial : '0);
  end

endmodule
`default_nettype wire
