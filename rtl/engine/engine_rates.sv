// SPDX-License-Identifier: Apache-2.0
// Samples of the engine as rates of the axes (rtl/engine/programs/places.asm), until they are due:
// a ring of them in block RAM, and behind it the scales, which the programs read after a reset.
//
//   clock          0      1      2      3              clock         0     1     2
//   axis_rate      low    high                         read_i        1
//   sample_whole                 1                     read_axis_i   a
//   made_o                              1              rate_o                    of axis a
//
// A sample that is made is taken when the one before it has left, with its last read, and is read
// from then on; empty_i drops those that are not taken. As in rtl/pulse/place_scaler.sv, rate_o is
// {refused, fresh, moves, rate}, here of an axis that is referenced.
//
// references_o: axes to be referenced by the next sample. It is the first since a reset of the
// programs, for they are told while no sample is made or under way.
`default_nettype none
module engine_rates #(
    parameter int Axes       = 3,   // [1, 9]
    parameter int ScaleBits  = 44,  // [40, 45]
    parameter int PeriodLog2 = 13   // [6, 13]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Programs, which work_i lets go on
    input  wire logic        work_i,
    input  wire logic [31:0] out_i,         // the port that a limb comes to
    input  wire logic        high_i,        // not its first one
    input  wire logic [15:0] data_i,
    output logic      [ 3:0] axis_o,        // whose rate, or scale, is next
    input  wire logic        scale_high_i,  // it is the scale's high word
    input  wire logic        scale_last_i,  // the axis' last
    output logic      [31:0] scale_o,       // two clocks later

    // Scales, while the programs do not work. Axis and scale stay for a clock more.
    input wire logic                 scale_write_i,
    input wire logic [          3:0] scale_axis_i,
    input wire logic [ScaleBits-1:0] scale_i,

    input  wire logic [Axes-1:0] reference_i,
    output logic      [Axes-1:0] references_o,

    // Samples
    input  wire logic empty_i,
    output logic      made_o,
    output logic      ready_o,
    input  wire logic taken_i,

    // Rates of the sample that was taken: rtl/pulse/sample_period.sv
    output logic                                               valid_o,
    input  wire logic                                          read_i,
    input  wire logic [                                   3:0] read_axis_i,
    input  wire logic                                          read_last_i,
    output logic      [pulse_pkg::StepFraction+PeriodLog2+2:0] rate_o
);

  initial if (Axes < 1 || Axes > 9) $fatal(1, "Axes must be in [1, 9]");
  initial
    if (ScaleBits < 40 || ScaleBits > 45) $fatal(1, "ScaleBits must be in [40, 45] with Build 2");
  initial
    if (PeriodLog2 < 6 || PeriodLog2 > 13) $fatal(1, "PeriodLog2 must be in [6, 13] with Build 2");

  localparam int RateBits = pulse_pkg::StepFraction + PeriodLog2;
  localparam int AxisBits = (Axes > 4) ? 4 : 2;

  logic kind, rate, whole;
  assign kind = out_i[engine_pkg::OutUnmoved] || out_i[engine_pkg::OutMovedOn] ||
      out_i[engine_pkg::OutStandsAt] || out_i[engine_pkg::OutRefused] ||
      out_i[engine_pkg::OutRefusedMove];
  assign rate = out_i[engine_pkg::OutAxisRate];
  assign whole = out_i[engine_pkg::OutSampleWhole];

  // Samples: those between take_q and put_q are made; that of read_q is taken while valid_o.
  logic [3:0] put_q, take_q, read_q;
  assign made_o  = put_q != take_q;
  assign ready_o = !valid_o;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      put_q   <= '0;
      take_q  <= '0;
      valid_o <= 1'b0;
    end else begin
      if (empty_i) put_q <= take_q;
      else if (whole) put_q <= put_q + 1'b1;
      if (taken_i) take_q <= take_q + 1'b1;
      if (taken_i) valid_o <= 1'b1;
      else if (read_last_i) valid_o <= 1'b0;
    end
    if (taken_i) read_q <= take_q;
  end

  // Axes
  logic [3:0] axis_q;
  logic fresh_q, moves_q, refused_q;
  assign axis_o = axis_q;
  always_ff @(posedge clk_i) begin
    if (!work_i) axis_q <= '0;
    else if ((rate && high_i) || scale_last_i)
      axis_q <= (axis_q == 4'(Axes - 1)) ? '0 : axis_q + 1'b1;
    if (kind) begin
      refused_q <= out_i[engine_pkg::OutRefused] || out_i[engine_pkg::OutRefusedMove];
      fresh_q   <= out_i[engine_pkg::OutStandsAt];
      moves_q   <= out_i[engine_pkg::OutMovedOn] || out_i[engine_pkg::OutRefusedMove];
    end
    if (!rst_ni) references_o <= '0;
    else references_o <= (taken_i ? '0 : references_o) | reference_i;
  end

  // Memory, words of two halves: rates by sample and axis, then scales by their word and axis
  logic scale_high_q, reads_q;
  logic [AxisBits-1:0] read_axis_q;
  logic [AxisBits+4:0] write_address, read_address;
  logic write_low, write_high;
  logic [31:0] write_data;
  logic [31:0] word_q;
  (* no_rw_check, ram_style = "block" *)
  logic [31:0] words[2**(AxisBits+5)];
  assign write_low  = scale_write_i || scale_high_q || (rate && !high_i);
  assign write_high = scale_write_i || scale_high_q || (rate && high_i);
  always_comb begin
    if (scale_write_i || scale_high_q) begin
      write_address = {4'b1000, scale_high_q, scale_axis_i[AxisBits-1:0]};
      write_data = scale_high_q ? 32'(scale_i[ScaleBits-1:32]) : scale_i[31:0];
    end else begin
      write_address = {1'b0, put_q, axis_q[AxisBits-1:0]};
      write_data = {refused_q, fresh_q, data_i[13:0], moves_q, data_i[14:0]};
    end
    if (reads_q) read_address = {1'b0, read_q, read_axis_q};
    else read_address = {4'b1000, scale_high_i, axis_q[AxisBits-1:0]};
  end
  always_ff @(posedge clk_i) begin
    scale_high_q <= scale_write_i;
    reads_q      <= read_i;
    read_axis_q  <= read_axis_i[AxisBits-1:0];
    if (write_low) words[write_address][15:0] <= write_data[15:0];
    if (write_high) words[write_address][31:16] <= write_data[31:16];
    word_q <= words[read_address];
  end
  always_ff @(posedge clk_i) scale_o <= word_q;  // block RAM is slow
  logic [28:0] axis_rate;
  assign axis_rate = {word_q[29:16], word_q[14:0]};
  assign rate_o = {word_q[31], word_q[30], word_q[15], axis_rate[RateBits-1:0]};
  logic unused;
  assign unused = &{1'b0, axis_rate, out_i, data_i[15], scale_axis_i, read_axis_i};

endmodule
`default_nettype wire
