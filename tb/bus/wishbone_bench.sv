// SPDX-License-Identifier: Apache-2.0
// Registers behind Wishbone, with the signal names that cocotbext-wishbone looks for.
`default_nettype none
module wishbone_bench (
    input  wire logic        clk,
    input  wire logic        rst_n,
    input  wire logic        wb_cyc,
    input  wire logic        wb_stb,
    input  wire logic        wb_we,
    input  wire logic [ 6:0] wb_adr,
    input  wire logic [31:0] wb_datwr,
    input  wire logic [ 3:0] wb_sel,
    output logic             wb_ack,
    output logic             wb_err,
    output logic      [31:0] wb_datrd
);

  logic valid;
  logic write;
  logic [6:0] word;
  logic [31:0] data;
  logic done;
  logic error;
  logic [31:0] answer;
  wishbone_port u_port (
      .clk_i(clk),
      .rst_ni(rst_n),
      .cyc_i(wb_cyc),
      .stb_i(wb_stb),
      .we_i(wb_we),
      .adr_i(wb_adr),
      .dat_i(wb_datwr),
      .sel_i(wb_sel),
      .ack_o(wb_ack),
      .err_o(wb_err),
      .dat_o(wb_datrd),
      .valid_o(valid),
      .write_o(write),
      .word_o(word),
      .data_o(data),
      .done_i(done),
      .error_i(error),
      .data_i(answer)
  );
  bench_registers u_registers (
      .clk_i  (clk),
      .rst_ni (rst_n),
      .valid_i(valid),
      .write_i(write),
      .word_i (word),
      .data_i (data),
      .done_o (done),
      .error_o(error),
      .data_o (answer)
  );

endmodule
`default_nettype wire
