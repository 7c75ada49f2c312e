// SPDX-License-Identifier: Apache-2.0
// Takes the words of a segment of the serial build (hls/words.hpp): coefficients and points go to
// their memories, other words of the path stay here.  A spline's scales are made as well
// (scale_words.sv), in 9 more clocks.
//
//   open_i      the words of a segment are taken, and of the next if it is empty
//   length_o    segment_data_i is the length
//   there_o     all words of a segment with a length are in their places
`default_nettype none
module serial_segment #(
    parameter int CoefBits = 36,  // [18, 36]
    parameter int FineBits = 42,  // [18, 44]
    parameter int AuxAxes  = 0,   // [0, 6]
    parameter int Splines  = 1    // 0 no segment is one, 1 those that say so, 2 all
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic        open_i,
    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic [47:0] segment_data_i,

    output logic        length_o,
    output logic        there_o,
    output logic [15:0] empty_segments_o,
    output logic [ 4:0] k_o,
    output logic [ 4:0] down_o,            // MaxStepExponent - k
    output logic        spline_o,          // the segment is one
    output logic [ 4:0] spline_down_o,     // MaxStepExponent - lambda

    output logic                write_o,
    output logic [         7:0] write_address_o,
    output logic [CoefBits-1:0] write_data_o,
    output logic                write_start_o,
    output logic                write_end_o,
    output logic [         3:0] write_axis_o,
    output logic [FineBits-1:0] write_point_o
);

  localparam int Axes = 3 + AuxAxes;

  typedef enum logic [2:0] {
    Length,
    Theta,
    StartWord,
    EndWord,
    Tangent,
    Normal,
    Advance
  } field_t;
  field_t field_q, field_d;
  logic [3:0] axis_q;
  logic       empty_q;
  logic       accept;
  logic       complete;
  assign accept   = segment_valid_i && segment_ready_o;
  assign complete = accept && field_q == Advance && axis_q == 4'(Axes - 1);
  assign length_o = accept && field_q == Length;

  always_comb begin
    field_d = field_q;
    case (field_q)
      Length:    field_d = Theta;
      Theta:     field_d = StartWord;
      StartWord: field_d = EndWord;
      EndWord: begin
        field_d = Tangent;
        if (axis_q >= 4'd3) field_d = Advance;
      end
      Tangent:   field_d = Normal;
      Normal:    field_d = Advance;
      default: begin
        field_d = StartWord;
        if (complete) field_d = Length;
      end
    endcase
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      field_q          <= Length;
      axis_q           <= 4'd0;
      empty_segments_o <= 16'd0;
    end else begin
      if (accept) field_q <= field_d;
      if (accept && field_q == Advance) axis_q <= complete ? 4'd0 : axis_q + 4'd1;
      if (complete && empty_q && empty_segments_o != '1)
        empty_segments_o <= empty_segments_o + 16'd1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (length_o) empty_q <= segment_data_i[43:0] == 44'd0;
    if (accept && field_q == Theta) k_o <= segment_data_i[words_pkg::StepExponentLow+:5];
    down_o <= 5'(curvecore_pkg::MaxStepExponent) - k_o;
  end

  logic                scaling;
  logic                scale_write;
  logic [         2:0] scale_place;
  logic [CoefBits-1:0] scale_word;
  if (Splines == 0) begin : g_arcs
    assign spline_o      = 1'b0;
    assign spline_down_o = 5'd0;
    assign scaling       = 1'b0;
    assign scale_write   = 1'b0;
    assign scale_place   = 3'd0;
    assign scale_word    = '0;
    assign there_o       = complete && !empty_q;
  end else begin : g_splines
    logic [4:0] lambda_q;
    logic       scaling_q;
    logic       scale_done;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) scaling_q <= 1'b0;
      else scaling_q <= (complete && !empty_q && spline_o) || (scaling_q && !scale_done);
    end
    always_ff @(posedge clk_i) begin
      if (accept && field_q == Theta)
        spline_o <= Splines == 2 || segment_data_i[words_pkg::KindLow];
      if (accept && field_q == Normal && axis_q == 4'd0)
        lambda_q <= segment_data_i[words_pkg::LambdaLow+:5];
      spline_down_o <= 5'(curvecore_pkg::MaxStepExponent) - lambda_q;
    end
    scale_words #(
        .CoefBits(CoefBits)
    ) u_scale (
        .clk_i,
        .run_i   (scaling_q),
        .k_i     (k_o),
        .lambda_i(lambda_q),
        .write_o (scale_write),
        .place_o (scale_place),
        .word_o  (scale_word),
        .done_o  (scale_done)
    );
    assign scaling = scaling_q;
    assign there_o = spline_o ? scaling_q && scale_done : complete && !empty_q;
  end
  assign segment_ready_o = open_i && !scaling;

  // Rows: normal 0, 2, 4 and tangent 1, 3, 5 (x F y G z H of the table); of splines b and a.
  logic [2:0] axis_row;
  assign axis_row = {1'b0, axis_q[1:0]};
  always_comb begin
    case (field_q)
      Theta:   write_address_o = 8'hb7;
      Tangent: write_address_o = {axis_row, 1'b1, 4'd0};
      Normal:  write_address_o = {axis_row, 1'b0, 4'd0};
      default: write_address_o = {4'hc, axis_q};
    endcase
    write_data_o = segment_data_i[CoefBits-1:0];
    write_o      = accept && field_q != Length && field_q != StartWord && field_q != EndWord;
    if (scaling) begin
      write_address_o = {5'b10111, scale_place};
      write_data_o    = scale_word;
      write_o         = scale_write;
    end
  end
  assign write_start_o = accept && field_q == StartWord;
  assign write_end_o   = accept && field_q == EndWord;
  assign write_axis_o  = axis_q;
  assign write_point_o = segment_data_i[FineBits-1:0];

endmodule
`default_nettype wire
