// SPDX-License-Identifier: Apache-2.0
// The ports of motion_interpolator, and behind them what `curvecore vectors` wrote: a core of others
// that takes any words and puts out the samples of its files, one a request.
`include "recorded_settings.vh"
module recorded_core #(
    parameter PositionBits = 16,
    parameter GuardBits = 2
) (
    input clk_i,
    input rst_ni,
    input [15:0] digest_i,
    input segment_valid_i,
    output segment_ready_o,
    input [47:0] segment_data_i,
    input profile_valid_i,
    output profile_ready_o,
    input [47:0] profile_data_i,
    output segment_leaves_o,
    output profile_leaves_o,
    input sample_request_valid_i,
    output sample_request_ready_o,
    input hold_i,
    input [16:0] override_i,
    input kill_i,
    input [3:0] samples_per_tick_log2_i,
    input [31:0] hold_acceleration_i,
    input [32:0] hold_slope_i,
    input [31:0] stop_ticks_i,
    output reg sample_valid_o,
    input sample_ready_i,
    output reg [3*PositionBits-1:0] sample_position_o,
    output reg [3*(PositionBits+GuardBits)-1:0] sample_fine_o,
    output reg path_valid_o,
    output reg [47:0] path_ds_o,
    output [16:0] path_rate_o,
    output path_active_o,
    output [63:0] path_o,
    output active_o,
    output underrun_o,
    output killed_o,
    output standing_o,
    output [7:0] fault_o,
    output [15:0] empty_segments_o
);
  reg [3*PositionBits-1:0] positions[0:`SAMPLES-1];
  reg [3*(PositionBits+GuardBits)-1:0] fines[0:`SAMPLES-1];
  reg [47:0] paths[0:`SAMPLES-1];
  integer n;
  initial begin
    $readmemh("positions.hex", positions);
    $readmemh("fine.hex", fines);
    $readmemh("path.hex", paths);
  end

  assign segment_ready_o = 1'b1;
  assign profile_ready_o = 1'b1;
  assign segment_leaves_o = segment_valid_i;
  assign profile_leaves_o = profile_valid_i;
  assign sample_request_ready_o = !sample_valid_o;
  assign path_rate_o = 17'd65536;
  assign {path_active_o, active_o, underrun_o, killed_o, standing_o} = 5'd0;
  assign path_o = 64'd0;
  assign fault_o = 8'd0;
  assign empty_segments_o = 16'd0;

  always @(posedge clk_i) begin
    path_valid_o <= 1'b0;
    if (sample_ready_i) sample_valid_o <= 1'b0;
    if (sample_request_valid_i && sample_request_ready_o) begin
      sample_valid_o <= 1'b1;
      path_valid_o <= 1'b1;
      sample_position_o <= positions[n];
      sample_fine_o <= fines[n];
      path_ds_o <= paths[n];
      n <= n + 1;
    end
    if (!rst_ni) begin
      sample_valid_o <= 1'b0;
      path_valid_o <= 1'b0;
      n <= 0;
    end
  end
endmodule
