// SPDX-License-Identifier: Apache-2.0
// rtl/serial/serial_sequencer.sv, u_dut, and its surroundings in a core, in all possible
// behaviours: the tracker (rtl/serial/serial_tracker.sv) and the lander's room
// (rtl/curve_interpolator_serial.sv).
//
//   part      after the samples when all is quiet; a clock or more after the part before, six if it
//             is the first of a segment or of a step (0, 2); 6, of splines alone and only behind 2,
//             is that of rtl/serial/folded_steps.sv
//   sample    six clocks or more after a part, or five after the last one that was taken, when its
//             tau may be written; it stays until it is taken
//   spline    changes when nothing is under way; a part comes before the next sample
//   room      for a sample on its way and one at the output
`default_nettype none
module serial_environment #(
    parameter int Order   = 6,
    parameter int AuxAxes = 0,
    parameter int Mode    = 0,
    parameter int Splines = 1
) (
    input wire logic       clk_i,
    input wire logic       rst_ni,
    input wire logic [2:0] act_i,   // 0 .. 3, 6 a part; 4 a sample; 5 other segments; 7 nothing
    input wire logic       land_i,
    input wire logic       take_i,  // a sample by the user, if one is there

    output logic       net_start_o,
    output logic       net_busy_o,
    output logic       spline_o,
    output logic       sample_o,
    output logic       sample_take_o,
    output logic [1:0] context_o,
    output logic       free_o,
    output logic       quiet_o,
    output logic       issued_o,
    output logic [1:0] held_o,

    output logic [7+Splines:0] a_address_o,
    output logic [7+Splines:0] b_address_o,
    output logic [7+Splines:0] c_address_o,
    output logic [7+Splines:0] d_address_o,
    output logic               more_o,
    output logic [        1:0] target_o
);

  logic [6+Splines:0] net_entry;
  logic [        3:0] net_order;
  serial_sequencer #(
      .Order(Order),
      .AuxAxes(AuxAxes),
      .Mode(Mode),
      .Splines(Splines)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .net_start_i(net_start_o),
      .net_entry_i(net_entry),
      .net_order_i(net_order),
      .net_busy_o,
      .spline_i(spline_o),
      .sample_i(sample_o),
      .land_i,
      .sample_take_o,
      .context_o,
      .free_o,
      .room_i(!held_o[1]),
      .issued_o,
      .quiet_o,
      .a_address_o,
      .b_address_o,
      .c_address_o,
      .d_address_o,
      .scale_o(),
      .first_o(),
      .more_o,
      .target_o
  );

  logic       busy_q;
  logic       ran_q;  // a part, for segments of this kind
  logic       sampled_q;  // since the last part
  logic       stepped_q;  // the last part was 2
  logic [2:0] rest_q;
  logic       rests;
  logic       between;
  logic       keeps;
  assign rests       = rest_q != 3'd0;
  assign keeps       = act_i == 3'd6 && spline_o && stepped_q;
  assign between     = !net_busy_o && !busy_q && !sample_o && (quiet_o || !sampled_q);
  assign net_start_o = between && ((act_i <= 3'd3 && (act_i[0] || !rests)) || keeps);

  logic [7:0] part;
  logic [7:0] spline_part;
  assign net_entry = spline_o ? spline_part[6+Splines:0] : part[6+Splines:0];
  always_comb begin
    net_order   = 4'd1;
    part        = serial_program_pkg::ExpandEntry;
    spline_part = serial_program_pkg::SplineExpandEntry;
    case (act_i)
      3'd0: begin
        part        = serial_program_pkg::WeightsEntry;
        spline_part = serial_program_pkg::SplineLoadEntry;
        net_order   = 4'd2;
      end
      3'd1: begin
        part        = serial_program_pkg::AngleEntry;
        spline_part = serial_program_pkg::SplineSeriesEntry;
      end
      3'd2: begin
        part        = serial_program_pkg::StepEntry;
        spline_part = serial_program_pkg::SplineStepEntry;
        if (Splines != 0) net_order = 4'(Order);
      end
      3'd6:    spline_part = serial_program_pkg::SplineKeepEntry;
      default: ;
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      busy_q    <= 1'b0;
      ran_q     <= 1'b0;
      sampled_q <= 1'b0;
      stepped_q <= 1'b0;
      rest_q    <= 3'd0;
      spline_o  <= 1'b0;
      sample_o  <= 1'b0;
      held_o    <= 2'd0;
    end else begin
      busy_q <= net_busy_o;
      if (net_start_o) ran_q <= 1'b1;
      if (net_start_o) stepped_q <= act_i == 3'd2;
      if (between && act_i == 3'd5) begin
        ran_q    <= 1'b0;
        spline_o <= Splines != 0 && !spline_o;
      end
      if (sample_take_o) sampled_q <= 1'b1;
      else if (net_start_o) sampled_q <= 1'b0;

      if (net_busy_o || net_start_o) rest_q <= 3'd6;
      else if (sample_take_o) rest_q <= 3'd4;
      else if (rests) rest_q <= rest_q - 3'd1;
      if (sample_take_o) sample_o <= 1'b0;
      else if (act_i == 3'd4 && ran_q && !rests && free_o) sample_o <= 1'b1;

      held_o <= held_o + {1'b0, issued_o} - {1'b0, take_i && held_o != 2'd0};
    end
  end

endmodule
`default_nettype wire
