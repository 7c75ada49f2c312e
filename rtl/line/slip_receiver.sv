// SPDX-License-Identifier: Apache-2.0
// Frames from a stream of bytes: SLIP (RFC 1055) around a frame and its CRC-32, low byte first.
//
//   byte_i        END  a  b  c  d  crc0 .. crc3  END
//   data_valid_o       a  b  c  d  crc0 .. crc3
//   end_valid_o                                  1    good_o: all of it arrived, unbroken
//
// A byte takes 9 clocks at most, an END 2. A frame without a byte is not good.
`default_nettype none
module slip_receiver (
    input  wire logic       clk_i,
    input  wire logic       rst_ni,
    input  wire logic       byte_valid_i,
    output logic            byte_ready_o,
    input  wire logic [7:0] byte_i,
    output logic            data_valid_o,
    output logic      [7:0] data_o,
    output logic            end_valid_o,
    output logic            good_o
);

  logic taken;
  logic ends;
  logic escapes;
  logic busy;
  logic ended_q;
  logic escaped_q;
  logic broken_q;
  logic crc_good;
  assign byte_ready_o = !busy && !ended_q;
  assign taken        = byte_valid_i && byte_ready_o;
  assign ends         = byte_i == slip_pkg::End;
  assign escapes      = byte_i == slip_pkg::Escape;
  assign end_valid_o  = taken && ends;
  assign data_valid_o = taken && !ends && !escapes;
  assign good_o       = crc_good && !broken_q && !escaped_q;
  always_comb begin
    data_o = byte_i;
    if (escaped_q) data_o = (byte_i == slip_pkg::EscapedEnd) ? slip_pkg::End : slip_pkg::Escape;
  end
  logic breaks;
  assign breaks = escaped_q && byte_i != slip_pkg::EscapedEnd && byte_i != slip_pkg::EscapedEscape;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ended_q   <= 1'b1;
      escaped_q <= 1'b0;
      broken_q  <= 1'b0;
    end else begin
      ended_q <= end_valid_o;
    end
    if (rst_ni && taken) begin
      escaped_q <= escapes;
      broken_q  <= !ends && (broken_q || breaks);
    end
  end

  logic [7:0] unused_crc;
  serial_crc u_crc (
      .clk_i,
      .rst_ni,
      .start_i(end_valid_o),
      .valid_i(data_valid_o),
      .drain_i(1'b0),
      .byte_i (data_o),
      .busy_o (busy),
      .crc_o  (unused_crc),
      .good_o (crc_good)
  );

endmodule
`default_nettype wire
