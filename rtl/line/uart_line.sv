// SPDX-License-Identifier: Apache-2.0
// Bytes on two pins: 8 data bits, no parity, one stop bit, BitClocks clocks a bit. A byte without
// its stop bit is dropped. Received bytes must be taken at once.
`default_nettype none
module uart_line #(
    parameter int BitClocks = 217  // [4, 65535]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Pins
    input  wire logic rx_i,
    output logic      tx_o,

    // Bytes
    output logic            byte_valid_o,
    output logic      [7:0] byte_o,
    input  wire logic       byte_valid_i,
    output logic            byte_ready_o,
    input  wire logic [7:0] byte_i
);

  initial begin
    if (BitClocks < 4 || BitClocks > 65535) $fatal(1, "BitClocks must be in [4, 65535]");
  end

  localparam int WaitBits = $clog2(BitClocks);
  localparam logic [WaitBits-1:0] Bit = WaitBits'(BitClocks - 1);
  localparam logic [WaitBits-1:0] Half = WaitBits'(BitClocks / 2 - 1);

  // Input: start, 8 bits, stop, each sampled in its middle
  logic rx;
  synchroniser u_synchroniser (
      .clk_i,
      .rst_ni,
      .input_i (rx_i),
      .output_o(rx)
  );
  logic [WaitBits-1:0] in_wait_q;
  logic [3:0] in_left_q;  // bits to come, 0: idle
  logic [7:0] in_q;
  logic looks;
  assign looks = in_wait_q == '0;
  always_ff @(posedge clk_i) begin
    byte_valid_o <= rst_ni && in_left_q == 4'd1 && looks && rx;
    if (!rst_ni) begin
      in_left_q <= '0;
    end else if (in_left_q == '0) begin
      in_wait_q <= Half;
      if (!rx) in_left_q <= 4'd10;
    end else if (looks) begin
      in_wait_q <= Bit;
      in_left_q <= (in_left_q == 4'd10 && rx) ? '0 : in_left_q - 1'b1;  // a spike is no start
    end else begin
      in_wait_q <= in_wait_q - 1'b1;
    end
    if (looks && in_left_q > 4'd1 && in_left_q < 4'd10) in_q <= {rx, in_q[7:1]};
  end
  assign byte_o = in_q;

  // Output
  logic [WaitBits-1:0] out_wait_q;
  logic [3:0] out_left_q;
  logic [8:0] out_q;
  assign byte_ready_o = out_left_q == '0;
  assign tx_o         = out_q[0];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      out_left_q <= '0;
      out_q      <= '1;
    end else if (byte_ready_o) begin
      out_wait_q <= Bit;
      if (byte_valid_i) begin
        out_left_q <= 4'd10;
        out_q      <= {byte_i, 1'b0};
      end
    end else if (out_wait_q == '0) begin
      out_wait_q <= Bit;
      out_left_q <= out_left_q - 1'b1;
      out_q      <= {1'b1, out_q[8:1]};
    end else begin
      out_wait_q <= out_wait_q - 1'b1;
    end
  end

endmodule
`default_nettype wire
