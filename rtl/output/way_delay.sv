// SPDX-License-Identifier: Apache-2.0
// Ways of the samples, as many samples later as the tool is behind the path with a shaper. Twin:
// WayDelay of hls/path_outputs.hpp.
//
//   clock      0      1      2      3      4
//   drawn_i    1
//   moves_i                  1: way_i is of the sample that is drawn; 0: there is none, way 0
//   moves_o                                1: way_o is of delay samples before, and stays
//
// delay_i is written while off_i and counts until that rises again, as the words of
// rtl/pulse/input_shaper.sv. What was before a flush is 0.
`default_nettype none
module way_delay #(
    parameter int Places = 64  // [64, 512], a power of two: ways that are kept
) (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic flush_i,

    input wire logic       off_i,
    input wire logic       write_i,
    input wire logic [8:0] delay_i,  // samples, below Places

    input  wire logic        drawn_i,
    input  wire logic        moves_i,
    input  wire logic [31:0] way_i,
    output logic             moves_o,
    output logic      [31:0] way_o,
    output logic             settled_o  // no way is to come
);

  initial
    if (Places < 64 || Places > 512 || 2 ** $clog2(Places) != Places)
      $fatal(1, "Places must be a power of two in [64, 512]");
  localparam int Address = $clog2(Places);

  logic unused;
  assign unused = &{1'b0, delay_i};
  logic [Address-1:0] delay_q;
  logic off_q;
  always_ff @(posedge clk_i) begin
    off_q <= off_i;
    if (!rst_ni || (off_i && !off_q)) delay_q <= '0;
    else if (write_i) delay_q <= delay_i[Address-1:0];
  end

  logic [31:0] ways[Places];
  logic [31:0] read_q;
  logic [Address-1:0] now_q;
  logic [Address-1:0] known_q;  // ways that are kept since the flush
  logic [Address-1:0] still_q;  // ways of 0 behind the last one
  logic unknown_q;
  logic [3:0] drawn_q;
  assign moves_o = drawn_q[3];
  assign way_o = unknown_q ? '0 : read_q;
  assign settled_o = still_q >= delay_q;
  always_ff @(posedge clk_i) begin
    if (drawn_q[1]) ways[now_q] <= moves_i ? way_i : '0;
    if (drawn_q[2]) read_q <= ways[now_q-delay_q];
    if (!rst_ni || flush_i) begin
      drawn_q <= '0;
      known_q <= '0;
      still_q <= '1;
    end else begin
      drawn_q <= {drawn_q[2:0], drawn_i};
      if (drawn_q[1]) begin
        if (moves_i && way_i != '0) still_q <= '0;
        else if (still_q != '1) still_q <= still_q + 1'b1;
      end
      if (drawn_q[2] && known_q != '1) known_q <= known_q + 1'b1;
    end
    if (!rst_ni) begin
      now_q     <= '0;
      unknown_q <= 1'b1;
    end else if (drawn_q[2] && !flush_i) begin
      now_q     <= now_q + 1'b1;
      unknown_q <= delay_q > known_q;
    end
  end

endmodule
`default_nettype wire
