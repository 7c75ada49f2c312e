// SPDX-License-Identifier: Apache-2.0
// Displacements into samples: landed, queued until they are taken, and rounded as they leave,
//
//     fine = land ? end : origin + floor(d 2^k 2^GuardBits + 1/2)
//     position = floor(fine / 2^GuardBits + 1/2)
//
// Where samples are Axes clocks apart or more, one lander and one adder do all axes, one a clock.
//
//   clock     0                 7, with one lander 7 + Axes
//   valid_i   d_i, tag_i        sample_valid_o, if the output is free
//
// leave_o: the points of the step leave_step_o have been read.
`default_nettype none
module sample_landing #(
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int PositionBits   = 32,  // [16, 32]
    parameter int GuardBits      = 10,  // [2, 12]
    parameter int Axes           = 3,   // [3, 9]
    parameter int SampleInterval = 1,   // 1, 2, 4, 8 clocks
    parameter int QueueDepth     = 64,  // [16, 256], a power of two
    parameter int QueueBlock     = 0    // 0 distributed memory, 1 block RAM
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Points of the step in a bank: {there, axis, end, origin}
    input wire logic [                           1:0] write_bank_i,
    input wire logic [2*(PositionBits+GuardBits)+4:0] point_i,

    // Displacements with their tags, from rtl/sampler/sample_side.sv
    input  wire logic                     valid_i,
    input  wire logic [Axes*CoefBits-1:0] d_i,
    input  wire logic [              9:0] tag_i,
    output logic                          leave_o,
    output logic      [              2:0] leave_step_o,

    // Places in the queue
    input  wire logic admit_i,
    output logic      room_o,

    // Samples, axis 0 in the low bits
    output logic                                          sample_valid_o,
    input  wire logic                                     sample_ready_i,
    output logic      [            Axes*PositionBits-1:0] sample_position_o,
    output logic      [Axes*(PositionBits+GuardBits)-1:0] sample_fine_o
);

  localparam int FineBits = PositionBits + GuardBits;
  localparam int Shared = (Axes <= SampleInterval) ? 1 : 0;
  localparam int Words = (Shared != 0) ? Axes : 1;  // words that a sample is in the queue
  localparam int WordBits = (Shared != 0) ? FineBits : Axes * FineBits;

  logic [4:0] down;
  logic       sample;
  logic       land;
  logic [2:0] step;
  assign {down, sample, land, step} = tag_i;

  // Points are read until clock 1, or Axes + 1.
  localparam int Leave = (Shared != 0) ? Axes + 2 : 2;
  logic [Leave-1:0] valid_q;
  logic [      2:0] step_q  [Leave];
  assign leave_o      = valid_q[Leave-1];
  assign leave_step_o = step_q[Leave-1];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= {valid_q[Leave-2:0], valid_i};
  end
  always_ff @(posedge clk_i) begin
    step_q[0] <= step;
    for (int c = 1; c < Leave; c++) step_q[c] <= step_q[c-1];
  end

  logic                push;
  logic [WordBits-1:0] fine;
  if (Shared != 0) begin : g_shared
    shared_lander #(
        .CoefBits(CoefBits),
        .FineBits(FineBits),
        .GuardBits(GuardBits),
        .Axes(Axes)
    ) u_lander (
        .clk_i,
        .rst_ni,
        .write_bank_i,
        .point_i,
        .valid_i,
        .sample_i(sample),
        .d_i,
        .down_i  (down),
        .bank_i  (step[1:0]),
        .land_i  (land),
        .push_o  (push),
        .fine_o  (fine)
    );
  end else begin : g_each
    logic [2:0] sample_q;
    logic       land_q;
    assign push = sample_q[2];
    always_ff @(posedge clk_i) begin
      if (!rst_ni) sample_q <= '0;
      else sample_q <= {sample_q[1:0], valid_i && sample};
    end
    always_ff @(posedge clk_i) land_q <= land;
    for (genvar n = 0; n < Axes; n++) begin : g_axis
      logic write;
      assign write = point_i[2*FineBits+4] && point_i[2*FineBits+:4] == 4'(n);
      lander #(
          .CoefBits (CoefBits),
          .FineBits (FineBits),
          .GuardBits(GuardBits)
      ) u_lander (
          .clk_i,
          .write_i(write),
          .write_place_i(write_bank_i),
          .write_origin_i(point_i[0+:FineBits]),
          .write_end_i(point_i[FineBits+:FineBits]),
          .d_i(d_i[n*CoefBits+:CoefBits]),
          .down_i(down),
          .place_i(step_q[0][1:0]),
          .land_i(land_q),
          .fine_o(fine[n*FineBits+:FineBits])
      );
    end
  end

  logic                queued_valid;
  logic                queued_ready;
  logic [WordBits-1:0] queued;
  logic                there;  // a whole sample
  logic                leaves;
  sample_queue #(
      .Bits (WordBits),
      .Depth(QueueDepth),
      .Words(Words),
      .Block(QueueBlock)
  ) u_queue (
      .clk_i,
      .rst_ni,
      .admit_i,
      .room_o,
      .push_i (push),
      .data_i (fine),
      .valid_o(queued_valid),
      .ready_i(queued_ready),
      .data_o (queued),
      .leave_i(there && leaves)
  );

  // Samples at the output, which waits for all axes.
  logic [    Axes*FineBits-1:0] whole_fine;
  logic [Axes*PositionBits-1:0] whole_position;
  assign leaves = !sample_valid_o || sample_ready_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) sample_valid_o <= 1'b0;
    else if (leaves) sample_valid_o <= there;
  end
  for (genvar n = 0; n < Axes; n++) begin : g_output
    logic        [    FineBits-1:0] fine_q;
    logic signed [PositionBits-1:0] position_q;
    always_ff @(posedge clk_i) begin
      if (there && leaves) begin
        fine_q     <= whole_fine[n*FineBits+:FineBits];
        position_q <= whole_position[n*PositionBits+:PositionBits];
      end
    end
    assign sample_fine_o[n*FineBits+:FineBits] = fine_q;
    assign sample_position_o[n*PositionBits+:PositionBits] = position_q;
  end

  // Rounded positions of the words of the queue
  localparam int Rounded = WordBits / FineBits;
  logic [Rounded*PositionBits-1:0] position;
  for (genvar n = 0; n < Rounded; n++) begin : g_round
    logic [PositionBits-1:0] floor;
    logic                    half;
    assign {floor, half} = queued[n*FineBits+GuardBits-1+:PositionBits+1];
    assign position[n*PositionBits+:PositionBits] = floor + PositionBits'(half);
  end

  if (Shared != 0) begin : g_gather
    logic [                      2:0] axis_q;
    logic [    (Axes-1)*FineBits-1:0] fine_q;
    logic [(Axes-1)*PositionBits-1:0] position_q;
    logic                             last;
    assign last           = axis_q == 3'(Axes - 1);
    assign there          = queued_valid && last;
    assign queued_ready   = !last || leaves;
    assign whole_fine     = {queued, fine_q};
    assign whole_position = {position, position_q};
    always_ff @(posedge clk_i) begin
      if (!rst_ni) axis_q <= 3'd0;
      else if (queued_valid && queued_ready) axis_q <= last ? 3'd0 : axis_q + 3'd1;
    end
    always_ff @(posedge clk_i) begin
      if (queued_valid && !last) begin
        fine_q     <= whole_fine[Axes*FineBits-1:FineBits];
        position_q <= whole_position[Axes*PositionBits-1:PositionBits];
      end
    end
  end else begin : g_whole
    assign there          = queued_valid;
    assign queued_ready   = leaves;
    assign whole_fine     = queued;
    assign whole_position = position;
  end

endmodule
`default_nettype wire
