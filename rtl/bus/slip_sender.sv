// SPDX-License-Identifier: Apache-2.0
// A frame as rtl/bus/slip_receiver.sv takes it. After the frame's last byte close_i asks for CRC
// and END; ready_o answers either.
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

  // Of a frame: its bytes, CRC bytes 1 to 4, END
  localparam logic [2:0] Open = 3'd0;
  localparam logic [2:0] LastCrc = 3'd4;
  localparam logic [2:0] Close = 3'd5;
  logic [2:0] part_q;
  logic [7:0] held_q;  // goes out next, if waits_q
  logic waits_q;
  logic escaped_q;  // its escape is out
  logic must_escape;
  logic leaves;  // all of it
  assign must_escape = part_q != Close && (held_q == slip_pkg::End || held_q == slip_pkg::Escape);
  assign byte_valid_o = waits_q;
  assign leaves = waits_q && byte_ready_i && (!must_escape || escaped_q);
  always_comb begin
    byte_o = held_q;
    if (must_escape && !escaped_q) byte_o = slip_pkg::Escape;
    else if (must_escape) begin
      byte_o = (held_q == slip_pkg::End) ? slip_pkg::EscapedEnd : slip_pkg::EscapedEscape;
    end
  end

  logic busy;
  logic [31:0] crc;
  logic [7:0] crc_part;
  logic unused_good;
  assign ready_o = part_q == Open && !waits_q && !busy;
  always_comb begin
    case (part_q)
      Open:    crc_part = crc[7:0];
      3'd1:    crc_part = crc[15:8];
      3'd2:    crc_part = crc[23:16];
      default: crc_part = crc[31:24];
    endcase
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      part_q    <= Open;
      waits_q   <= 1'b0;
      escaped_q <= 1'b0;
    end else if (ready_o && close_i) begin
      part_q  <= 3'd1;
      waits_q <= 1'b1;
    end else if (ready_o && data_valid_i) begin
      waits_q <= 1'b1;
    end else if (leaves) begin
      escaped_q <= 1'b0;
      waits_q   <= part_q != Open && part_q != Close;
      if (part_q == Close) part_q <= Open;
      else if (part_q != Open) part_q <= part_q + 1'b1;
    end else if (waits_q && byte_ready_i) begin
      escaped_q <= 1'b1;
    end
    if (ready_o && !close_i) held_q <= data_i;
    else if (part_q == LastCrc) begin
      if (leaves) held_q <= slip_pkg::End;
    end else if (ready_o || leaves) held_q <= crc_part;
  end

  serial_crc u_crc (
      .clk_i,
      .rst_ni,
      .start_i(leaves && part_q == Close),
      .valid_i(ready_o && data_valid_i && !close_i),
      .byte_i (data_i),
      .busy_o (busy),
      .crc_o  (crc),
      .good_o (unused_good)
  );

endmodule
`default_nettype wire
