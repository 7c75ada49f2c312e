// SPDX-License-Identifier: Apache-2.0
// A buffer of whole frames: a frame can be read when it has ended and is good, and is discarded
// otherwise. A frame has at most 2^8 - 1 bytes with its CRC; a longer one, or one without room, is
// not good. The output is its number of bytes, then the bytes.
//
//   clock        0     1     2
//   next_i       1
//   read_valid_o 1     0     0     the next byte, two clocks later at best
`default_nettype none
module frame_buffer (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Input: rtl/line/slip_receiver.sv
    input wire logic       data_valid_i,
    input wire logic [7:0] data_i,
    input wire logic       end_valid_i,
    input wire logic       good_i,

    // Output
    output logic            read_valid_o,
    output logic      [7:0] read_o,
    input  wire logic       next_i
);

  localparam int Log2 = 9;

  // A ring of frames, each behind its number of bytes
  logic [Log2-1:0] first_q;  // place for the number of bytes of the arriving frame
  logic [Log2-1:0] next_q;  // place for its next byte; in the clock behind an end one less
  logic [Log2-1:0] behind;
  logic [Log2-1:0] read_q;
  logic [7:0] bytes_q;
  logic ended_q;
  logic lost_q;
  logic full;
  logic kept;
  logic write;
  logic [Log2-1:0] write_at;
  logic [7:0] write_data;
  assign behind     = next_q + 1'b1;
  assign full       = bytes_q == '1 || behind == read_q || next_q == read_q;
  assign kept       = end_valid_i && good_i && !lost_q;
  assign write      = (data_valid_i && !full) || kept;
  assign write_at   = end_valid_i ? first_q : next_q;
  assign write_data = end_valid_i ? bytes_q : data_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      first_q <= '0;
      next_q  <= '0;
      ended_q <= 1'b1;
    end else begin
      ended_q <= end_valid_i;
      if (end_valid_i && !kept) next_q <= first_q;
      else if (ended_q || (data_valid_i && !full)) next_q <= behind;
      if (kept) first_q <= next_q;
    end
    if (!rst_ni || end_valid_i) begin
      bytes_q <= '0;
      lost_q  <= 1'b0;
    end else if (data_valid_i) begin
      if (full) lost_q <= 1'b1;
      else bytes_q <= bytes_q + 1'b1;
    end
  end

  (* no_rw_check *)
  logic [7:0] memory[2**Log2];
  logic [7:0] byte_q;
  logic there_q;
  logic goes_on;
  assign goes_on = read_valid_o && next_i;
  always_ff @(posedge clk_i) begin
    if (write) memory[write_at] <= write_data;
    byte_q <= memory[read_q];
    read_o <= byte_q;  // block RAM is slow
    if (!rst_ni) begin
      read_q       <= '0;
      there_q      <= 1'b0;
      read_valid_o <= 1'b0;
    end else begin
      if (goes_on) read_q <= read_q + 1'b1;
      there_q      <= read_q != first_q && !goes_on;
      read_valid_o <= there_q && !goes_on;
    end
  end

endmodule
`default_nettype wire
