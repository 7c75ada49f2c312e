// SPDX-License-Identifier: Apache-2.0
// Words on their way to the engine, which takes one of them at a time: a ring of each stream, both
// in one memory, so that a burst of words finds room at once.
//
//   clock              0       1       2
//   segment_valid_i    1
//   segment_waits_o            1               until it is taken
//   word_o                             word    of the stream that profile_i says, if one waits
//   take_i             1
//   word_o                             the next one
//
// A word of a profile waits while one of a segment comes.
`default_nettype none
module engine_entry #(
    parameter int Words = 128  // [2, 4096], a power of two; of each stream
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Streams
    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    output logic      [15:0] segment_room_o,   // words that still fit
    input  wire logic [47:0] segment_i,
    input  wire logic        profile_valid_i,
    output logic             profile_ready_o,
    output logic      [15:0] profile_room_o,
    input  wire logic [47:0] profile_i,

    // Engine
    input  wire logic        of_profile_i,     // the stream at hand
    output logic      [47:0] word_o,
    input  wire logic        take_i,           // its word, if one waits
    output logic             segment_waits_o,
    output logic             profile_waits_o
);

  localparam int PlaceBits = $clog2(Words);
  initial
    if (Words < 2 || Words > 4096 || 2 ** PlaceBits != Words)
      $fatal(1, "Words must be a power of two in [2, 4096]");

  // Places, and one bit more: full and empty differ in it.
  logic [PlaceBits:0] segment_put_q, segment_take_q, profile_put_q, profile_take_q;
  logic [PlaceBits:0] segment_room, profile_room;
  logic segment_put, profile_put;
  assign segment_waits_o = segment_put_q != segment_take_q;
  assign profile_waits_o = profile_put_q != profile_take_q;
  assign segment_room = (segment_take_q ^ (PlaceBits + 1)'(Words)) - segment_put_q;
  assign profile_room = (profile_take_q ^ (PlaceBits + 1)'(Words)) - profile_put_q;
  assign segment_room_o = 16'(segment_room);
  assign profile_room_o = 16'(profile_room);
  assign segment_ready_o = segment_room != '0;
  assign profile_ready_o = profile_room != '0 && !segment_put;
  assign segment_put = segment_valid_i && segment_ready_o;
  assign profile_put = profile_valid_i && profile_ready_o;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      segment_put_q  <= '0;
      segment_take_q <= '0;
      profile_put_q  <= '0;
      profile_take_q <= '0;
    end else begin
      if (segment_put) segment_put_q <= segment_put_q + 1'b1;
      if (profile_put) profile_put_q <= profile_put_q + 1'b1;
      if (take_i && !of_profile_i) segment_take_q <= segment_take_q + 1'b1;
      if (take_i && of_profile_i) profile_take_q <= profile_take_q + 1'b1;
    end
  end

  logic [PlaceBits:0] put, take;
  assign put = {
    profile_put, profile_put ? profile_put_q[PlaceBits-1:0] : segment_put_q[PlaceBits-1:0]
  };
  assign take = {
    of_profile_i, of_profile_i ? profile_take_q[PlaceBits-1:0] : segment_take_q[PlaceBits-1:0]
  };
  (* no_rw_check *)
  logic [47:0] memory[2*Words];
  always_ff @(posedge clk_i) begin
    if (segment_put || profile_put) memory[put] <= profile_put ? profile_i : segment_i;
    word_o <= memory[take];
  end

endmodule
`default_nettype wire
