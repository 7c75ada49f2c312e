// SPDX-License-Identifier: Apache-2.0
// rtl/sampler/step_tracker.sv: every request gives one sample, in order; steps are entered one
// after the other and only when they are there; while the next is there, nothing gets stuck. The
// words are free but for the two lowest bits, which tell samples and steps from one another.
// control: LOSES_SAMPLE s/    end else if (slot_i \&\& swap) begin/    end else if (1'b0) begin/
// control: ENTERS_EARLY s/fits_next = next_left_known_q \&\&/fits_next =/
// control: TAKES_MORE s/assign request_ready_o = .*/assign request_ready_o = slot_i;/
// control: NO_RESET s/next_known_q   <= 1'b0;$/next_known_q <= next_known_q;/
// long: proved
`default_nettype none
module step_tracker_formal (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        slot_i,
    input wire logic        request_i,
    input wire logic [47:0] ds_i,
    input wire logic        write_i,
    input wire logic [42:0] stride_i
);

  localparam int StrideBits = curvecore_pkg::StepBits + 1;

  logic [2:0] written_q;  // steps, modulo 8; four at most are there
  logic [2:0] next;
  logic [2:0] step;
  logic ready;
  logic token;
  logic sample;
  logic [StrideBits-2:0] left;
  assign next = step + 3'd1;
  step_tracker u_dut (
      .clk_i,
      .rst_ni,
      .slot_i,
      .request_valid_i(request_i),
      .request_ready_o(ready),
      .request_ds_i(ds_i),
      .next_valid_i(next != written_q),
      .next_stride_i({stride_i, next[1:0]}),
      .token_o(token),
      .sample_o(sample),
      .step_o(step),
      .left_o(left)
  );

  // Reach of a step, modulo 4: -1 and the strides 0, 1, 2, 3, 0, ... of the steps up to it.
  logic [1:0] reach;
  always_comb begin
    case (step)
      3'd0: reach = 2'd3;
      3'd1: reach = 2'd0;
      3'd2: reach = 2'd2;
      3'd3: reach = 2'd1;
      3'd4: reach = 2'd1;
      3'd5: reach = 2'd2;
      3'd6: reach = 2'd0;
      default: reach = 2'd3;
    endcase
  end

  logic started_q = 1'b0;
  logic slot_q;
  logic ran_q;
  logic [2:0] step_q;
  logic [2:0] ahead_q;  // steps there after the present one
  logic [2:0] ahead;
  logic [2:0] inside_q;  // requests without a sample
  logic [1:0] path_q;
  logic [1:0] paths_q[4];  // of the requests inside, oldest first
  logic [1:0] path;
  logic [3:0] idle_q;
  logic request;
  logic [2:0] place;
  assign request = request_i && ready;
  assign ahead   = written_q - next;
  assign path    = path_q + ds_i[1:0];
  assign place   = sample ? inside_q - 3'd1 : inside_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    slot_q    <= slot_i;
    ran_q     <= rst_ni;
    step_q    <= step;
    ahead_q   <= ahead;
    if (!rst_ni) begin
      written_q <= '0;
      inside_q  <= '0;
      path_q    <= '0;
      idle_q    <= '0;
    end else begin
      if (write_i) written_q <= written_q + 3'd1;
      if (request) path_q <= path;
      inside_q <= inside_q + {2'b0, request} - {2'b0, sample};
      if (sample) begin
        for (int n = 0; n < 3; n = n + 1) paths_q[n] <= paths_q[n+1];
      end
      if (request) paths_q[place[1:0]] <= path;
      if (sample || step != step_q || inside_q == '0 || next == written_q) idle_q <= '0;
      else if (slot_i) idle_q <= idle_q + 4'd1;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (ahead >= 3'd4) assume (!write_i);

      FewInside : assert (inside_q <= 3'd4);
      if (sample) NothingInvented : assert (inside_q != '0);
      if (sample) InOrder : assert (left[1:0] == reach - paths_q[0]);
      if (sample) InStep : assert (token);
      if (ran_q) Slots : assert (token == slot_q);
      if (ran_q && step != step_q) NextStep : assert (step == step_q + 3'd1 && ahead_q != '0);
      if (idle_q == 4'd10) NeverStuck : assert (1'b0);

      Waits : cover (inside_q == 3'd3 && next == written_q && !sample && slot_i && !ready);
      Skips : cover (sample && step == 3'd3);
    end
  end

endmodule
`default_nettype wire
