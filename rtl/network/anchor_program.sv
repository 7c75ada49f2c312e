// SPDX-License-Identifier: Apache-2.0
// The program of spline_anchor: which operation works when, in four passes of one clock, for N of
// three, and where its operands are.
//
//   time_i          t       t+1 .. t+4              t: two more than the table below has
//   op_o                    the operation, op_axis_o its axis
//   run_o                   1
//   part_o, pass_o          0 .. 3, 0               for folded_sum; pass_o counts N's axes
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
    output logic      [1:0] pass_o,
    output logic            end_o,
    output logic      [3:0] a_index_o,
    output logic      [2:0] b_index_o
);

  // The program: an operation and its axis, two clocks ahead, by a time of its own.
  logic [7:0] time_copy;
  logic [3:0] next;
  logic [1:0] next_axis;
  local_copy #(
      .Bits(8)
  ) u_time (
      .clk_i,
      .data_i(time_i),
      .data_o(time_copy)
  );
  logic [3:0] kind;
  logic [1:0] kind_axis;
  always_comb begin
    next      = anchor_pkg::Nothing;
    next_axis = 2'd0;
    case (time_copy)
      8'd9, 8'd13, 8'd17:     next = anchor_pkg::Mean;
      8'd21, 8'd25, 8'd29:    next = anchor_pkg::V;
      8'd33, 8'd49, 8'd59:    next = anchor_pkg::Slope;
      8'd37:                  next = anchor_pkg::N;
      8'd55:                  next = anchor_pkg::M;
      8'd65:                  next = anchor_pkg::Z;
      8'd75:                  next = anchor_pkg::Phi;
      8'd85:                  next = anchor_pkg::S;
      8'd95:                  next = anchor_pkg::Q;
      8'd69, 8'd79, 8'd89:    next = anchor_pkg::E;
      8'd99, 8'd103, 8'd107:  next = anchor_pkg::F;
      8'd111, 8'd115, 8'd119: next = anchor_pkg::D;
      default:                ;
    endcase
    case (time_copy)
      8'd13, 8'd25, 8'd49, 8'd79, 8'd103, 8'd115: next_axis = 2'd1;
      8'd17, 8'd29, 8'd59, 8'd89, 8'd107, 8'd119: next_axis = 2'd2;
      default: ;
    endcase
  end

  always_ff @(posedge clk_i) begin
    kind      <= rst_ni ? next : anchor_pkg::Nothing;
    kind_axis <= next_axis;
  end

  // Its four passes, of three clocks for N.
  logic pass_end;
  assign pass_end = op_o != anchor_pkg::N || pass_o == 2'd2;
  assign end_o = run_o && pass_end && part_o == 2'd3;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) run_o <= 1'b0;
    else if (kind != anchor_pkg::Nothing) run_o <= 1'b1;
    else if (end_o) run_o <= 1'b0;
  end
  always_ff @(posedge clk_i) begin
    if (kind != anchor_pkg::Nothing) begin
      op_o      <= kind;
      op_axis_o <= kind_axis;
      part_o    <= 2'd0;
      pass_o    <= 2'd0;
    end else begin
      pass_o <= pass_end ? 2'd0 : pass_o + 2'd1;
      if (pass_end) part_o <= part_o + 2'd1;
    end
  end

  always_comb begin
    a_index_o = {2'd2, op_axis_o};
    b_index_o = 3'd3;
    case (op_o)
      anchor_pkg::Mean, anchor_pkg::Slope: a_index_o = {2'd0, op_axis_o};
      anchor_pkg::E:                       a_index_o = {2'd1, op_axis_o};
      anchor_pkg::N: begin
        a_index_o = {2'd3, pass_o};
        b_index_o = {1'b0, pass_o};
      end
      anchor_pkg::M:                       a_index_o = 4'd3;
      anchor_pkg::Z:                       a_index_o = 4'd7;
      anchor_pkg::Phi, anchor_pkg::Q:      a_index_o = 4'd11;
      anchor_pkg::S:                       a_index_o = 4'd15;
      default:                             ;
    endcase
    case (op_o)
      anchor_pkg::M, anchor_pkg::Z, anchor_pkg::Phi, anchor_pkg::S, anchor_pkg::Q: b_index_o = 3'd7;
      default: ;
    endcase
  end

endmodule
`default_nettype wire
