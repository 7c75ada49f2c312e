// SPDX-License-Identifier: Apache-2.0
// rtl/time/motion_settings.sv: settings change only where nothing is under way; a tick starts only
// when good_o reports the present settings, which are then within their ranges or not obeyed; the
// time scaler restarts with two clocks of them; they are taken at once when it is quiet; faults
// come where they must and nowhere else. Words have a few bits at both ends.
// control: TAKES_IN_MOTION s/assign pause_o = .*/assign pause_o = !same_q;/
// control: TAKES_UNDER_WAY s/ \&\& quiet_i//
// control: FORGETS_STOP s/ \&\& stop_fits//
// control: BELOW_EIGHT s/\[30:3\]/[30:2]/
// control: SLOPE_TOO_LOW s/hold_slope_o >= /hold_slope_o + 33'd1 >= /
// control: NO_RESTART s/restart_o <= take/restart_o <= 1'b0/
// control: SILENT s/if (changed || unfit)/if (unfit)/
// control: NO_RESET s/settings_fault_o <= 1'b0;//
`default_nettype none
module motion_settings_formal (
    input wire logic       clk_i,
    input wire logic       rst_ni,
    input wire logic       n_i,
    input wire logic [2:0] acceleration_i,
    input wire logic [2:0] slope_i,
    input wire logic [1:0] stop_i,
    input wire logic       queued_i,
    input wire logic       start_i,         // a tick
    input wire logic       begin_i,         // a program, with a tick under way
    input wire logic       end_i,
    input wire logic       leave_i          // the tick's samples
);

  logic [ 3:0] n;
  logic [31:0] acceleration;
  logic [32:0] slope;
  logic [31:0] stop;
  assign n            = {3'b0, n_i};
  assign acceleration = {acceleration_i[2], 27'b0, acceleration_i[1], {3{acceleration_i[0]}}};
  assign slope        = {slope_i[2], 28'b0, slope_i[1], {3{slope_i[0]}}};
  assign stop         = {2'b0, stop_i[1], 28'b0, stop_i[0]};

  logic under_way_q;
  logic free_q;  // the settings were good when the tick started
  logic active_q;
  logic pause;
  logic restart;
  logic good;
  logic [3:0] n_taken;
  logic [31:0] acceleration_taken;
  logic [32:0] slope_taken;
  logic [31:0] stop_taken;
  logic fault;
  motion_settings u_dut (
      .clk_i,
      .rst_ni,
      .samples_per_tick_log2_i(n),
      .hold_acceleration_i(acceleration),
      .hold_slope_i(slope),
      .stop_ticks_i(stop),
      .active_i(active_q),
      .queued_i,
      .quiet_i(!under_way_q),
      .pause_o(pause),
      .restart_o(restart),
      .good_o(good),
      .samples_per_tick_log2_o(n_taken),
      .hold_acceleration_o(acceleration_taken),
      .hold_slope_o(slope_taken),
      .stop_ticks_o(stop_taken),
      .settings_fault_o(fault)
  );

  logic [100:0] asked;
  logic [100:0] taken;
  assign asked = {n, acceleration, slope, stop};
  assign taken = {n_taken, acceleration_taken, slope_taken, stop_taken};
  logic fits;
  assign fits = acceleration_taken >= 32'd8 && acceleration_taken <= 32'h8000_0000 &&
                slope_taken >= {1'b0, acceleration_taken} && slope_taken <= 33'h1_0000_0000 &&
                stop_taken >= 32'd1 && stop_taken < 32'h2000_0000;

  logic [1:0] age_q = 2'd0;  // clocks, 3 at most
  logic [100:0] taken_q[2];
  logic [100:0] asked_q;
  logic differed_q;
  logic was_active_q;
  logic was_quiet_q;
  logic was_restart_q;
  logic was_fault_q;
  logic waited_q;
  logic [2:0] calm_q;  // clocks of the same words in the quiet
  logic [1:0] wait_q;  // clocks with a program that waits, words unfit
  logic start;
  logic calm;
  assign start = start_i && !pause && rst_ni;
  assign calm  = asked == asked_q && !under_way_q && !active_q && !start;
  always_ff @(posedge clk_i) begin
    if (age_q != '1) age_q <= age_q + 2'd1;
    taken_q[0]    <= taken;
    taken_q[1]    <= taken_q[0];
    asked_q       <= asked;
    differed_q    <= asked != taken;
    was_active_q  <= active_q && rst_ni;
    was_quiet_q   <= !rst_ni || (!under_way_q && !active_q && !start);
    was_restart_q <= restart;
    was_fault_q   <= fault && rst_ni;
    waited_q      <= queued_i && !fits;
    if (!rst_ni) begin
      under_way_q <= 1'b0;
      active_q    <= 1'b0;
      calm_q      <= '0;
      wait_q      <= '0;
    end else begin
      if (start) under_way_q <= 1'b1;
      else if (leave_i && !begin_i) under_way_q <= 1'b0;
      if (start && !under_way_q) free_q <= good;
      if (under_way_q && free_q && begin_i) active_q <= 1'b1;
      else if (under_way_q && end_i) active_q <= 1'b0;
      calm_q <= calm ? {calm_q[1:0], 1'b1} : '0;
      wait_q <= (calm_q == '1 && queued_i && !fits) ? {wait_q[0], 1'b1} : '0;
    end
  end

  always_comb begin
    if (age_q < 2'd2) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (taken != taken_q[0]) begin
        OnlyInTheQuiet : assert (was_quiet_q);
        NoTickMeanwhile : assert (pause);
        BeginsAnew : assert (restart);
      end
      if (taken_q[0] != taken_q[1]) BeginsForTwoClocks : assert (restart);
      if (start) Told : assert (good == fits);
      if (active_q) RunsWithGoodOnes : assert (fits);
      if (calm_q == '1) TakenAtOnce : assert (taken == asked_q && !pause);

      if (was_fault_q) Sticky : assert (fault);
      if (was_active_q && age_q == '1 && differed_before_q) Changed : assert (fault);
      if (wait_q == '1) Waits : assert (fault);
      if (fault && !was_fault_q) NoFalseAlarm : assert (was_active_q || waited_q);

      Changes : cover (taken != taken_q[0] && was_quiet_q && !was_restart_q && fits);
      RunsOn : cover (active_q && fault);
    end
  end

  logic differed_before_q;
  always_ff @(posedge clk_i) differed_before_q <= differed_q && rst_ni;

endmodule
`default_nettype wire
