// SPDX-License-Identifier: Apache-2.0
// rtl/pulse/place_scaler.sv: every sample is taken once, in the clocks that the header states, and
// not before the rates of the one before are taken; freshness is reported once.
// control: OVERWRITES s/ \&\& !rates_valid_o)/)/
// control: UNOFFERED s/idle_q \&\& sample_valid_i/idle_q/
// control: LOSES_RATES s/if (ends) rates_valid_o/if (ends \&\& !sample_valid_i) rates_valid_o/
// control: SKIPS_AXIS s/ends = tail_q\[4\] \&\& last_axis/ends = tail_q[4]/
// control: FRESH_TWICE s/tail_q\[4\] \&\& fresh_q ?/fresh_q ?/
// control: NO_RESET s/tail_q        <= '0;//
`default_nettype none
module place_scaler_formal (
    input wire logic       clk_i,
    input wire logic       rst_ni,
    input wire logic       offer_i,
    input wire logic       take_i,
    input wire logic [1:0] ask_i
);

  localparam int Axes = 2;
  localparam int FineBits = 18;
  localparam int Clocks = Axes * (FineBits + 6);

  logic offered_q;
  logic ready;
  logic rates;
  logic [1:0] fresh_q;  // asked for and not yet told
  logic [1:0] told;
  place_scaler #(
      .Axes     (Axes),
      .FineBits (FineBits),
      .ScaleBits(40),
      .RateBits (22)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .scale_write_i (1'b0),
      .scale_axis_i  ('0),
      .scale_i       ('0),
      .sample_valid_i(offered_q),
      .sample_ready_o(ready),
      .sample_i      ('0),
      .by_axis_i     (1'b0),
      .axis_o        (),
      .position_i    ('0),
      .begins_i      (1'b0),
      .fresh_i       (fresh_q),
      .referenced_i  ('1),
      .fresh_taken_o (told),
      .rates_valid_o (rates),
      .rates_taken_i (take_i && rates),
      .read_i        (1'b0),
      .read_axis_i   ('0),
      .rate_o        (),
      .moves_o       (),
      .fresh_o       (),
      .refused_o     ()
  );

  logic started_q = 1'b0;
  logic made_q;  // rates of a sample that was taken, not yet taken themselves
  logic [5:0] wait_q;  // clocks that a sample was there and nothing in its way
  logic [1:0] due_q;  // fresh since the sample began
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    if (!rst_ni) begin
      offered_q <= 1'b0;
      fresh_q   <= '0;
      made_q    <= 1'b0;
      wait_q    <= '0;
      due_q     <= '0;
    end else begin
      if (ready) offered_q <= 1'b0;
      else if (offer_i) offered_q <= 1'b1;
      fresh_q <= (fresh_q & ~told) | ask_i;
      if (ready) made_q <= 1'b1;
      else if (take_i) made_q <= 1'b0;
      wait_q <= offered_q && !made_q && !ready ? wait_q + 1'b1 : '0;
      if (wait_q == '0) due_q <= fresh_q;
      else due_q <= due_q & ~told;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      Rates : assert (rates == made_q);
      if (ready) Offered : assert (offered_q && !made_q);
      if (offered_q && !made_q) InItsClock : assert (ready == (wait_q == 6'(Clocks)));
      Asked : assert ((told & ~fresh_q) == '0);
      if (ready) AllAreTold : assert ((due_q & ~told) == '0);
      if (told != '0) OnlyOnce : assert (wait_q == 6'(Clocks / 2) || wait_q == 6'(Clocks));

      Takes : cover (ready && told == 2'b10);
    end
  end

endmodule
`default_nettype wire
