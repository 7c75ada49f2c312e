// SPDX-License-Identifier: Apache-2.0
// The program of spline_anchor: the time of each operation, in four passes of one clock, or three
// for N, and the places of its operands.
//
//   time_i          t       t+5 .. t+8              t: as in the table below
//   op_o                    the operation, op_axis_o its axis; places of its operands
//   run_o                   1
//   part_o                  0 .. 3                  first_o, drop_o: for folded_sum
//   end_o                              1
`default_nettype none
module anchor_program (
    input  wire logic       clk_i,
    input  wire logic       rst_ni,
    input  wire logic [7:0] time_i,
    output logic      [3:0] op_o,
    output logic      [1:0] op_axis_o,
    output logic            run_o,
    output logic      [1:0] part_o,
    output logic            first_o,
    output logic            drop_o,
    output logic            end_o,
    output logic      [3:0] a_index_o,
    output logic      [2:0] b_index_o
);

  // The program: an operation and its axis.
  function automatic logic [5:0] at(input logic [7:0] now);
    logic [3:0] kind;
    logic [1:0] axis;
    kind = anchor_pkg::Nothing;
    axis = 2'd0;
    case (now)
      8'd4, 8'd8, 8'd12:      kind = anchor_pkg::Mean;
      8'd16, 8'd20, 8'd24:    kind = anchor_pkg::V;
      8'd28, 8'd45, 8'd56:    kind = anchor_pkg::Slope;
      8'd33:                  kind = anchor_pkg::N;
      8'd52:                  kind = anchor_pkg::M;
      8'd63:                  kind = anchor_pkg::Z;
      8'd74:                  kind = anchor_pkg::Phi;
      8'd85:                  kind = anchor_pkg::S;
      8'd96:                  kind = anchor_pkg::Q;
      8'd67, 8'd78, 8'd89:    kind = anchor_pkg::E;
      8'd100, 8'd104, 8'd108: kind = anchor_pkg::F;
      8'd112, 8'd116, 8'd120: kind = anchor_pkg::D;
      default:                ;
    endcase
    case (now)
      8'd8, 8'd20, 8'd45, 8'd78, 8'd104, 8'd116: axis = 2'd1;
      8'd12, 8'd24, 8'd56, 8'd89, 8'd108, 8'd120: axis = 2'd2;
      default: ;
    endcase
    at = {kind, axis};
  endfunction

  // The table is read four clocks ahead, by a time of its own, in two: all eighths, then one.
  logic [7:0] time_q;
  logic [2:0] eighth_q;
  logic [5:0] found_q[8];
  logic [3:0] kind;
  logic [1:0] kind_axis;
  always_ff @(posedge clk_i) begin
    time_q   <= rst_ni ? time_i : 8'd0;
    eighth_q <= time_q[7:5];
  end
  for (genvar e = 0; e < 8; e++) begin : g_eighth
    logic [7:0] now;
    assign now = {3'(e), time_q[4:0]};
    always_ff @(posedge clk_i) found_q[e] <= at(now);
  end
  always_ff @(posedge clk_i) begin
    {kind, kind_axis} <= rst_ni ? found_q[eighth_q] : {anchor_pkg::Nothing, 2'd0};
  end

  // Its four passes, of three clocks for N.
  logic [3:0] op_q;
  logic [1:0] op_axis_q;
  logic       run_q;
  logic [1:0] part_q;
  logic [1:0] pass_q;
  logic       pass_end;
  logic       run_end;
  assign pass_end = op_q != anchor_pkg::N || pass_q == 2'd2;
  assign run_end  = run_q && pass_end && part_q == 2'd3;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) run_q <= 1'b0;
    else if (kind != anchor_pkg::Nothing) run_q <= 1'b1;
    else if (run_end) run_q <= 1'b0;
  end
  always_ff @(posedge clk_i) begin
    if (kind != anchor_pkg::Nothing) begin
      op_q      <= kind;
      op_axis_q <= kind_axis;
      part_q    <= 2'd0;
      pass_q    <= 2'd0;
    end else begin
      pass_q <= pass_end ? 2'd0 : pass_q + 2'd1;
      if (pass_end) part_q <= part_q + 2'd1;
    end
  end

  // The places of the operands.
  logic [3:0] a_index;
  logic [2:0] b_index;
  always_comb begin
    a_index = {2'd2, op_axis_q};
    b_index = 3'd3;
    case (op_q)
      anchor_pkg::Mean, anchor_pkg::Slope: a_index = {2'd0, op_axis_q};
      anchor_pkg::E:                       a_index = {2'd1, op_axis_q};
      anchor_pkg::N: begin
        a_index = {2'd3, pass_q};
        b_index = {1'b0, pass_q};
      end
      anchor_pkg::M:                       a_index = 4'd3;
      anchor_pkg::Z:                       a_index = 4'd7;
      anchor_pkg::Phi, anchor_pkg::Q:      a_index = 4'd11;
      anchor_pkg::S:                       a_index = 4'd15;
      default:                             ;
    endcase
    case (op_q)
      anchor_pkg::M, anchor_pkg::Z, anchor_pkg::Phi, anchor_pkg::S, anchor_pkg::Q: b_index = 3'd7;
      default: ;
    endcase
  end

  always_ff @(posedge clk_i) begin
    run_o     <= run_q;
    op_o      <= op_q;
    op_axis_o <= op_axis_q;
    part_o    <= part_q;
    first_o   <= part_q == 2'd0 && pass_q == 2'd0;
    drop_o    <= part_q[0] && pass_q == 2'd0;
    end_o     <= run_end;
    a_index_o <= a_index;
    b_index_o <= b_index;
  end

endmodule
`default_nettype wire
