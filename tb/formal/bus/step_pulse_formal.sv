// SPDX-License-Identifier: Apache-2.0
// rtl/pulse/step_pulse.sv, for any inputs: the drive's four times hold; every step goes out once,
// in its direction, and soon, or an overrun is reported; a stop is a stop.
// control: NO_HOLD s/space_q \&\& hold_q/space_q/
// control: NO_SETUP s/turn ? setup_1_i : set_q/set_q/
// control: SHORT_PULSE s/step_o \&\& (long_q || stop_i)/step_o/
// control: SHORT_SPACE s/here \&\& space_q \&\&/here \&\& !step_o \&\&/
// control: OUT_OF_ORDER s/ || (there \&\& back_i == direction_o)//
// control: DROPS_QUIETLY s/overrun_o || (overrun/overrun_o \&\& (overrun/
// control: RISES_ON s/set_q \&\& !stop_i;/set_q;/
// control: CERTAIN s/uncertain_o || (step_o/uncertain_o \&\& (step_o/
// control: STUCK s/(space_q || age_q == again_i)/space_q/
// control: LOSES_ONE s/in_back != out_back/in_back \&\& !out_forth/
`default_nettype none
module step_pulse_formal (
    input wire logic       clk_i,
    input wire logic       rst_ni,
    input wire logic [1:0] steplen_i,
    input wire logic [1:0] stepspace_i,
    input wire logic [1:0] dirsetup_i,
    input wire logic [1:0] dirhold_i,
    input wire logic       hit_i,
    input wire logic       back_i,
    input wire logic       stop_i
);

  // 0 counts as 1.
  logic [1:0] length;
  logic [1:0] space;
  logic [1:0] setup;
  logic [1:0] hold;
  assign length = steplen_i | 2'(steplen_i == '0);
  assign space  = stepspace_i | 2'(stepspace_i == '0);
  assign setup  = dirsetup_i | 2'(dirsetup_i == '0);
  assign hold   = dirhold_i | 2'(dirhold_i == '0);

  logic step;
  logic direction;
  logic rise;
  logic overrun;
  logic uncertain;
  step_pulse #(
      .TimeBits(4)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .length_i   ({2'b0, length}),
      .setup_i    ({2'b0, setup}),
      .again_i    ({2'b0, length} + {2'b0, space}),
      .turn_i     ({2'b0, length} + {2'b0, hold}),
      .length_1_i (length == 2'd1),
      .setup_1_i  (setup == 2'd1),
      .hit_i,
      .back_i,
      .stop_i,
      .clear_i    (1'b0),
      .step_o     (step),
      .direction_o(direction),
      .rise_o     (rise),
      .overrun_o  (overrun),
      .uncertain_o(uncertain)
  );

  // Clocks that the pins have been as they are, up to 3.
  logic started_q = 1'b0;
  logic [7:0] times_q;
  logic step_q;
  logic direction_q;
  logic stop_q;
  logic rise_q;
  logic [1:0] level_q;
  logic [1:0] side_q;
  logic [1:0] fallen_q;  // since the pulse ended
  logic cut_q;  // a pulse was
  // Steps due and not yet out, as long as none was dropped.
  logic [3:0] forth_q;
  logic [3:0] back_q;
  logic [3:0] against;  // of them, those against the pin's direction
  assign against = direction ? forth_q : back_q;
  logic returns_q;  // one in the pin's direction is due after one against it
  logic [4:0] wait_q;  // clocks in which one was due and none went out
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    times_q <= {steplen_i, stepspace_i, dirsetup_i, dirhold_i};
    step_q <= rst_ni && step;
    direction_q <= rst_ni && direction;
    stop_q <= rst_ni && stop_i;
    rise_q <= rst_ni && rise;
    returns_q <= rst_ni && !stop_i && hit_i && back_i == direction && against != '0;
    if (!rst_ni) begin
      level_q <= '1;
      side_q <= '1;
      fallen_q <= '1;
      cut_q <= 1'b0;
      forth_q <= '0;
      back_q <= '0;
      wait_q <= '0;
    end else begin
      level_q  <= step != step_q ? 2'd1 : level_q + 2'(level_q != '1);
      side_q   <= direction != direction_q ? 2'd1 : side_q + 2'(side_q != '1);
      fallen_q <= !step && step_q ? 2'd1 : fallen_q + 2'(fallen_q != '1);
      if (stop_i && step && (step_q ? level_q : 2'd0) + 3'd1 < {1'b0, length}) cut_q <= 1'b1;
      forth_q <= stop_i ? '0 : forth_q + 4'(hit_i && !back_i) - 4'(rise && !direction);
      back_q  <= stop_i ? '0 : back_q + 4'(hit_i && back_i) - 4'(rise && direction);
      wait_q  <= (forth_q == '0 && back_q == '0) || rise || stop_i ? '0 : wait_q + 1'b1;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else begin
      assume (times_q == {steplen_i, stepspace_i, dirsetup_i, dirhold_i});
      if (rst_ni) begin
        // Edges of this clock.
        if (step && !step_q) Stepspace : assert (level_q >= space);
        if (step && !step_q) Dirsetup : assert (side_q >= setup && direction == direction_q);
        if (!step && step_q && !stop_q) Steplen : assert (level_q >= length);
        if (direction != direction_q) begin
          Dirhold : assert (fallen_q >= hold);
          BetweenPulses : assert (!step && !step_q);
        end
        if (step && !step_q) Told : assert (rise_q);

        if (rise && !overrun) NoneInvented : assert (direction ? back_q != '0 : forth_q != '0);
        if (!overrun) NoneLost : assert (forth_q <= 4'd3 && back_q <= 4'd3);
        if (returns_q) InOrder : assert (overrun);
        if (!overrun) Soon : assert (wait_q <= 5'd16);

        if (stop_q) begin
          Stops : assert (!step && direction == direction_q);
          Tells : assert (uncertain == cut_q);
        end

        Turns : cover (direction && step && forth_q == 4'd1);
        Waits : cover (forth_q == 4'd3 && !overrun);
        Overruns : cover (overrun && !step);
        Cuts : cover (uncertain && stop_q);
      end
    end
  end

endmodule
`default_nettype wire
