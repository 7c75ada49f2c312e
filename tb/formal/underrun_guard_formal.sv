// SPDX-License-Identifier: Apache-2.0
// rtl/path/underrun_guard.sv: hold comes exactly where the ticks of some clocks before do not
// exceed stop ticks + 8, goes where they exceed twice as many + 8 or nothing can run out, stays
// otherwise; underrun is sticky; after reset there is neither. Counts are small ones.
// control: LATE s/assign over_stop = stop_q - left_q/assign over_stop = stop_q - left_q - 34'sd1/
// control: NO_HYSTERESIS s/{1'b0, stop_ticks_i, 1'b0} + Age/{2'b0, stop_ticks_i} + Age/
// control: HOLDS_FINAL s/ || final_i//
// control: FORGETS_STARTED s/ - \$signed({29'b0, started_i})//
// control: NO_RESET s/underrun_o <= 1'b0;//
`default_nettype none
module underrun_guard_formal (
    input wire logic              clk_i,
    input wire logic              rst_ni,
    input wire logic        [2:0] stop_i,
    input wire logic              plenty_i,
    input wire logic              final_i,
    input wire logic        [4:0] ticks_i,
    input wire logic              active_i,
    input wire logic              present_final_i,
    input wire logic signed [4:0] present_i,
    input wire logic        [1:0] started_i
);

  logic hold;
  logic underrun;
  underrun_guard u_dut (
      .clk_i,
      .rst_ni,
      .stop_ticks_i({29'b0, stop_i}),
      .plenty_i,
      .final_i,
      .ticks_i({27'b0, ticks_i}),
      .active_i,
      .present_final_i,
      .present_ticks_i({{17{present_i[4]}}, present_i}),
      .started_i({3'b0, started_i}),
      .hold_o(hold),
      .underrun_o(underrun)
  );

  // Ticks as they stood: the present piece's a clock before the queue's.
  logic [2:0] age_q = 3'd0;
  logic [2:0] stop_q;
  logic signed [7:0] present_q;
  logic signed [7:0] left_q[2];
  logic exempt_q[2];
  logic ran_q;  // no reset in the clock before
  logic was_hold_q;
  logic ever_q;
  logic signed [7:0] low;
  logic signed [7:0] enough;
  assign low    = $signed({5'b0, stop_q}) + 8'sd8;
  assign enough = $signed({4'b0, stop_q, 1'b0}) + 8'sd8;
  always_ff @(posedge clk_i) begin
    if (age_q != '1) age_q <= age_q + 3'd1;
    stop_q      <= stop_i;
    present_q   <= {{3{present_i[4]}}, present_i} - $signed({6'b0, started_i});
    left_q[0]   <= $signed({3'b0, ticks_i}) + present_q;
    left_q[1]   <= left_q[0];
    exempt_q[0] <= !active_i || present_final_i || final_i || plenty_i;
    exempt_q[1] <= exempt_q[0];
    ran_q       <= rst_ni;
    was_hold_q  <= hold && rst_ni;
    ever_q      <= rst_ni && (hold || ever_q);
  end

  logic signed [7:0] left_before_q;
  always_ff @(posedge clk_i) left_before_q <= left_q[1];

  always_comb begin
    if (age_q != '0) assume (stop_i == stop_q);
    if (age_q < 3'd5) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      Sticky : assert (underrun == (ever_q || hold));
      if (!ran_q) AfterReset : assert (!hold && !underrun);
      if (ran_q) begin
        if (exempt_q[1])
          Exempt :
          assert (!hold);
          else if (left_before_q > enough)
            GoesOn :
            assert (!hold);
            else if (left_before_q <= low)
              Holds :
              assert (hold);
              else Stays : assert (hold == was_hold_q);
      end

      Recovers : cover (ran_q && was_hold_q && !hold && !exempt_q[1]);
      HoldsBetween : cover (hold && left_before_q > low);
    end
  end

endmodule
`default_nettype wire
