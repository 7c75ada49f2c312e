// SPDX-License-Identifier: Apache-2.0
// Rates from the positions of samples: the motion of each axis in the sample's period.
//
//     place = floor(position scale / 2^FineBits)          2^-16 step
//     rate  = place - place of the sample before          2^-16 step per period
//
// scale: number of 2^-16 steps in the whole range of positions, 2^FineBits of their units. Places
// are absolute, so no rounding adds up; a scale with an error of half a last bit moves no place by
// more than 2^-18 step. One adder serves all axes, bit by bit:
//
//   clock             0  1  2  3  ..  FineBits  +1  +2      +3      +4     +5
//   a bit is chosen   0  1  2
//   addend_q                   0                    last    -place
//   sum_q                                                   place   rate
//   memory                                                  place          rate
//   sample_ready_o                                                         1, of the last axis
//
// An axis to be referenced (fresh_i) takes its place as it is: the rate is the place's signed
// fraction of a step, and counts from a standstill on a whole step. A rate that does not fit
// RateBits, half a step per clock or more, is refused, and in a program's first sample (begins_i)
// one of a step or more: the axis stands elsewhere.
//
// A sample is one word of all axes, or with by_axis_i the position of axis_o, two clocks later; its
// two lowest bits are 0, for they are used before.
//
// Rates wait in the memory until they are taken: read_i, and two clocks later rate_o. Twin:
// PlaceScaler of hls/place_scaler.hpp.
`default_nettype none
module place_scaler #(
    parameter int Axes      = 3,   // [1, 9]
    parameter int FineBits  = 42,  // [18, 44]
    parameter int ScaleBits = 44,  // [40, 56]
    parameter int RateBits  = 29   // [22, 36]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Scales, to be written while nothing moves; then the axis needs a reference. Axis and scale
    // stay for a clock more.
    input wire logic                 scale_write_i,
    input wire logic [          3:0] scale_axis_i,
    input wire logic [ScaleBits-1:0] scale_i,

    // Samples, axis 0 in the low bits
    input  wire logic                     sample_valid_i,
    output logic                          sample_ready_o,
    input  wire logic [Axes*FineBits-1:0] sample_i,
    input  wire logic                     by_axis_i,       // stable while a sample is offered
    output logic      [              3:0] axis_o,
    input  wire logic [     FineBits-1:0] position_i,      // position of axis_o, with by_axis_i
    input  wire logic                     begins_i,        // a program's first, from a standstill

    // Axes that this sample references, and axes that count
    input  wire logic [Axes-1:0] fresh_i,
    input  wire logic [Axes-1:0] referenced_i,
    output logic      [Axes-1:0] fresh_taken_o,

    // Rates of all axes, until the last one is taken
    output logic                     rates_valid_o,
    input  wire logic                rates_taken_i,
    input  wire logic                read_i,         // only while rates are valid
    input  wire logic [         3:0] read_axis_i,
    output logic      [RateBits-1:0] rate_o,
    output logic                     moves_o,
    output logic                     fresh_o,
    output logic                     refused_o
);

  localparam int Fraction = pulse_pkg::StepFraction;
  localparam int SumBits = ScaleBits + 2;
  localparam int IndexBits = $clog2(Axes * FineBits + 1);

  // Times: bits of an axis, then its difference.
  logic [3:0] axis_q;
  logic [5:0] bits_q;
  logic [IndexBits-1:0] index_q;  // of all bits, a clock ahead of bits_q
  logic choosing_q;
  logic chosen_q;
  logic sign_q;
  logic [1:0] adding_q;
  logic [4:0] tail_q;
  logic [Axes-1:0] here;  // the present axis, one of them
  logic last_bit;
  logic last_axis;
  logic ends;
  logic starts;
  assign last_bit = choosing_q && bits_q == 6'(FineBits - 1);
  assign here = Axes'(1) << axis_q;
  assign last_axis = axis_q == 4'(Axes - 1);
  assign ends = tail_q[4] && last_axis;
  assign sample_ready_o = ends;
  assign axis_o = axis_q;
  logic idle_q;
  assign starts = (idle_q && sample_valid_i && !rates_valid_o) || (tail_q[4] && !last_axis);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      idle_q        <= 1'b1;
      axis_q        <= '0;
      bits_q        <= '0;
      index_q       <= '0;
      choosing_q    <= 1'b0;
      chosen_q      <= 1'b0;
      sign_q        <= 1'b0;
      adding_q      <= '0;
      tail_q        <= '0;
      rates_valid_o <= 1'b0;
    end else begin
      if (starts) idle_q <= 1'b0;
      else if (ends) idle_q <= 1'b1;
      if (ends) axis_q <= '0;
      else if (tail_q[4]) axis_q <= axis_q + 1'b1;
      if (starts) choosing_q <= 1'b1;
      else if (last_bit) choosing_q <= 1'b0;
      if (last_bit) bits_q <= '0;
      else if (choosing_q) bits_q <= bits_q + 1'b1;
      if (ends) index_q <= '0;
      else if (starts || (choosing_q && !last_bit)) index_q <= index_q + 1'b1;
      chosen_q <= choosing_q;
      sign_q   <= last_bit;
      adding_q <= {adding_q[0], chosen_q};
      tail_q   <= {tail_q[3:0], sign_q};
      if (ends) rates_valid_o <= 1'b1;
      else if (rates_taken_i) rates_valid_o <= 1'b0;
    end
  end

  // The present bit, and whether its axis begins anew.
  logic bit_q;
  logic sample_bit_q;
  logic fresh_q;
  always_ff @(posedge clk_i) begin
    sample_bit_q <= sample_i[index_q];
    bit_q        <= by_axis_i ? position_i[bits_q[$clog2(FineBits)-1:0]] : sample_bit_q;
    if (sign_q) fresh_q <= (fresh_i & here) != '0;
  end

  // The memory: by axis places, rates and scales. A scale that meets another word waits a clock.
  localparam logic [1:0] Places = 2'd0;
  localparam logic [1:0] Rates = 2'd1;
  localparam logic [1:0] Scales = 2'd2;
  logic write;
  logic scale_waits_q;
  logic [5:0] write_address;
  logic [5:0] read_address;
  logic [SumBits-1:0] write_data;
  logic [SumBits-1:0] word_q;
  (* no_rw_check, ram_style = "block" *)
  logic [SumBits-1:0] words[64];
  assign write = tail_q[2] || tail_q[4];
  always_comb begin
    if (write) write_address = {tail_q[4] ? Rates : Places, axis_q};
    else write_address = {Scales, scale_axis_i};
    if (read_i) read_address = {Rates, read_axis_i};
    else read_address = {tail_q[0] ? Places : Scales, axis_q};
  end
  always_ff @(posedge clk_i) begin
    scale_waits_q <= scale_write_i && write;
    if (write || scale_write_i || scale_waits_q) words[write_address] <= write_data;
    word_q <= words[read_address];
  end

  // Sums: of the product's digits, each time a bit further, then the difference.
  typedef enum logic [1:0] {
    Nothing,
    Scale,
    LessScale,
    LessPlace
  } what_t;
  (* fsm_encoding = "none" *)
  what_t what_q;
  logic signed [ScaleBits:0] addend_q;
  logic carry_q;
  logic signed [SumBits-1:0] sum_q;  // the next one is added to [SumBits-1:1]
  logic signed [ScaleBits:0] scale;
  logic signed [ScaleBits:0] place;
  logic signed [SumBits-1:0] sum;
  assign scale = {1'b0, word_q[ScaleBits-1:0]};
  assign place = word_q[SumBits-1:1];
  assign sum = {sum_q[SumBits-1], sum_q[SumBits-1:1]} + {addend_q[ScaleBits], addend_q}
      + SumBits'(carry_q);
  always_ff @(posedge clk_i) begin
    if (tail_q[0]) what_q <= fresh_q ? Nothing : LessPlace;
    else if (chosen_q && bit_q) what_q <= sign_q ? LessScale : Scale;
    else what_q <= Nothing;
    case (what_q)
      Scale: addend_q <= scale;
      LessScale: addend_q <= ~scale;
      LessPlace: addend_q <= ~place;
      default: addend_q <= '0;
    endcase
    carry_q <= what_q == LessScale || what_q == LessPlace;
    if (!rst_ni || tail_q[4]) sum_q <= '0;
    else if (adding_q[1] || tail_q[2]) sum_q <= sum;
  end

  // The rate as the memory keeps it.
  logic counts_q;
  logic moves_q;
  logic refused_q;
  logic fits;
  logic near;
  logic signed [RateBits-1:0] rate;
  assign fits = sum_q[SumBits-1:RateBits-1] == '0 || sum_q[SumBits-1:RateBits-1] == '1;
  assign near = sum_q[RateBits-1:Fraction] == '0 || sum_q[RateBits-1:Fraction] == '1;
  assign rate = fresh_q ? {{(RateBits - Fraction) {sum_q[Fraction-1]}}, sum_q[Fraction-1:0]} :
      sum_q[RateBits-1:0];
  always_ff @(posedge clk_i) begin
    counts_q  <= (referenced_i & here) != '0 && !fresh_q;
    refused_q <= counts_q && !(fits && (near || !begins_i));
    moves_q   <= counts_q && sum_q[RateBits-1:0] != '0;
  end
  always_comb begin
    write_data = write ? sum_q : {2'd0, scale_i};
    if (tail_q[4]) write_data[RateBits+2:0] = {refused_q, fresh_q, moves_q, rate};
  end
  assign fresh_taken_o = tail_q[4] && fresh_q ? here : '0;

  // A register behind the memory, which is slow.
  always_ff @(posedge clk_i) begin
    {refused_o, fresh_o, moves_o, rate_o} <= word_q[RateBits+2:0];
  end

endmodule
`default_nettype wire
