// SPDX-License-Identifier: Apache-2.0
// The datapath that evaluates profile pieces in the serial build, one adder, a memory of 16 words
// and the bits of a factor, by the words of rtl/path/path_program.sv
// (rtl/path/path_control_pkg.sv).
//
//     sum' = sum + memory[read]       Halve: half of that, rounded down; Invert: its bits inverted
//
// Differences are sums: a - b = ~(~a + b).
//
// Halve with Multiply makes the product of Factor and the loaded word, from its lowest bit on. Each
// drops a bit that no later one changes, so n of them give the product over 2^n, rounded down; the
// bit that was dropped last rounds it to nearest.
//
// An operand is read a clock before its word is obeyed, so it is not the word that this clock
// writes.
//
// Words have 48 bits: quanta of the path, ticks with 16 fraction bits, coefficients with 34. Words
// of the next piece are written as they come; control_i writes nothing in that clock.
`default_nettype none
module path_datapath (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic   [path_control_pkg::Bits-1:0] control_i,
    input  wire logic   [path_control_pkg::Bits-1:0] ahead_i,    // word of the next clock
    input  wire logic   [                       1:0] pass_i,     // pass of the coefficient read
    output logic signed [                      47:0] sum_o,

    input wire logic [16:0] rate_i,
    input wire logic [19:0] ticks_i,

    // Words of the next piece, and its bank; the present one is in the other
    input wire logic        bank_i,
    input wire logic        ds_write_i,
    input wire logic        coef_write_i,
    input wire logic [ 1:0] coef_pass_i,
    input wire logic [43:0] word_i
);

  logic multiply;
  assign multiply = control_i[path_control_pkg::Multiply];

  // Operand of the next clock. While a product's word is obeyed again the word behind it is ahead,
  // so both choose; behind the last bit are zeros, as time in a piece is less than 2^m.
  logic [34:0] factor_q;
  logic [3:0] read;
  logic next_bit;
  assign read     = ahead_i[path_control_pkg::Read+:4];
  assign next_bit = control_i[path_control_pkg::Load] ? sum_o[0] : factor_q[1];

  // Words of a piece: {1, bank, pass}, ds as pass 3. Memories are slow: few gates behind ahead_i.
  logic [3:0] address;
  always_comb begin
    address = {read[3], read[3] ? !bank_i : read[2], read[1:0] | ({2{read[3]}} & pass_i)};
    if (ahead_i[path_control_pkg::Choose] && next_bit) address[1] = 1'b1;
  end

  logic loads;
  logic writes;
  logic [3:0] write_address;
  logic [47:0] word;
  logic [47:0] written;
  assign loads = ds_write_i || coef_write_i;
  assign writes = control_i[path_control_pkg::Store] || loads;
  assign write_address = loads ? {1'b1, bank_i, coef_write_i ? coef_pass_i : 2'd3} :
      control_i[path_control_pkg::Write+:4];
  assign word = {ds_write_i ? {4'b0, word_i[43:36]} : {12{word_i[35]}}, word_i[35:0]};
  always_comb begin
    written = loads ? word : sum_o;
    if (control_i[path_control_pkg::OfRate]) written[16:0] = rate_i;
    if (control_i[path_control_pkg::OfTicks]) written[35:16] = ticks_i;
  end

  (* no_rw_check *)
  logic [47:0] memory[16];
  logic [47:0] operand_q;
  always_ff @(posedge clk_i) begin
    if (writes) memory[write_address] <= written;
    operand_q <= memory[address];
  end

  logic half_q;
  logic [48:0] augend;
  logic [48:0] addend;
  logic [48:0] sum;
  logic [47:0] next;
  assign augend = {sum_o, 1'b1};
  assign addend = {operand_q, control_i[path_control_pkg::Round] && half_q};
  assign sum    = augend + addend;
  assign next   = control_i[path_control_pkg::Halve] ? {sum[48], sum[48:2]} : sum[48:1];
  always_ff @(posedge clk_i) begin
    half_q <= sum[1];
    if (!rst_ni || control_i[path_control_pkg::Clear]) sum_o <= '0;
    else if (control_i[path_control_pkg::Add])
      sum_o <= next ^ {48{control_i[path_control_pkg::Invert]}};
  end

  always_ff @(posedge clk_i) begin
    if (control_i[path_control_pkg::Load]) factor_q <= sum_o[34:0];
    else if (multiply) factor_q <= factor_q >> 1;
  end

endmodule
`default_nettype wire
