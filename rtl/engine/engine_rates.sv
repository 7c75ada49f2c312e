// SPDX-License-Identifier: Apache-2.0
// Samples of the engine as rates of the axes (rtl/engine/programs/places.asm), until they are due:
// a ring of them in block RAM.
//
//   clock          0      1      2      3              clock         0     1     2
//   axis_rate      low    high                         read_axis_i   a
//   sample_whole                 1                     rate_o                    of axis a
//   made_o                              1
//
// A sample that is made is taken when the one before it has left, with its last read, and is read
// from then on; empty_i drops those that are not taken. As in rtl/pulse/place_scaler.sv, rate_o is
// {refused, fresh, moves, rate}, here of an axis that is referenced.
//
// references_o: axes to be referenced by the next sample. It is the first since a reset of the
// programs, for they are told while no sample is made or under way.
`default_nettype none
module engine_rates #(
    parameter int Axes       = 3,  // [1, 9]
    parameter int PeriodLog2 = 13  // [6, 13]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Programs, which work_i lets go on
    input  wire logic        work_i,
    input  wire logic [31:0] out_i,        // the port that a limb comes to
    input  wire logic        high_i,       // not its first one
    input  wire logic [15:0] data_i,
    output logic      [ 3:0] axis_o,       // whose rate, or scale, is next
    input  wire logic        scale_last_i, // the last of an axis' scale is read

    input  wire logic [Axes-1:0] reference_i,
    output logic      [Axes-1:0] references_o,

    // Samples
    input  wire logic empty_i,
    output logic      made_o,
    output logic      ready_o,
    input  wire logic taken_i,

    // Rates of the sample that was taken: rtl/pulse/sample_period.sv
    output logic                                               valid_o,
    input  wire logic [                                   3:0] read_axis_i,
    input  wire logic                                          read_last_i,
    output logic      [pulse_pkg::StepFraction+PeriodLog2+2:0] rate_o
);

  initial if (Axes < 1 || Axes > 9) $fatal(1, "Axes must be in [1, 9]");
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

  // Memory, words of two halves, by sample and axis
  logic [AxisBits-1:0] read_axis_q;
  logic [AxisBits+3:0] write_address;
  logic [31:0] word_q;
  (* no_rw_check, ram_style = "block" *)
  logic [31:0] words[2**(AxisBits+4)];
  assign write_address = {put_q, axis_q[AxisBits-1:0]};
  always_ff @(posedge clk_i) begin
    read_axis_q <= read_axis_i[AxisBits-1:0];
    if (rate && !high_i) words[write_address][15:0] <= {moves_q, data_i[14:0]};
    if (rate && high_i) words[write_address][31:16] <= {refused_q, fresh_q, data_i[13:0]};
    word_q <= words[{read_q, read_axis_q}];
  end
  logic [28:0] axis_rate;
  assign axis_rate = {word_q[29:16], word_q[14:0]};
  assign rate_o = {word_q[31], word_q[30], word_q[15], axis_rate[RateBits-1:0]};
  logic unused;
  assign unused = &{1'b0, axis_rate, out_i, data_i[15], read_axis_i};

endmodule
`default_nettype wire
