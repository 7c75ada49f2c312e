// SPDX-License-Identifier: Apache-2.0
// The program of spline_anchor: which operation works when, in four passes of one clock, for N of
// three, and where its operands are.
//
//   time_i          t       t+1 .. t+4              t: as the table below has it
//   op_o                    the operation, op_axis_o its axis
//   run_o                   1
//   part_o, pass_o          0 .. 3, 0               as folded_sum wants them; pass_o: N's axes
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

  // The program: an operation and its axis by the time before its first clock.
  logic [3:0] kind;
  logic [1:0] kind_axis;
  always_comb begin
    kind      = anchor_pkg::Nothing;
    kind_axis = 2'd0;
    case (time_i)
      8'd11, 8'd15, 8'd19:    kind = anchor_pkg::Mean;
      8'd23, 8'd27, 8'd31:    kind = anchor_pkg::V;
      8'd35, 8'd51, 8'd61:    kind = anchor_pkg::Slope;
      8'd39:                  kind = anchor_pkg::N;
      8'd57:                  kind = anchor_pkg::M;
      8'd67:                  kind = anchor_pkg::Z;
      8'd77:                  kind = anchor_pkg::Phi;
      8'd87:                  kind = anchor_pkg::S;
      8'd97:                  kind = anchor_pkg::Q;
      8'd71, 8'd81, 8'd91:    kind = anchor_pkg::E;
      8'd101, 8'd105, 8'd109: kind = anchor_pkg::F;
      8'd113, 8'd117, 8'd121: kind = anchor_pkg::D;
      default:                ;
    endcase
    case (time_i)
      8'd15, 8'd27, 8'd51, 8'd81, 8'd105, 8'd117: kind_axis = 2'd1;
      8'd19, 8'd31, 8'd61, 8'd91, 8'd109, 8'd121: kind_axis = 2'd2;
      default: ;
    endcase
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
