// SPDX-License-Identifier: Apache-2.0
// Codes of the engine's instructions. Twin: hls/instruction.hpp, which explains them.
`default_nettype none
package engine_pkg;

  // Operations, {op, n - 1, odd parity, flag, F0, F1, F2}
  localparam logic [3:0] Br = 4'd0;
  localparam logic [3:0] Out = 4'd1;
  localparam logic [3:0] In = 4'd2;
  localparam logic [3:0] Add = 4'd4;
  localparam logic [3:0] Sub = 4'd5;
  localparam logic [3:0] Mull = 4'd8;
  localparam logic [3:0] Mulr = 4'd9;
  localparam logic [3:0] Madr = 4'd10;
  localparam logic [3:0] Mac = 4'd11;
  localparam logic [3:0] Shr = 4'd12;

  // Ports of the engine's own
  localparam logic [4:0] PortX = 5'd0;
  localparam logic [4:0] PortY = 5'd1;
  localparam logic [4:0] PortLink = 5'd2;

  // Counts the changes of rtl/engine/programs/ports.asm that programs made before do not know of
  localparam int PortNumbers = 2;

  // Returns what microcode is made for, a digest of its core: rtl/engine/compiler/word_numbers.hpp
  function automatic logic [14:0] made_for(input int core, input int aux_axes, input int splines,
                                           input int segment_queue_words,
                                           input int profile_queue_words, input int rate_bits);
    logic [15:0] sum;
    sum = system_pkg::digest_word(16'(PortNumbers), 32'(core));
    sum = system_pkg::digest_word(sum, 32'((rate_bits << 8) + 2 * aux_axes + splines));
    sum = system_pkg::digest_word(sum, 32'(segment_queue_words));
    sum = system_pkg::digest_word(sum, 32'(profile_queue_words));
    made_for = sum[14:0];
  endfunction
  // Ports of samples: rtl/engine/programs/ports.asm
  localparam int OutSample = 16;
  localparam int OutPlacing = 17;
  localparam int OutAxisRate = 19;
  localparam int OutUnmoved = 20;
  localparam int OutMovedOn = 21;
  localparam int OutStandsAt = 22;
  localparam int OutRefused = 23;
  localparam int OutRefusedMove = 24;
  localparam int OutSampleWhole = 25;

  // Words of either stream that have room at once: rtl/engine/engine_entry.sv
  localparam int EntryWords = 128;

  // Memory: limbs that words 0 to 4 begin with; words 0 to 7 are never written
  localparam int One = 0;  // 2^r at r
  localparam int MinusOne = 15;
  localparam int Zero = 16;
  function automatic logic [15:0] first_limb(input int place);
    logic [31:0] power;
    power = 32'd1 << place[3:0];
    first_limb = '0;
    if (place < MinusOne) first_limb = power[15:0];
    if (place == MinusOne) first_limb = '1;
  endfunction

endpackage
`default_nettype wire
