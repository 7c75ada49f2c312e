// SPDX-License-Identifier: Apache-2.0
// Segment words from the bus in two banks: the network reads one while the other is filled.
// Word order: hls/words.hpp.
//
//   segment_valid_o   the next segment is complete; length_o, theta_o (phi of a spline),
//                     k_o, lambda_o, kind_o are its words
//   take_i            it becomes the present one: from the next clock the reads below show it, and
//                     the other bank takes words
//
// A segment of length zero is consumed and counted, up to 65535.  Reads follow their axis in the
// same clock; the words of rate_axis_i and cubic_axis_i are the same, read twice, so that lines and
// arcs, or splines, do not wait for a choice between their axes.
`default_nettype none
module segment_loader #(
    parameter int CoefBits = 36,  // [18, 36]
    parameter int FineBits = 42,  // [18, 44]
    parameter int AuxAxes  = 0    // [0, 6]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic        valid_i,
    output logic             ready_o,
    input  wire logic [47:0] data_i,

    output logic                     segment_valid_o,
    input  wire logic                take_i,
    output logic      [        47:0] length_o,
    output logic      [CoefBits-1:0] theta_o,
    output logic      [         4:0] k_o,
    output logic      [         5:0] lambda_o,
    output logic                     kind_o,
    output logic      [        15:0] empty_segments_o,

    // The present segment
    input  wire logic   [         3:0] rate_axis_i,
    output logic signed [CoefBits-1:0] tangent_o,
    output logic signed [CoefBits-1:0] normal_o,
    output logic signed [CoefBits-1:0] advance_o,
    input  wire logic   [         3:0] cubic_axis_i,
    output logic signed [CoefBits-1:0] a_o,
    output logic signed [CoefBits-1:0] b_o,
    output logic signed [CoefBits-1:0] c_o,
    input  wire logic   [         3:0] point_axis_i,
    output logic signed [FineBits-1:0] start_o,
    output logic signed [FineBits-1:0] end_o
);

  localparam int Axes = 3 + AuxAxes;

  typedef enum logic [2:0] {
    Length,
    Theta,
    Start,
    End,
    Tangent,
    Normal,
    Advance,
    Full
  } field_t;

  field_t field_q, field_d;
  logic [3:0] axis_q, axis_d;
  logic accept;
  logic complete;
  logic last_axis_q;
  logic empty_q;  // the length is zero; valid from two words after it
  assign ready_o  = field_q != Full;
  assign accept   = valid_i && ready_o;
  assign complete = accept && field_q == Advance && last_axis_q;

  always_comb begin
    field_d = field_q;
    axis_d  = axis_q;
    case (field_q)
      Length:  field_d = Theta;
      Theta:   field_d = Start;
      Start:   field_d = End;
      End: begin
        field_d = Tangent;
        if (axis_q >= 4'd3) field_d = Advance;
      end
      Tangent: field_d = Normal;
      Normal:  field_d = Advance;
      default: begin
        field_d = Start;
        axis_d  = axis_q + 4'd1;
      end
    endcase
    if (complete) begin
      field_d = Full;
      if (empty_q) field_d = Length;
      axis_d = 4'd0;
    end
  end

  logic bank_q;  // bank that is filled; the present segment is in the other
  assign segment_valid_o = field_q == Full;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      field_q          <= Length;
      axis_q           <= 4'd0;
      last_axis_q      <= 1'b0;
      bank_q           <= 1'b0;
      empty_segments_o <= 16'd0;
    end else begin
      if (accept) begin
        field_q     <= field_d;
        axis_q      <= axis_d;
        last_axis_q <= axis_d == 4'(Axes - 1);
      end
      if (complete && empty_q && empty_segments_o != '1)
        empty_segments_o <= empty_segments_o + 16'd1;
      if (segment_valid_o && take_i) begin
        field_q <= Length;
        bank_q  <= !bank_q;
      end
    end
  end

  // A word is written a clock after its acceptance, before it can be read.
  logic          write_q;
  field_t        write_field_q;
  logic   [ 4:0] fill_q;
  logic   [47:0] data_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) write_q <= 1'b0;
    else write_q <= accept;
  end
  always_ff @(posedge clk_i) begin
    write_field_q <= field_q;
    fill_q        <= {bank_q, axis_q};
    data_q        <= data_i;
    if (write_q && write_field_q == Length) length_o <= {4'b0, data_q[43:0]};
    empty_q <= length_o == 48'd0;
    if (write_q && write_field_q == Theta) begin
      theta_o <= data_q[CoefBits-1:0];
      k_o     <= data_q[words_pkg::StepExponentLow+:5];
      kind_o  <= data_q[words_pkg::KindLow];
    end
    if (write_q && write_field_q == Normal && fill_q[3:0] == 4'd0)
      lambda_o <= data_q[words_pkg::LambdaLow+:6];
  end

  logic signed [FineBits-1:0] start_memory  [32];
  logic signed [FineBits-1:0] end_memory    [32];
  logic signed [CoefBits-1:0] tangent_memory[ 8];
  logic signed [CoefBits-1:0] normal_memory [ 8];
  logic signed [CoefBits-1:0] advance_memory[32];
  logic        [         4:0] rate;
  logic        [         4:0] cubic;
  logic        [         4:0] point;
  logic        [         2:0] fill_xyz;
  logic        [         2:0] rate_xyz;
  logic        [         2:0] cubic_xyz;
  assign rate      = {!bank_q, rate_axis_i};
  assign cubic     = {!bank_q, cubic_axis_i};
  assign point     = {!bank_q, point_axis_i};
  assign fill_xyz  = {fill_q[4], fill_q[1:0]};
  assign rate_xyz  = {!bank_q, rate_axis_i[1:0]};
  assign cubic_xyz = {!bank_q, cubic_axis_i[1:0]};
  always_ff @(posedge clk_i) begin
    if (write_q && write_field_q == Start) start_memory[fill_q] <= data_q[FineBits-1:0];
    if (write_q && write_field_q == End) end_memory[fill_q] <= data_q[FineBits-1:0];
    if (write_q && write_field_q == Tangent) tangent_memory[fill_xyz] <= data_q[CoefBits-1:0];
    if (write_q && write_field_q == Normal) normal_memory[fill_xyz] <= data_q[CoefBits-1:0];
    if (write_q && write_field_q == Advance) advance_memory[fill_q] <= data_q[CoefBits-1:0];
  end
  assign tangent_o = tangent_memory[rate_xyz];
  assign normal_o  = normal_memory[rate_xyz];
  assign advance_o = advance_memory[rate];
  assign a_o       = tangent_memory[cubic_xyz];
  assign b_o       = normal_memory[cubic_xyz];
  assign c_o       = advance_memory[cubic];
  assign start_o   = start_memory[point];
  assign end_o     = end_memory[point];

endmodule
`default_nettype wire
