// SPDX-License-Identifier: Apache-2.0
// Sender of frames for rtl/line/slip_receiver.sv. close_i after the frame's last byte requests CRC
// and END; ready_o answers both.
`default_nettype none
module slip_sender (
    input  wire logic       clk_i,
    input  wire logic       rst_ni,
    input  wire logic       data_valid_i,
    input  wire logic [7:0] data_i,
    input  wire logic       close_i,
    output logic            ready_o,
    output logic            byte_valid_o,
    input  wire logic       byte_ready_i,
    output logic      [7:0] byte_o
);

  // Parts of a frame: its bytes, CRC bytes 1 to 4, END
  localparam logic [2:0] Open = 3'd0;
  localparam logic [2:0] LastCrc = 3'd4;
  localparam logic [2:0] Close = 3'd5;
  logic [2:0] part_q;
  logic [7:0] held_q;  // goes out next, if waits_q
  logic waits_q;
  logic escaped_q;  // its escape is out
  logic is_end;
  logic escapes;
  logic leaves;  // the whole byte leaves
  assign is_end       = held_q == slip_pkg::End;
  assign escapes      = part_q != Close && !escaped_q && (is_end || held_q == slip_pkg::Escape);
  assign byte_valid_o = waits_q;
  assign byte_o       = escapes ? slip_pkg::Escape : held_q;
  assign leaves       = waits_q && byte_ready_i && !escapes;

  logic busy;
  logic [7:0] crc;
  logic unused_good;
  logic takes;
  logic goes_on;  // the next part begins
  assign ready_o = part_q == Open && !waits_q && !busy;
  assign takes   = ready_o && data_valid_i && !close_i;
  assign goes_on = !waits_q && !busy && (part_q != Open || close_i);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      part_q  <= Open;
      waits_q <= 1'b0;
    end else if (leaves) begin
      waits_q <= 1'b0;
      if (part_q == Close) part_q <= Open;
    end else if (takes || goes_on) begin
      waits_q <= 1'b1;
      if (goes_on) part_q <= part_q + 1'b1;
    end
    if (!waits_q) escaped_q <= 1'b0;
    else if (byte_ready_i) escaped_q <= escapes;
    if (takes) held_q <= data_i;
    else if (!waits_q) held_q <= (part_q == LastCrc) ? slip_pkg::End : crc;
    else if (byte_ready_i && escapes) begin
      held_q <= is_end ? slip_pkg::EscapedEnd : slip_pkg::EscapedEscape;
    end
  end

  serial_crc u_crc (
      .clk_i,
      .rst_ni,
      .start_i(leaves && part_q == Close),
      .valid_i(takes),
      .drain_i(leaves && part_q != Open && part_q != Close),
      .byte_i (data_i),
      .busy_o (busy),
      .crc_o  (crc),
      .good_o (unused_good)
  );

endmodule
`default_nettype wire
