// SPDX-License-Identifier: Apache-2.0
// A program word (program_word.hpp has its fields) as operations of the folded datapath: one, or
// with Splines the order's number for a sum of products, j = 0 .. i-1.
//
//   cycle      0                              1
//              valid_i, word_i with i_i ..    addresses_o, target_o
//              stall_o: word_i stays
//
// A waiting word is issued nine clocks or more after the last marked one.
`default_nettype none
module serial_issue #(
    parameter int Splines = 1  // 0, 1
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic        valid_i,
    input  wire logic [60:0] word_i,
    input  wire logic [ 3:0] i_i,
    input  wire logic [ 1:0] context_i,
    input  wire logic        land_i,
    output logic             stall_o,
    output logic             first_result_o, // a sample's first

    output logic [7+Splines:0] a_address_o,
    output logic [7+Splines:0] b_address_o,
    output logic [7+Splines:0] c_address_o,
    output logic [7+Splines:0] d_address_o,  // target 2: {land, 000, axis} in the low bits
    output logic [        2:0] scale_o,
    output logic               first_o,
    output logic               more_o,
    output logic [        1:0] target_o
);

  localparam int AddressBits = 8 + Splines;

  logic [1:0] target;
  logic [3:0] j;
  logic       more;
  assign target         = word_i[49:48];
  assign first_result_o = valid_i && target == 2'd2 && word_i[39:36] == 4'd0;

  if (Splines == 0) begin : g_once
    logic unused_flags;
    assign unused_flags = ^{rst_ni, word_i[60:57]};
    assign stall_o      = 1'b0;
    assign j            = 4'd0;
    assign more         = 1'b0;
  end else begin : g_sums
    logic       waiting;
    logic       again;
    logic [3:0] wait_q;
    logic [3:0] j_q;
    assign waiting = valid_i && word_i[60] && wait_q != 4'd0;
    assign again   = valid_i && word_i[58] && !waiting && j_q + 4'd1 != i_i;
    assign stall_o = waiting || again;
    assign j       = j_q;
    assign more    = valid_i && !waiting && (word_i[57] || again);
    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        wait_q <= 4'd0;
        j_q    <= 4'd0;
      end else begin
        if (wait_q != 4'd0) wait_q <= wait_q - 4'd1;
        if (valid_i && word_i[59] && !stall_o) wait_q <= 4'd8;
        j_q <= again ? j_q + 4'd1 : 4'd0;
      end
    end
  end

  logic [3:0] rest;
  assign rest = i_i - j;
  function automatic logic [AddressBits-1:0] address(
      input logic [11:0] field, input logic [3:0] order, input logic [3:0] inner,
      input logic [3:0] difference, input logic [1:0] turn);
    logic [3:0] index;
    index = 4'd0;
    case (field[10:9])
      2'd1: index = order;
      2'd2: if (Splines != 0) index = inner;
      2'd3: if (Splines != 0) index = difference;
      default: index = 4'd0;
    endcase
    address      = field[AddressBits-1:0];
    address[3:0] = field[3:0] + index;
    if (field[11]) address[7:4] = 4'd13 + {2'b00, turn};
  endfunction
  always_ff @(posedge clk_i) begin
    a_address_o <= address(word_i[11:0], i_i, j, rest, context_i);
    b_address_o <= address(word_i[23:12], i_i, j, rest, context_i);
    c_address_o <= address(word_i[35:24], i_i, j, rest, context_i);
    d_address_o <= address(word_i[47:36], i_i, j, rest, context_i);
    if (target == 2'd2) d_address_o[7] <= land_i;
    scale_o  <= word_i[52:50];
    first_o  <= word_i[53];
    more_o   <= more;
    target_o <= (valid_i && !stall_o) ? target : 2'd0;
  end

endmodule
`default_nettype wire
