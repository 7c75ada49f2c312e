// SPDX-License-Identifier: Apache-2.0
// Positions along lines, arcs and helices in space, with Splines also along cubics, on one
// multiplier: the serial build of rtl/curve_interpolator.sv, the same ports and the same bits
// ([Chikurov] Figs. 8 and 10).  Twins: hls/interpolator_kernel.hpp with ArcCurve, with
// Splines CurveKernel (hls/curve_kernel.hpp): every step is anchored, Anchor 0 is not built.
//
//   segment words, requests -> tracker -> sequencer and program -> datapath -> lander -> samples
//
// The networks are programs (serial/serial_program.sv, from ref/series/figures.hpp and
// serial/spline_program.hpp) for one multiplier and one word memory.  Up to three samples are under
// way at a time.
//
//   clocks at most, of Order 6 without        arcs, series    splines, polynomial
//   auxiliary axes; of any: hls/clocks.hpp
//   between samples of a step, on average     21              30
//   from a step's last sample to the first    219             579
//   of the next step
//   the same of the next segment, if its      273             609
//   words come without a pause
//
// One multiplier does the network's work and the samples': a change of step waits for the samples
// under way, and a segment's words are taken when the path has left the segment before.  Three
// samples that are not taken yet are held, while requests wait.
//
// The program's constants come with the device's configuration (serial/word_memory.sv), so memories
// must be initialised.
//
// SampleInterval has no effect: it belongs to the common interface.  Formats: hls/words.hpp; a
// segment's kind counts with Splines only.
`default_nettype none
module curve_interpolator_serial #(
    parameter int Order          = 6,   // [2, 12]
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int PositionBits   = 32,  // [16, 32]
    parameter int GuardBits      = 10,  // [2, 12]
    parameter int AuxAxes        = 0,   // [0, 6]
    parameter int Mode           = 0,   // 0 series, 1 polynomial
    parameter int SampleInterval = 1,   // 1, 2, 4, 8
    parameter int MultiplierForm = 0,   // 0 portable, 1 ECP5, 2 UP5K
    parameter int Splines        = 0    // 1: cubics as well
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Segments, 17 + 3 AuxAxes words each
    input  wire logic        segment_valid_i,
    output logic             segment_ready_o,
    input  wire logic [47:0] segment_data_i,

    // Path increments
    input  wire logic        request_valid_i,
    output logic             request_ready_o,
    input  wire logic [47:0] request_ds_i,

    // Samples, axis 0 in the low bits
    output logic                                                 sample_valid_o,
    input  wire logic                                            sample_ready_i,
    output logic      [            (3+AuxAxes)*PositionBits-1:0] sample_position_o,
    output logic      [(3+AuxAxes)*(PositionBits+GuardBits)-1:0] sample_fine_o,

    output logic [15:0] empty_segments_o
);

  initial if (Order < 2 || Order > 12) $fatal(1, "Order must be in [2, 12]");
  initial if (CoefBits < 18 || CoefBits > 36) $fatal(1, "CoefBits must be in [18, 36]");
  initial if (PositionBits < 16 || PositionBits > 32) $fatal(1, "PositionBits must be in [16, 32]");
  initial if (GuardBits < 2 || GuardBits > 12) $fatal(1, "GuardBits must be in [2, 12]");
  initial if (AuxAxes < 0 || AuxAxes > 6) $fatal(1, "AuxAxes must be in [0, 6]");
  initial if (Mode < 0 || Mode > 1) $fatal(1, "Mode must be 0 or 1");
  initial
    if (MultiplierForm < 0 || MultiplierForm > 2) $fatal(1, "MultiplierForm must be in [0, 2]");
  initial
    if (SampleInterval != 1 && SampleInterval != 2 && SampleInterval != 4 && SampleInterval != 8)
      $fatal(1, "SampleInterval must be 1, 2, 4 or 8");

  initial if (Splines < 0 || Splines > 1) $fatal(1, "Splines must be 0 or 1");

  localparam int FineBits = PositionBits + GuardBits;

  logic rst_n;
  reset_stretcher u_reset (
      .clk_i,
      .rst_ni,
      .rst_no(rst_n)
  );
  logic segment_ready;
  logic request_ready;
  assign segment_ready_o = segment_ready && rst_n;
  assign request_ready_o = request_ready && rst_n;

  logic                write;
  logic                write_ready;
  logic [ 7+Splines:0] write_address;
  logic [CoefBits-1:0] write_data;
  logic                write_start;
  logic                write_end;
  logic [         3:0] write_axis;
  logic [FineBits-1:0] write_point;
  logic [         4:0] down;
  logic [         4:0] spline_down;
  logic                spline;
  logic                net_start;
  logic [ 6+Splines:0] net_entry;
  logic [         3:0] net_order;
  logic                net_busy;
  logic                sample;
  logic                land;
  logic                sample_take;
  logic [         1:0] free_context;
  logic                free;
  logic                quiet;
  serial_tracker #(
      .Order(Order),
      .CoefBits(CoefBits),
      .FineBits(FineBits),
      .AuxAxes(AuxAxes),
      .Mode(Mode),
      .Splines(Splines)
  ) u_tracker (
      .clk_i,
      .rst_ni(rst_n),
      .segment_valid_i,
      .segment_ready_o(segment_ready),
      .segment_data_i,
      .empty_segments_o,
      .request_valid_i,
      .request_ready_o(request_ready),
      .request_ds_i,
      .write_o(write),
      .write_ready_i(write_ready),
      .write_address_o(write_address),
      .write_data_o(write_data),
      .write_start_o(write_start),
      .write_end_o(write_end),
      .write_axis_o(write_axis),
      .write_point_o(write_point),
      .down_o(down),
      .spline_down_o(spline_down),
      .spline_o(spline),
      .net_start_o(net_start),
      .net_entry_o(net_entry),
      .net_order_o(net_order),
      .net_busy_i(net_busy),
      .sample_o(sample),
      .land_o(land),
      .sample_take_i(sample_take),
      .context_i(free_context),
      .free_i(free),
      .quiet_i(quiet)
  );

  // Samples issued and not taken: two on their way and one at the output, or one more that the last
  // rotation has issued.
  logic       issued;
  logic       taken;
  logic [2:0] held_q;
  always_ff @(posedge clk_i) begin
    if (!rst_n) held_q <= 3'd0;
    else if (issued && !taken) held_q <= held_q + 3'd1;
    else if (taken && !issued) held_q <= held_q - 3'd1;
  end

  logic [7+Splines:0] a_address;
  logic [7+Splines:0] b_address;
  logic [7+Splines:0] c_address;
  logic [7+Splines:0] d_address;
  logic [        2:0] scale;
  logic               first;
  logic               more;
  logic [        1:0] target;
  serial_sequencer #(
      .Order(Order),
      .AuxAxes(AuxAxes),
      .Mode(Mode),
      .Splines(Splines)
  ) u_sequencer (
      .clk_i,
      .rst_ni(rst_n),
      .net_start_i(net_start),
      .net_entry_i(net_entry),
      .net_order_i(net_order),
      .net_busy_o(net_busy),
      .spline_i(spline),
      .sample_i(sample),
      .land_i(land),
      .sample_take_o(sample_take),
      .context_o(free_context),
      .free_o(free),
      .room_i(held_q < 3'd3),
      .issued_o(issued),
      .quiet_o(quiet),
      .a_address_o(a_address),
      .b_address_o(b_address),
      .c_address_o(c_address),
      .d_address_o(d_address),
      .scale_o(scale),
      .first_o(first),
      .more_o(more),
      .target_o(target)
  );

  logic        [         1:0] d_target;
  logic        [ 7+Splines:0] d_place;
  logic signed [CoefBits-1:0] d;
  folded_datapath #(
      .CoefBits(CoefBits),
      .Splines(Splines),
      .MultiplierForm(MultiplierForm)
  ) u_datapath (
      .clk_i,
      .rst_ni(rst_n),
      .a_address_i(a_address),
      .b_address_i(b_address),
      .c_address_i(c_address),
      .d_address_i(d_address),
      .scale_i(scale),
      .first_i(first),
      .more_i(more),
      .target_i(target),
      .external_i(write),
      .external_ready_o(write_ready),
      .external_address_i(write_address),
      .external_data_i(write_data),
      .target_o(d_target),
      .d_address_o(d_place),
      .d_o(d)
  );

  serial_lander #(
      .CoefBits(CoefBits),
      .PositionBits(PositionBits),
      .GuardBits(GuardBits),
      .AuxAxes(AuxAxes),
      .Splines(Splines)
  ) u_lander (
      .clk_i,
      .rst_ni(rst_n),
      .write_start_i(write_start),
      .write_end_i(write_end),
      .write_axis_i(write_axis),
      .write_data_i(write_point),
      .spline_i(spline),
      .down_i(down),
      .spline_down_i(spline_down),
      .target_i(d_target),
      .axis_i(d_place[3:0]),
      .d_i(d),
      .land_i(d_place[7] && d_target == 2'd2),
      .sample_valid_o,
      .sample_ready_i,
      .sample_position_o,
      .sample_fine_o,
      .taken_o(taken)
  );

endmodule
`default_nettype wire
