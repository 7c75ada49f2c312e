// SPDX-License-Identifier: Apache-2.0
// Four banks between the network, which writes steps ahead, and the sampler, which reads them: the
// use of each bank, and the words of a step that are not coefficients.
//
// A step number counts modulo 8; its low two bits name its bank.
//
//   network   room_o: bank write_step_o is free; write_i: the step in it is complete
//   tracker   next_*: the step after `current_step_i`, if complete
//   sampler   look_*: words of a step that it reads;  leave_i: no sample of a step before
//             leave_step_i is under way any more, their banks are free
`default_nettype none
module series_buffer (
    input wire logic clk_i,
    input wire logic rst_ni,

    output logic                                    room_o,
    output logic      [                        2:0] write_step_o,
    input  wire logic                               write_i,
    input  wire logic                               last_i,
    input  wire logic [                        4:0] k_i,
    input  wire logic [curvecore_pkg::StepBits-1:0] offset_i,
    input  wire logic [  curvecore_pkg::StepBits:0] stride_i,

    input  wire logic [                      2:0] current_step_i,
    output logic                                  next_valid_o,
    output logic      [curvecore_pkg::StepBits:0] next_stride_o,

    input  wire logic [                        2:0] look_step_i,
    output logic                                    look_last_o,
    output logic      [                        4:0] look_k_o,
    output logic      [curvecore_pkg::StepBits-1:0] look_offset_o,

    input wire logic       leave_i,
    input wire logic [2:0] leave_step_i
);

  localparam int Bits = curvecore_pkg::StepBits;

  // Step 7, which is over, precedes the first step.
  logic [2:0] write_q;
  logic [2:0] oldest_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      write_q  <= 3'd0;
      oldest_q <= 3'd7;
    end else begin
      if (write_i) write_q <= write_q + 3'd1;
      if (leave_i) oldest_q <= leave_step_i;
    end
  end

  logic [2:0] used;
  logic [2:0] next_step;
  assign used         = write_q - oldest_q;
  assign room_o       = used < 3'd4;
  assign write_step_o = write_q;
  assign next_step    = current_step_i + 3'd1;
  assign next_valid_o = next_step != write_q;

  logic [  Bits:0] stride_memory[4];
  logic [Bits+5:0] look_memory  [4];
  logic [Bits+5:0] look;
  always_ff @(posedge clk_i) begin
    if (write_i) begin
      stride_memory[write_q[1:0]] <= stride_i;
      look_memory[write_q[1:0]]   <= {last_i, k_i, offset_i};
    end
  end
  assign next_stride_o = stride_memory[next_step[1:0]];
  assign look          = look_memory[look_step_i[1:0]];
  assign look_last_o   = look[Bits+5];
  assign look_k_o      = look[Bits+4:Bits];
  assign look_offset_o = look[Bits-1:0];

endmodule
`default_nettype wire
