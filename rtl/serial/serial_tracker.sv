// SPDX-License-Identifier: Apache-2.0
// Follows the path of the serial build: takes segments, runs the network for each step, and turns a
// request into tau (hls/interpolator_kernel.hpp).  A segment is taken when the path leaves the one
// before.
//
//   clocks                             value
//   request to tau                     3 + the quarter and single shifts of 27 - k
//   segment                            17 + 3 AuxAxes words, one a clock, then Weights, Expand
//   step                               when the samples under way are over: Step, Expand
//   of a spline                        the same, and 9 for its scales
`default_nettype none
module serial_tracker #(
    parameter int Order    = 6,   // [2, 12]
    parameter int CoefBits = 36,  // [18, 36]
    parameter int FineBits = 42,  // [18, 44]
    parameter int AuxAxes  = 0,   // [0, 6]
    parameter int Mode     = 0,   // 0 series, 1 polynomial
    parameter int Splines  = 1    // 0, 1
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic [47:0] segment_data_i,
    output logic      [15:0] empty_segments_o,

    input  wire logic        request_valid_i,
    output logic             request_ready_o,
    input  wire logic [47:0] request_ds_i,

    // Words for the memory of coefficients, and for the lander's of points
    output logic                     write_o,
    input  wire logic                write_ready_i,
    output logic      [ 7+Splines:0] write_address_o,
    output logic      [CoefBits-1:0] write_data_o,
    output logic                     write_start_o,
    output logic                     write_end_o,
    output logic      [         3:0] write_axis_o,
    output logic      [FineBits-1:0] write_point_o,
    output logic      [         4:0] down_o,           // MaxStepExponent - k
    output logic      [         4:0] spline_down_o,    // MaxStepExponent - lambda
    output logic                     spline_o,         // the segment is one

    // The sequencer
    output logic                    net_start_o,
    output logic      [6+Splines:0] net_entry_o,
    output logic      [        3:0] net_order_o,
    input  wire logic               net_busy_i,
    output logic                    sample_o,
    output logic                    land_o,
    input  wire logic               sample_take_i,
    input  wire logic [        1:0] context_i,
    input  wire logic               free_i,
    input  wire logic               quiet_i
);

  localparam int Axes = 3 + AuxAxes;
  localparam int TauLow = 43 - (CoefBits - 1);

  typedef enum logic [3:0] {
    Open,
    Scale,
    Weights,
    Angle,
    Step,
    Expand,
    Displace,
    Rest,
    Measure,
    Ready,
    Compare,
    Decide,
    Shift,
    Tau,
    Start,
    Leave
  } state_t;
  typedef enum logic [2:0] {
    Length,
    Theta,
    StartWord,
    EndWord,
    Tangent,
    Normal,
    Advance
  } field_t;

  state_t state_q, state_d;
  field_t field_q, field_d;
  logic        [ 3:0] axis_q;
  logic               request_q;
  logic               started_q;  // the part of this state runs
  logic               last_q;  // the step is the segment's last
  logic               empty_q;
  logic               land_q;
  logic        [49:0] sigma_q;  // offset into the step
  logic        [47:0] rest_q;  // of the segment, from the step's start
  logic        [47:0] length_q;  // of the step
  logic        [47:0] full_q;
  logic signed [49:0] beyond_q;
  logic               equal_q;
  logic        [42:0] shift_q;
  logic        [ 4:0] count_q;

  logic               accept;
  logic               complete;
  logic               network;
  logic               done;
  logic               over;
  assign accept = segment_valid_i && segment_ready_o;
  assign complete = accept && field_q == Advance && axis_q == 4'(Axes - 1);
  assign segment_ready_o = state_q == Open;
  assign request_ready_o = state_q == Ready;
  always_comb begin
    case (state_q)
      Weights, Angle, Step, Expand, Displace: network = 1'b1;
      default: network = 1'b0;
    endcase
  end
  assign net_start_o = network && !started_q;
  assign done = network && started_q && !net_busy_i;
  assign over = !beyond_q[49] && (!equal_q || !last_q);

  // The network's part of this state
  logic [7:0] part;
  logic [7:0] spline_part;
  always_comb begin
    part        = serial_program_pkg::ExpandEntry;
    spline_part = serial_program_pkg::SplineExpandEntry;
    net_order_o = 4'd1;
    case (state_q)
      Weights: begin
        part        = serial_program_pkg::WeightsEntry;
        spline_part = serial_program_pkg::SplineLoadEntry;
        net_order_o = 4'd2;
      end
      Angle:    part = serial_program_pkg::AngleEntry;
      Step: begin
        part        = serial_program_pkg::StepEntry;
        spline_part = serial_program_pkg::SplineStepEntry;
        if (Splines != 0) net_order_o = 4'(Order);  // of sums over all orders
      end
      Displace: spline_part = serial_program_pkg::SplineSeriesEntry;
      default:  ;
    endcase
  end
  assign net_entry_o = spline_o ? spline_part[6+Splines:0] : part[6+Splines:0];

  always_comb begin
    state_d = state_q;
    case (state_q)
      Open: begin
        if (complete && !empty_q) state_d = Weights;
        if (complete && !empty_q && spline_o) state_d = Scale;
      end
      Scale:    if (scale_done) state_d = Weights;
      Weights: begin
        if (done) state_d = Expand;
        if (done && Mode == 1 && !spline_o) state_d = Angle;
      end
      Angle:    if (done) state_d = Expand;
      Step:     if (done) state_d = Expand;
      Expand: begin
        if (done) state_d = Rest;
        if (done && Mode == 0 && spline_o) state_d = Displace;
      end
      Displace: if (done) state_d = Rest;
      Rest:     state_d = Measure;
      Measure: begin
        state_d = Ready;
        if (request_q) state_d = Compare;
      end
      Ready:    if (request_valid_i) state_d = Compare;
      Compare:  state_d = Decide;
      Decide: begin
        state_d = Shift;
        if (over) state_d = Leave;
      end
      Shift:    if (count_q == 5'd0) state_d = Tau;
      Tau:      if (free_i && write_ready_i) state_d = Start;
      Start:    if (sample_take_i) state_d = Ready;
      default: begin
        if (quiet_i) state_d = Step;
        if (quiet_i && last_q) state_d = Open;
      end
    endcase
  end

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
      state_q          <= Open;
      field_q          <= Length;
      axis_q           <= 4'd0;
      request_q        <= 1'b0;
      started_q        <= 1'b0;
      empty_segments_o <= 16'd0;
    end else begin
      state_q   <= state_d;
      started_q <= network && state_d == state_q;
      if (accept) field_q <= field_d;
      if (accept && field_q == Advance) axis_q <= complete ? 4'd0 : axis_q + 4'd1;
      if (complete && empty_q) empty_segments_o <= empty_segments_o + 16'd1;
      if (state_q == Ready) request_q <= request_valid_i;
      if (state_q == Start) request_q <= 1'b0;
    end
  end

  // What only splines have
  logic [         4:0] k_q;
  logic                scale_write;
  logic                scale_done;
  logic [         2:0] scale_place;
  logic [CoefBits-1:0] scale_word;
  if (Splines == 0) begin : g_arcs
    assign spline_o      = 1'b0;
    assign spline_down_o = 5'd0;
    assign scale_write   = 1'b0;
    assign scale_done    = 1'b1;
    assign scale_place   = 3'd0;
    assign scale_word    = '0;
  end else begin : g_splines
    logic [4:0] lambda_q;
    always_ff @(posedge clk_i) begin
      if (accept && field_q == Theta) begin
        spline_o <= segment_data_i[47];
        lambda_q <= segment_data_i[45:41];
      end
      spline_down_o <= 5'(curvecore_pkg::MaxStepExponent) - lambda_q;
    end
    scale_words #(
        .CoefBits(CoefBits)
    ) u_scale (
        .clk_i,
        .run_i   (state_q == Scale),
        .k_i     (k_q),
        .lambda_i(lambda_q),
        .write_o (scale_write),
        .place_o (scale_place),
        .word_o  (scale_word),
        .done_o  (scale_done)
    );
  end

  // Lengths
  logic [ 5:0] full_exponent;
  logic [49:0] ds;
  logic [49:0] length;
  logic [47:0] after;
  logic        fits;
  assign full_exponent = {1'b0, k_q} + 6'(curvecore_pkg::PathFrac);
  assign ds            = {2'b00, request_ds_i};
  assign length        = {2'b00, length_q};
  assign after         = rest_q - full_q;
  assign fits          = rest_q <= full_q;
  always_ff @(posedge clk_i) begin
    if (accept && field_q == Length) begin
      rest_q  <= segment_data_i;
      empty_q <= segment_data_i == 48'd0;
    end
    if (accept && field_q == Theta) k_q <= segment_data_i[40:36];
    down_o <= 5'(curvecore_pkg::MaxStepExponent) - k_q;
    if (state_q == Weights) full_q <= 48'd1 << full_exponent;
    if (state_q == Step && !started_q) rest_q <= after;
    if (state_q == Rest) last_q <= fits;
    if (state_q == Measure) length_q <= last_q ? rest_q : full_q;
    beyond_q <= sigma_q - length;
    equal_q  <= sigma_q == length;
    if (!rst_ni) sigma_q <= '0;
    else if (state_q == Ready && request_valid_i) sigma_q <= sigma_q + ds;
    else if (state_q == Decide && over) sigma_q <= beyond_q;
  end

  // tau = sigma / 2^(k+16), cut
  always_ff @(posedge clk_i) begin
    if (state_q == Decide) begin
      shift_q <= sigma_q[42:0];
      count_q <= down_o;
      land_q  <= equal_q;
    end else if (state_q == Shift) begin
      if (count_q >= 5'd4) begin
        shift_q <= {shift_q[38:0], 4'd0};
        count_q <= count_q - 5'd4;
      end else if (count_q != 5'd0) begin
        shift_q <= {shift_q[41:0], 1'b0};
        count_q <= count_q - 5'd1;
      end
    end
  end
  assign sample_o = state_q == Start;
  assign land_o   = land_q;

  // Rows: normal 0, 2, 4 and tangent 1, 3, 5 (x F y G z H of the table); of splines b and a.
  logic [         2:0] axis_row;
  logic [CoefBits-1:0] tau;
  logic [CoefBits-1:0] bus;
  logic [         7:0] address;
  assign axis_row = {1'b0, axis_q[1:0]};
  assign tau      = {1'b0, shift_q[42:TauLow]};
  assign bus      = segment_data_i[CoefBits-1:0];
  always_comb begin
    write_o      = 1'b0;
    address      = {2'b11, context_i + 2'd1, 4'd3};
    write_data_o = tau;
    if (state_q == Tau) write_o = free_i;
    if (state_q == Scale) begin
      write_o      = scale_write;
      address      = {5'b10111, scale_place};
      write_data_o = scale_word;
    end
    if (state_q == Open) begin
      write_data_o = bus;
      case (field_q)
        Theta:   address = 8'hb7;
        Tangent: address = {axis_row, 1'b1, 4'd0};
        Normal:  address = {axis_row, 1'b0, 4'd0};
        default: address = {4'hc, axis_q};
      endcase
      write_o = accept && field_q != Length && field_q != StartWord && field_q != EndWord;
    end
  end
  assign write_address_o = (8 + Splines)'(address);
  assign write_start_o = accept && field_q == StartWord;
  assign write_end_o = accept && field_q == EndWord;
  assign write_axis_o = axis_q;
  assign write_point_o = segment_data_i[FineBits-1:0];

endmodule
`default_nettype wire
