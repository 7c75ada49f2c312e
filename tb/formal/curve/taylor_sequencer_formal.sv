// SPDX-License-Identifier: Apache-2.0
// rtl/control/taylor_sequencer.sv: a step takes Latency clocks, every control comes in the cycles
// of the table in its header and in no other, starts are taken in idle only. A reset lasts two
// clocks, and starts nothing.
// control: DIGIT_MISSING s/digit_d == 5'(Digits)/digit_d == 5'(Digits - 1)/
// control: ONE_ORDER_LESS s/4'(Order - 1)/4'(Order - 2)/
// control: NEVER_DONE s/default: state_d = Idle/default: state_d = Done/
// control: ADVANCES_FRESH s/ \&\& !fresh_q//
// control: NO_RESET s/state_q      <= Idle;/state_q      <= state_d;/
`default_nettype none
module taylor_sequencer_formal #(
    parameter int Order = 4
) (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic start_i,
    input wire logic fresh_i
);

  localparam int Digits = 9;
  localparam int Slot = Digits + 3;
  localparam int Latency = Order * Slot + 5;

  logic [riemann_pkg::ExpansionBits-1:0] control;
  logic ready;
  logic take;
  logic close;
  logic triple;
  logic step;
  logic last;
  logic [1:0] digit;
  logic advance;
  logic zeroth;
  logic collect;
  logic first;
  logic zeroth_there;
  logic collect_there;
  logic [3:0] order_there;
  logic done;
  taylor_sequencer #(
      .Order(Order),
      .Bits (18)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .start_i,
      .fresh_i,
      .theta_i('0),
      .ready_o(ready),
      .control_o(control),
      .zeroth_there_o(zeroth_there),
      .collect_there_o(collect_there),
      .order_there_o(order_there),
      .done_o(done)
  );
  assign take = control[digits_pkg::Take];
  assign triple = control[digits_pkg::Triple];
  assign step = control[digits_pkg::Step];
  assign last = control[digits_pkg::Last];
  assign digit = control[digits_pkg::Digit+:2];
  assign close = control[riemann_pkg::Close];
  assign advance = control[riemann_pkg::Advance];
  assign zeroth = control[riemann_pkg::Zeroth];
  assign collect = control[riemann_pkg::Collect];
  assign first = control[riemann_pkg::First];
  logic unused;
  assign unused = ^digit;

  // The cycle of the table; its slot and the cycle within it.
  logic started_q = 1'b0;
  logic low_q = 1'b0;  // reset in the clock before
  logic reset_q = 1'b0;  // and in that before it
  logic [7:0] cycle_q;
  logic fresh_q;
  logic [3:0] slot_q;
  logic [3:0] within_q;
  logic [3:0] orders_q;  // given for this step
  logic was_last_q;
  logic in_slot;
  logic slot_takes;
  assign in_slot    = cycle_q != 8'd0 && slot_q < 4'(Order);
  assign slot_takes = in_slot && within_q == 4'd0;
  logic closing;
  assign closing = cycle_q == 8'(Digits + 4) || cycle_q == 8'(Digits + 5)
                 || cycle_q == 8'(Digits + 6);
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    low_q     <= !rst_ni;
    reset_q   <= low_q;
    if (!rst_ni) begin
      cycle_q <= '0;
      slot_q <= '0;
      within_q <= '0;
      orders_q <= '0;
      was_last_q <= 1'b0;
    end else begin
      was_last_q <= cycle_q == 8'(Latency - 1);
      if (cycle_q == 8'd0) begin
        orders_q <= '0;
        if (start_i) begin
          cycle_q  <= 8'd1;
          fresh_q  <= fresh_i;
          slot_q   <= '0;
          within_q <= '0;
        end
      end else begin
        cycle_q <= (cycle_q == 8'(Latency - 1)) ? '0 : cycle_q + 8'd1;
        if (cycle_q >= 8'(Digits + 6) || cycle_q < 8'(Digits + 3)) begin
          within_q <= (within_q == 4'(Slot - 1)) ? '0 : within_q + 4'd1;
          if (within_q == 4'(Slot - 1)) slot_q <= slot_q + 4'd1;
        end
        if (cycle_q == 8'(Digits + 6)) begin
          slot_q   <= 4'd1;
          within_q <= '0;
        end
        if (collect) orders_q <= orders_q + 4'd1;
      end
    end
  end

  logic [7:0] at;
  logic was_collect_q;
  logic was_zeroth_q;
  logic [3:0] was_orders_q;
  always_ff @(posedge clk_i) begin
    was_collect_q <= collect && rst_ni;
    was_zeroth_q  <= zeroth && rst_ni;
    was_orders_q  <= orders_q;
  end
  assign at = closing ? 8'd0 : {4'd0, within_q};

  always_comb begin
    if (!started_q || (low_q && !reset_q)) assume (!rst_ni);
    if (!rst_ni) begin
      assume (!start_i);
    end else begin
      Idle : assert (ready == (cycle_q == 8'd0));
      Close : assert (close == (cycle_q == 8'd1));
      Take : assert (take == ((slot_takes && !closing) || cycle_q == 8'(Digits + 5)));
      Advance : assert (advance == (cycle_q == 8'(Digits + 4) && !fresh_q));
      Zeroth : assert (zeroth == (cycle_q == 8'(Digits + 5)));
      if (closing) begin
        CopyTriple : assert (triple == (cycle_q == 8'(Digits + 6)) && !step);
      end else begin
        Triple : assert (triple == (in_slot && at == 8'd1));
        Step : assert (step == (in_slot && at >= 8'd2 && at <= 8'(Digits + 1)));
        Last : assert (last == (in_slot && at == 8'(Digits + 1)));
      end
      Collect :
      assert (collect == ((slot_takes && slot_q != 4'd0 && !closing)
                                    || cycle_q == 8'(Latency - 1)));
      First : assert (first == (cycle_q == 8'(Digits + 7)));
      Done : assert (done == was_last_q);
      CollectThere : assert (collect_there == was_collect_q);
      ZerothThere : assert (zeroth_there == was_zeroth_q);
      if (collect_there) WhichOrder : assert (order_there == was_orders_q + 4'd1);
      if (zeroth_there) OrderZero : assert (order_there == 4'd0);
      if (done) AllOrders : assert (order_there == 4'(Order) && collect_there);

      TwoSteps : cover (done && !fresh_q && start_i);
    end
  end

endmodule
`default_nettype wire
