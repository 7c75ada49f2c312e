// SPDX-License-Identifier: Apache-2.0
// One spare word, so that `ready_o` is a register: a word that comes while the taker is not ready
// waits here.  No latency.
`default_nettype none
module skid_buffer #(
    parameter int Bits = 48  // [1, 512]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic            valid_i,
    output logic                 ready_o,
    input  wire logic [Bits-1:0] data_i,

    output logic                 valid_o,
    input  wire logic            ready_i,
    output logic      [Bits-1:0] data_o
);

  logic            full_q;
  logic [Bits-1:0] data_q;
  assign ready_o = !full_q;
  assign valid_o = full_q || valid_i;
  assign data_o  = full_q ? data_q : data_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) full_q <= 1'b0;
    else full_q <= valid_o && !ready_i;
  end
  always_ff @(posedge clk_i) begin
    if (!full_q) data_q <= data_i;
  end

endmodule
`default_nettype wire
