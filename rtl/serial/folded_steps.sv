// SPDX-License-Identifier: Apache-2.0
// Integration steps of either kind by the networks' program on one multiplier, word by word those
// of rtl/network/curve_steps.sv, which has the same ports.  The parts of the program are the serial
// build's (serial/serial_program.sv); every step is anchored.
//
//   segment words -> segment, points -> sequencer and program -> datapath -> words for the banks
//
// A segment's words are taken when the steps of the one before are made, and a step begins when
// its bank is free.  Clocks of a step, and of the first of a segment: hls/clocks.hpp.
//
// Segments of a kind not in Curves are drawn as the other kind.
`default_nettype none
module folded_steps #(
    parameter int Curves         = 3,   // 1 lines and arcs, 2 splines, 3 both
    parameter int Order          = 6,   // [2, 12]
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int FineBits       = 42,  // [18, 44]
    parameter int GuardBits      = 10,  // [2, 12]
    parameter int AuxAxes        = 0,   // [0, 6]
    parameter int Mode           = 0,   // 0 series, 1 polynomial
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Segments, 17 + 3 AuxAxes words each
    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic [47:0] segment_data_i,
    output logic      [15:0] empty_segments_o,

    // Steps into banks: with done_o the words of step bank_i are there, and the next five outputs
    // are the step's
    input  wire logic                               room_i,
    input  wire logic [                        1:0] bank_i,
    output logic                                    done_o,
    output logic                                    last_o,
    output logic      [                        4:0] k_o,
    output logic      [curvecore_pkg::StepBits-1:0] offset_o,
    output logic      [  curvecore_pkg::StepBits:0] stride_o,

    // Outputs to the banks of the rates {there, axis, rate}, of the points {there, axis, end,
    // origin}, of the samplers of arcs and of splines (rtl/sampler/bank_pkg.sv)
    output logic [                CoefBits+4:0] rate_o,
    output logic [              2*FineBits+4:0] point_o,
    output logic [          bank_pkg::Bits-1:0] arc_write_o,
    output logic [bank_pkg::Lanes*CoefBits-1:0] arc_words_o,
    output logic [          bank_pkg::Bits-1:0] spline_write_o,
    output logic [bank_pkg::Lanes*CoefBits-1:0] spline_words_o
);

  localparam int Splines = (Curves == 1) ? 0 : 1;
  localparam int AddressBits = 8 + Splines;

  // Points are sent in three clocks an axis, and two more; the last word needs ten.
  localparam logic [4:0] LastSend = 5'(3 * (3 + AuxAxes) + 1);

  typedef enum logic [3:0] {
    Open,
    Begin,
    Step,
    Keep,
    Angle,
    Expand,
    Series,
    Send,
    Wait
  } state_t;
  state_t state_q, state_d;
  logic started_q;  // the part of this state runs
  logic open_q;  // words are taken
  logic spline;
  logic there;
  logic network;
  logic done;
  logic net_busy;
  logic sent;
  always_comb begin
    case (state_q)
      Begin, Step, Keep, Angle, Expand, Series: network = 1'b1;
      default: network = 1'b0;
    endcase
  end
  assign done   = network && started_q && !net_busy;
  assign done_o = state_q == Send && sent;

  always_comb begin
    state_d = state_q;
    case (state_q)
      Open:    if (there) state_d = Begin;
      Begin: begin
        if (done) state_d = Expand;
        if (done && Mode == 1 && !spline) state_d = Angle;
      end
      Step: begin
        if (done) state_d = Expand;
        if (done && Mode == 1) state_d = Angle;
        if (done && Mode == 1 && spline) state_d = Keep;
      end
      Keep:    if (done) state_d = Expand;
      Angle:   if (done) state_d = Expand;
      Expand: begin
        if (done) state_d = Send;
        if (done && Mode == 0 && spline) state_d = Series;
      end
      Series:  if (done) state_d = Send;
      Send: begin
        if (sent) state_d = Wait;
        if (sent && last_o) state_d = Open;
      end
      default: if (room_i) state_d = Step;
    endcase
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q   <= Open;
      started_q <= 1'b0;
      open_q    <= 1'b1;
    end else begin
      open_q    <= state_q == Open && room_i && !there;
      state_q   <= state_d;
      started_q <= network && state_d == state_q;
    end
  end

  // The program's part in this state
  logic [7:0] part;
  logic [7:0] spline_part;
  logic [3:0] net_order;
  logic [7:0] net_entry;
  always_comb begin
    part        = serial_program_pkg::ExpandEntry;
    spline_part = serial_program_pkg::SplineExpandEntry;
    net_order   = 4'd1;
    case (state_q)
      Begin: begin
        part        = serial_program_pkg::WeightsEntry;
        spline_part = serial_program_pkg::SplineLoadEntry;
        net_order   = 4'd2;
      end
      Step: begin
        part        = serial_program_pkg::StepEntry;
        spline_part = serial_program_pkg::SplineStepEntry;
        net_order   = 4'(Order);  // the order of sums over all orders
      end
      Keep:    spline_part = serial_program_pkg::SplineKeepEntry;
      Angle:   part = serial_program_pkg::AngleEntry;
      Series:  spline_part = serial_program_pkg::SplineSeriesEntry;
      default: ;
    endcase
  end
  assign net_entry = spline ? spline_part : part;

  logic                length;
  logic                segment_spline;
  logic [         4:0] down;
  logic [         4:0] spline_down;
  logic                load;
  logic                load_ready;
  logic [         7:0] load_address;
  logic [CoefBits-1:0] load_data;
  logic                write_start;
  logic                write_end;
  logic [         3:0] write_axis;
  logic [FineBits-1:0] unused_point;
  serial_segment #(
      .CoefBits(CoefBits),
      .FineBits(FineBits),
      .AuxAxes (AuxAxes),
      .Splines ((Curves == 2) ? 2 : Splines)
  ) u_segment (
      .clk_i,
      .rst_ni,
      .open_i(open_q),
      .segment_valid_i,
      .segment_ready_o,
      .segment_data_i,
      .length_o(length),
      .there_o(there),
      .empty_segments_o,
      .k_o,
      .down_o(down),
      .spline_o(segment_spline),
      .spline_down_o(spline_down),
      .write_o(load),
      .write_address_o(load_address),
      .write_data_o(load_data),
      .write_start_o(write_start),
      .write_end_o(write_end),
      .write_axis_o(write_axis),
      .write_point_o(unused_point)
  );
  assign spline = (Splines != 0) && segment_spline;

  logic [47:0] length_q;
  always_ff @(posedge clk_i) begin
    if (length) length_q <= {4'd0, segment_data_i[43:0]};
  end
  step_meter u_meter (
      .clk_i,
      .rst_ni,
      .load_i(state_q == Open && there),
      .length_i(length_q),
      .k_i(k_o),
      .next_i(state_q == Wait && room_i),
      .last_o,
      .offset_o,
      .stride_o
  );

  logic [AddressBits-1:0] a_address;
  logic [AddressBits-1:0] b_address;
  logic [AddressBits-1:0] c_address;
  logic [AddressBits-1:0] d_address;
  logic [            2:0] scale;
  logic                   first;
  logic                   more;
  logic [            1:0] target;
  logic unused_take, unused_free, unused_issued, unused_quiet;
  logic [1:0] unused_context;
  serial_sequencer #(
      .Order(Order),
      .AuxAxes(AuxAxes),
      .Mode(Mode),
      .Splines(Splines),
      .Samples(0)
  ) u_sequencer (
      .clk_i,
      .rst_ni,
      .net_start_i(network && !started_q),
      .net_entry_i(net_entry[AddressBits-2:0]),
      .net_order_i(net_order),
      .net_busy_o(net_busy),
      .spline_i(spline),
      .sample_i(1'b0),
      .land_i(1'b0),
      .sample_take_o(unused_take),
      .context_o(unused_context),
      .free_o(unused_free),
      .room_i(1'b0),
      .issued_o(unused_issued),
      .quiet_o(unused_quiet),
      .a_address_o(a_address),
      .b_address_o(b_address),
      .c_address_o(c_address),
      .d_address_o(d_address),
      .scale_o(scale),
      .first_o(first),
      .more_o(more),
      .target_o(target)
  );

  logic        [            1:0] d_target;
  logic        [AddressBits-1:0] d_place;
  logic signed [   CoefBits-1:0] d;
  folded_datapath #(
      .CoefBits(CoefBits),
      .Splines(Splines),
      .MultiplierForm(MultiplierForm)
  ) u_datapath (
      .clk_i,
      .rst_ni,
      .a_address_i(a_address),
      .b_address_i(b_address),
      .c_address_i(c_address),
      .d_address_i(d_address),
      .scale_i(scale),
      .first_i(first),
      .more_i(more),
      .target_i(target),
      .external_i(load),
      .external_ready_o(load_ready),
      .external_address_i(AddressBits'(load_address)),
      .external_data_i(load_data),
      .target_o(d_target),
      .d_address_o(d_place),
      .d_o(d)
  );

  // What is written to the word memory goes to the step's bank as well.
  logic [AddressBits-1:0] place;
  assign place = load_ready ? AddressBits'(load_address) : d_place;
  step_words #(
      .Curves(Curves),
      .Order(Order),
      .CoefBits(CoefBits),
      .Mode(Mode)
  ) u_words (
      .clk_i,
      .rst_ni,
      .spline_i(spline),
      .bank_i,
      .write_i(load || !load_ready),
      .address_i(9'(place)),
      .word_i(load_ready ? load_data : d),
      .arc_write_o,
      .spline_write_o,
      .words_o(arc_words_o)
  );
  assign spline_words_o = arc_words_o;

  logic [4:0] send_q;  // clocks
  logic [3:0] axis_q;
  logic [1:0] what_q;
  logic       sends;
  assign sends = state_q == Send && axis_q != 4'(3 + AuxAxes);
  assign sent  = send_q == LastSend;
  always_ff @(posedge clk_i) begin
    send_q <= (state_q == Send) ? send_q + 5'd1 : 5'd0;
    if (state_q != Send) begin
      axis_q <= 4'd0;
      what_q <= 2'd0;
    end else if (sends) begin
      axis_q <= (what_q == 2'd2) ? axis_q + 4'd1 : axis_q;
      what_q <= (what_q == 2'd2) ? 2'd0 : what_q + 2'd1;
    end
  end
  logic rate;
  assign rate = load && load_address[7:4] == 4'hc;
  step_points #(
      .CoefBits (CoefBits),
      .FineBits (FineBits),
      .GuardBits(GuardBits),
      .Splines  (Splines)
  ) u_points (
      .clk_i,
      .rst_ni,
      .write_i(write_start || write_end || rate),
      .write_what_i({rate, write_end}),
      .write_axis_i(write_axis),
      .write_data_i(segment_data_i),
      .spline_i(spline),
      .down_i(down),
      .spline_down_i(spline_down),
      .move_i(d_target == 2'd3),
      .send_i(sends),
      .what_i(what_q),
      .axis_i(sends ? axis_q : d_place[3:0]),
      .d_i(d),
      .rate_o,
      .point_o
  );

endmodule
`default_nettype wire
