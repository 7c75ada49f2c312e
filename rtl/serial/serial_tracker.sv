// SPDX-License-Identifier: Apache-2.0
// Follows the path of the serial build: takes segments, runs the network for each step, and turns a
// request into tau (hls/interpolator_kernel.hpp).  A segment is taken when the path leaves the last
// one.
//
//   clocks                             value
//   request to tau                     3 + the quarter and single shifts of 27 - k
//   segment                            17 + 3 AuxAxes words, one a clock, then Weights, Expand
//   step                               when the samples under way are over: Step, Expand
//   of a spline                        the same, and 9 for its scales (serial_segment.sv)
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

  localparam int TauLow = 43 - (CoefBits - 1);

  typedef enum logic [3:0] {
    Open,
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
  state_t state_q, state_d;
  logic        request_q;
  logic        started_q;  // the part of this state runs
  logic        last_q;  // the step is the segment's last
  logic        land_q;
  logic [49:0] sigma_q;  // offset into the step
  logic [43:0] rest_q;  // rest of the segment, from the step's start
  logic [43:0] length_q;  // length of the step
  logic [27:0] full_q;  // length of other steps, without its PathFrac bits
  logic        before_q;  // its end
  logic        equal_q;
  logic [42:0] shift_q;
  logic [ 4:0] count_q;

  logic        opening;
  logic        there;
  logic        network;
  logic        done;
  logic        over;
  assign request_ready_o = state_q == Ready;
  always_comb begin
    case (state_q)
      Weights, Angle, Step, Expand, Displace: network = 1'b1;
      default: network = 1'b0;
    endcase
  end
  assign net_start_o = network && !started_q;
  assign done = network && started_q && !net_busy_i;
  assign over = !before_q && (!equal_q || !last_q);

  // The network's part in this state
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
        if (Splines != 0) net_order_o = 4'(Order);  // the order of sums over all orders
      end
      Displace: spline_part = serial_program_pkg::SplineSeriesEntry;
      default:  ;
    endcase
  end
  assign net_entry_o = spline_o ? spline_part[6+Splines:0] : part[6+Splines:0];

  always_comb begin
    state_d = state_q;
    case (state_q)
      Open:     if (there) state_d = Weights;
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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q   <= Open;
      request_q <= 1'b0;
      started_q <= 1'b0;
    end else begin
      state_q   <= state_d;
      started_q <= network && state_d == state_q;
      if (state_q == Ready) request_q <= request_valid_i;
      if (state_q == Start) request_q <= 1'b0;
    end
  end

  logic [         4:0] k;
  logic                load;
  logic [         7:0] load_address;
  logic [CoefBits-1:0] load_data;
  serial_segment #(
      .CoefBits(CoefBits),
      .FineBits(FineBits),
      .AuxAxes (AuxAxes),
      .Splines (Splines)
  ) u_segment (
      .clk_i,
      .rst_ni,
      .open_i(state_q == Open),
      .segment_valid_i,
      .segment_ready_o,
      .segment_data_i,
      .length_o(opening),
      .there_o(there),
      .empty_segments_o,
      .k_o(k),
      .down_o,
      .spline_o,
      .spline_down_o,
      .write_o(load),
      .write_address_o(load_address),
      .write_data_o(load_data),
      .write_start_o,
      .write_end_o,
      .write_axis_o,
      .write_point_o
  );

  // Lengths: the fraction bits of a full step are 0.
  logic [28:0] after;
  logic        no_fraction;
  logic        fits;
  assign after       = {1'b0, rest_q[43:16]} - {1'b0, full_q};
  assign no_fraction = rest_q[15:0] == '0;
  assign fits        = after[28] || (after == '0 && no_fraction);
  always_ff @(posedge clk_i) begin
    if (opening) rest_q <= segment_data_i[43:0];
    if (state_q == Weights) full_q <= 28'd1 << k;
    if (state_q == Step && !started_q) rest_q[43:16] <= after[27:0];
    if (state_q == Rest) last_q <= fits;
    if (state_q == Measure) length_q <= last_q ? rest_q : {full_q, 16'd0};
  end

  // One sum: with the request's ds, or less the length.
  logic        takes;
  logic [49:0] length;
  logic [49:0] operand;
  logic [50:0] augend;
  logic [50:0] addend;
  logic [50:0] sum;
  assign takes   = state_q == Ready;
  assign length  = {6'd0, length_q};
  assign operand = takes ? {2'b00, request_ds_i} : ~length;
  assign augend  = {sigma_q, 1'b1};
  assign addend  = {operand, !takes};
  assign sum    = augend + addend;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) sigma_q <= '0;
    else if (takes && request_valid_i) sigma_q <= sum[50:1];
    else if (state_q == Decide && over) sigma_q <= sum[50:1];
    before_q <= sum[50];
    equal_q  <= sigma_q == length;
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

  logic [7:0] address;
  always_comb begin
    write_o      = load;
    address      = load_address;
    write_data_o = load_data;
    if (state_q == Tau) begin
      write_o      = free_i;
      address      = {2'b11, context_i + 2'd1, 4'd3};
      write_data_o = {1'b0, shift_q[42:TauLow]};
    end
  end
  assign write_address_o = (8 + Splines)'(address);

endmodule
`default_nettype wire
