// SPDX-License-Identifier: Apache-2.0
// Ticks into samples, 2^n_i each, n_i fixed: a tick's rate is its number, and so are its samples'.
// None is lost, doubled or out of order; they are sent on request; offers stay; nothing is stuck.
`default_nettype none
module numbered_ticks #(
    parameter int Inside = 2,  // most ticks that are taken and not yet over
    parameter int Idle   = 4   // most clocks from a wanted sample to its offer
) (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic [ 1:0] n_i,
    input wire logic        tick_valid_i,
    input wire logic        tick_ready_i,
    input wire logic        wanted_i,
    input wire logic        sent_i,
    input wire logic        sample_valid_i,
    input wire logic        sample_ready_i,
    input wire logic [17:0] sample_rate_i,

    output logic [17:0] tick_rate_o,
    output logic [ 3:0] tick_o,       // tick of the sample that is offered or comes next
    output logic        checks_o
);

  logic started_q = 1'b0;
  logic [1:0] n_q;
  logic kept_q;
  logic [Idle-1:0] idle_q;  // cycles in which a sample was possible and none came
  logic [3:0] number_q;
  logic [2:0] index_q;
  logic [3:0] ticks_inside;
  logic last;
  assign tick_rate_o  = {14'b0, number_q};
  assign ticks_inside = number_q - tick_o;
  assign last         = index_q == (3'd1 << n_i) - 3'd1;
  assign checks_o     = started_q && rst_ni;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    n_q       <= n_i;
    kept_q    <= rst_ni && sample_valid_i && !sample_ready_i;
    idle_q    <= {idle_q[Idle-2:0], rst_ni && ticks_inside != '0 && wanted_i && !sample_valid_i};
    if (!rst_ni) begin
      number_q <= '0;
      index_q  <= '0;
      tick_o   <= '0;
    end else begin
      if (tick_valid_i && tick_ready_i) number_q <= number_q + 1'b1;
      if (sample_valid_i && sample_ready_i) begin
        index_q <= last ? '0 : index_q + 1'b1;
        if (last) tick_o <= tick_o + 1'b1;
      end
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else begin
      assume (n_i == n_q);
      if (rst_ni) begin
        FewInside : assert (ticks_inside <= 4'(Inside));
        if (sample_valid_i) InOrder : assert (sample_rate_i == {14'b0, tick_o});
        if (sample_valid_i) NothingInvented : assert (ticks_inside != '0);
        if (kept_q) KeepsOffer : assert (sample_valid_i);
        if (sent_i) Wanted : assert (wanted_i);
        if (idle_q == '1) NeverStuck : assert (sample_valid_i);
        if (ticks_inside == '0) TakesTick : assert (tick_ready_i);

        ThirdTick : cover (sample_valid_i && tick_o == 4'd2 && n_i == 2'd2);
      end
    end
  end

endmodule
`default_nettype wire
