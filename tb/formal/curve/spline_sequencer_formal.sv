// SPDX-License-Identifier: Apache-2.0
// rtl/control/spline_sequencer.sv: every start that is taken runs through the orders of the table
// in its header, each control in its cycle and in no other, and leads to done in the clocks stated;
// starts are taken in idle only and none of those is lost.  Order 2 with Anchor 0 and Mode 1, order
// 3 with 1 and 0.  A reset lasts two clocks, and starts nothing.
// control: LOSES_START s/? start_i : turn_q/? start_i \&\& turn_q : turn_q/
// control: ONE_ORDER_LESS s/order_q == 4'(Top)/order_q == 4'(Top - 1)/
// control: HURRIES_PHI s/8'(3 \* i + 13);/8'(3 * i + 12);/
// control: NO_PAUSE s/3 \* i + 13 + Pause/3 * i + 13/
// control: NEVER_DONE s/default: next = Idle/default: next = Last/
// control: NO_RESET s/state_q     <= Idle;/state_q     <= next_q;/
// long: proved
`default_nettype none
module spline_sequencer_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic start_i
);

  localparam int Bits = 36;
  localparam int Digits = 18;
  localparam int Pause = 5;

  logic started_q = 1'b0;
  logic low_q = 1'b0;  // reset in the clock before
  logic reset_q = 1'b0;  // and in that before it
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    low_q     <= !rst_ni;
    reset_q   <= low_q;
  end
  always_comb begin
    if (!started_q || (low_q && !reset_q)) assume (!rst_ni);
    if (!rst_ni) assume (!start_i);
  end

  for (genvar Anchor = 0; Anchor < 2; Anchor = Anchor + 1) begin : g_anchor
    localparam int Order = 2 + Anchor;
    localparam int Mode = 1 - Anchor;
    localparam int Top = Order - Anchor;

    logic [spline_pkg::ControlBits-1:0] control;
    logic ready;
    logic start_v;
    logic start_x;
    logic start_p;
    logic start_phi;
    logic [3:0] order;
    logic done;
    spline_sequencer #(
        .Order (Order),
        .Bits  (Bits),
        .Mode  (Mode),
        .Anchor(Anchor)
    ) u_dut (
        .clk_i,
        .rst_ni,
        .start_i,
        .ready_o(ready),
        .control_o(control),
        .done_o(done)
    );
    assign start_v   = control[spline_pkg::StartV];
    assign start_x   = control[spline_pkg::StartX];
    assign start_p   = control[spline_pkg::StartP];
    assign start_phi = control[spline_pkg::StartPhi];
    assign order     = control[spline_pkg::Order+:4];

    // The cycle within an order of the table; order Top + 1 is the rest that Anchor 1 has.
    localparam int RestQ = Order + Digits + 6;
    localparam int RestX = 4 * Order + 15;
    localparam int Rest = (Mode == 0 && RestX > RestQ) ? RestX : RestQ;
    logic [3:0] order_q;  // 0: idle
    logic [6:0] at_q;
    logic [6:0] length;
    logic was_last_q;
    logic in_order;
    logic [6:0] p_at;
    logic [6:0] phi_at;
    assign in_order = order_q != 4'd0 && order_q <= 4'(Top);
    assign p_at = 7'(3 * order_q + 7);
    assign phi_at = 7'(6 * order_q + 14);
    always_comb begin
      length = 7'(9 * order_q + 27);
      if (order_q == 4'd2) length = 7'(9 * 2 + 27 + Pause);
      if (order_q == 4'(Top) && Anchor == 0) length = 7'(6 * Order + 13 + 84);
      if (order_q == 4'(Top + 1)) length = 7'(Rest);
    end
    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        order_q    <= '0;
        at_q       <= '0;
        was_last_q <= 1'b0;
      end else begin
        was_last_q <= order_q == 4'(Order) && at_q == length;
        if (order_q == 4'd0) begin
          order_q <= {3'b0, start_i && !was_last_q};
          at_q    <= {6'b0, start_i && !was_last_q};
        end else if (at_q == length) begin
          order_q <= (order_q == 4'(Order)) ? '0 : order_q + 4'd1;
          at_q    <= 7'd1;
        end else begin
          at_q <= at_q + 7'd1;
        end
      end
    end

    always_comb begin
      if (started_q && rst_ni) begin
        assert (ready == (order_q == 4'd0 && !was_last_q));
        assert (start_v == (in_order && at_q == 7'd1));
        assert (start_x == (order_q != 4'd0 && at_q == 7'd1));
        assert (start_p == (in_order && at_q == p_at));
        assert (start_phi == (in_order && at_q == phi_at));
        if (start_v || start_x || start_p || start_phi) assert (order == order_q);
        assert (done == was_last_q);

        cover (done);
      end
    end
  end

endmodule
`default_nettype wire
