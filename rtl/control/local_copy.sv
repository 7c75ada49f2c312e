// SPDX-License-Identifier: Apache-2.0
// A control word one clock later, in registers of its own: each copy sits beside its loads, where
// one shared register would have to reach across the chip.  Hierarchy is kept in synthesis, or it
// would find the copies equal and share them.
`default_nettype none (* keep_hierarchy *)
module local_copy #(
    parameter int Bits = 1  // [1, 64]
) (
    input  wire logic            clk_i,
    input  wire logic [Bits-1:0] data_i,
    output logic      [Bits-1:0] data_o
);

  always_ff @(posedge clk_i) data_o <= data_i;

endmodule
`default_nettype wire
