// SPDX-License-Identifier: Apache-2.0
// The variable x and the tag of each evaluation, which travel with the passes of one Horner unit.
//
// A pass enters in clock 0 and is back Loop enabled clocks later: for its next pass in this unit,
// or in the next unit, as `first_i` then selects.
//
//   clock        0                                   Loop
//   slot_word_o  first_i ? word_i of the pass        its next pass
//                        : loop_word_o
//   loop_word_o                                      slot_word_o of clock 0
//
// The words turn in a ring of Loop - 1 places; `place_i` counts enabled clocks modulo Loop - 1.
`default_nettype none
module horner_slot #(
    parameter int Bits = 40,  // [1, 64] tag and x
    parameter int Loop = 6    // [6, 9]
) (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic en_i,

    input wire logic       first_i,
    input wire logic [2:0] place_i,

    input  wire logic            valid_i,
    input  wire logic [Bits-1:0] word_i,
    output logic      [Bits-1:0] slot_word_o,
    output logic                 loop_valid_o,
    output logic      [Bits-1:0] loop_word_o
);

  logic slot_valid;
  assign slot_valid  = first_i ? valid_i : loop_valid_o;
  assign slot_word_o = first_i ? word_i : loop_word_o;

  logic [Bits-1:0] ring[Loop-1];
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      loop_word_o   <= ring[place_i];
      ring[place_i] <= slot_word_o;
    end
  end

  logic [Loop-1:0] valid_q;
  assign loop_valid_o = valid_q[Loop-1];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else if (en_i) valid_q <= {valid_q[Loop-2:0], slot_valid};
  end

endmodule
`default_nettype wire
