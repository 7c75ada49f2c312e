// SPDX-License-Identifier: Apache-2.0
// Wishbone B4 (classic) port of the registers. Registers are whole words: a write that does not
// select all bytes is an error, and so is an access that the registers refuse (err_o).
//
//   clock         0     1     2
//   cyc_i, stb_i  1     1     1      until ack_o or err_o
//   ack_o                     1
`default_nettype none
module wishbone_port (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Wishbone; addresses of words
    input  wire logic        cyc_i,
    input  wire logic        stb_i,
    input  wire logic        we_i,
    input  wire logic [ 6:0] adr_i,
    input  wire logic [31:0] dat_i,
    input  wire logic [ 3:0] sel_i,
    output logic             ack_o,
    output logic             err_o,
    output logic      [31:0] dat_o,

    // Requests: rtl/bus/register_file.sv
    output logic             valid_o,
    output logic             write_o,
    output logic      [ 6:0] word_o,
    output logic      [31:0] data_o,
    input  wire logic        done_i,
    input  wire logic        error_i,
    input  wire logic [31:0] data_i
);

  logic asks;
  logic part;
  logic part_q;  // answered: write of a part of a word
  assign asks = cyc_i && stb_i;
  assign part = we_i && sel_i != 4'b1111;
  always_ff @(posedge clk_i) part_q <= rst_ni && asks && part && !part_q;

  assign valid_o = asks && !part;
  assign write_o = we_i;
  assign word_o  = adr_i;
  assign data_o  = dat_i;
  assign ack_o   = done_i && !error_i;
  assign err_o   = (done_i && error_i) || part_q;
  assign dat_o   = data_i;

endmodule
`default_nettype wire
