// SPDX-License-Identifier: Apache-2.0
// Tracker of the step in which a sample lies.  Twin: hls/interpolator_kernel.hpp.
//
// The path since reset is summed modulo 2^50; a step reaches as far as its `reach`.  The rests of
// the present step and of the next are computed side by side, and the first that is not negative
// selects the step.  All but that choice is a pipeline:
//
//   slot       0           1              2                     3             4
//              request_*   path + ds      reach - path          choice        sample_o, step_o,
//                                         next reach - path                   left_o
//
// One switch costs nothing.  A sample further on, or one whose next step is not ready, is tried
// again, two slots a time, each a step farther (Again, Try; then Refill behind it).
//
// Everything moves in slots (slot_i).  request_ready_o does not depend on request_valid_i.
`default_nettype none
module step_tracker (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic slot_i,

    input  wire logic        request_valid_i,
    output logic             request_ready_o,
    input  wire logic [47:0] request_ds_i,

    // The step after step_o
    input wire logic                             next_valid_i,
    input wire logic [curvecore_pkg::StepBits:0] next_stride_i,

    output logic                               token_o,
    output logic                               sample_o,
    output logic [                        2:0] step_o,
    output logic [curvecore_pkg::StepBits-1:0] left_o
);

  localparam int Bits = 50;
  localparam int StrideBits = curvecore_pkg::StepBits + 1;

  typedef enum logic [1:0] {
    Run,
    Again,
    Try,
    Refill
  } state_t;
  state_t            state_q;

  // Sum, then two places: the sample that is compared, and the one whose choice is due.
  logic              sum_valid_q;
  logic              path_valid_q;
  logic              tried_valid_q;
  logic   [Bits-1:0] sum_q;
  logic   [Bits-1:0] path_q;
  logic   [Bits-1:0] tried_q;

  logic   [Bits-1:0] reach_q;  // reach of the present step
  logic   [Bits-1:0] next_reach_q;
  logic              next_known_q;

  // Rests relative to the step that was present then: a later switch shifts them.
  logic   [Bits-1:0] left_q;
  logic   [Bits-1:0] next_left_q;
  logic              next_left_known_q;
  logic              shifted_q;

  logic              choose;
  logic              fits;
  logic              fits_next;
  logic              stay;
  logic              go;
  logic              fail;
  logic              skip;
  assign choose    = (state_q == Run && tried_valid_q) || state_q == Try;
  assign fits      = !left_q[Bits-1];
  assign fits_next = next_left_known_q && !next_left_q[Bits-1];
  assign stay      = shifted_q ? fits_next : fits;
  assign go        = choose && !stay && !shifted_q && fits_next;
  assign fail      = choose && !stay && !go;
  assign skip      = fail && !shifted_q && next_left_known_q;

  logic flow;
  logic swap;
  assign flow            = (state_q == Run && !fail) || state_q == Refill;
  assign swap            = (state_q == Run && fail) || (state_q == Try && !fail);
  assign request_ready_o = slot_i && flow;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q       <= Run;
      sum_valid_q   <= 1'b0;
      path_valid_q  <= 1'b0;
      tried_valid_q <= 1'b0;
    end else if (slot_i) begin
      case (state_q)
        Run:     if (fail) state_q <= Again;
        Again:   state_q <= Try;
        Try: begin
          state_q <= Refill;
          if (fail) state_q <= Again;
        end
        default: state_q <= Run;
      endcase
      if (flow) begin
        sum_valid_q   <= request_valid_i;
        path_valid_q  <= sum_valid_q;
        tried_valid_q <= path_valid_q;
      end else if (swap) begin
        path_valid_q  <= tried_valid_q;
        tried_valid_q <= path_valid_q;
      end
    end
  end

  logic [Bits-1:0] ds;
  assign ds = {2'b00, request_ds_i};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) sum_q <= '0;
    else if (slot_i && flow && request_valid_i) sum_q <= sum_q + ds;
    if (slot_i && flow) begin
      path_q  <= sum_q;
      tried_q <= path_q;
    end else if (slot_i && swap) begin
      path_q  <= tried_q;
      tried_q <= path_q;
    end
    // Read only if it belongs to the present path_q: after Run, Again and Refill.
    if (slot_i) begin
      left_q            <= reach_q - path_q;
      next_left_q       <= next_reach_q - path_q;
      next_left_known_q <= next_known_q;
      shifted_q         <= go;
    end
  end

  // Steps. Step 7, which is over with a rest of -1, precedes the first.
  logic move;
  logic stride_valid_q;
  logic [Bits-1:0] stride_q;
  assign move = slot_i && (go || skip);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      step_o         <= 3'd7;
      reach_q        <= '1;
      next_known_q   <= 1'b0;
      stride_valid_q <= 1'b0;
    end else begin
      stride_valid_q <= next_valid_i && !next_known_q && !stride_valid_q;  // move: next_known_q
      if (move) begin
        step_o       <= step_o + 3'd1;
        reach_q      <= next_reach_q;
        next_known_q <= 1'b0;
      end else if (stride_valid_q) begin
        next_known_q <= 1'b1;
      end
    end
  end
  always_ff @(posedge clk_i) begin
    stride_q <= {{(Bits - StrideBits) {1'b0}}, next_stride_i};
    if (stride_valid_q) next_reach_q <= reach_q + stride_q;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      token_o  <= 1'b0;
      sample_o <= 1'b0;
    end else begin
      token_o  <= slot_i;
      sample_o <= slot_i && choose && !fail;
    end
  end
  always_ff @(posedge clk_i) begin
    if (slot_i) begin
      left_o <= next_left_q[StrideBits-2:0];
      if (fits && !shifted_q) left_o <= left_q[StrideBits-2:0];
    end
  end

endmodule
`default_nettype wire
