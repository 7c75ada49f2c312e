// SPDX-License-Identifier: Apache-2.0
// rtl/path/time_sequencer.sv, for any sum of the datapath: every tick that comes gives one rate,
// one after the other, within its clocks; the sum is 0 when the next one comes, and nothing is
// written between them. The sum may be anything, but a way that was turned is ahead and not 0.
// control: LOSES_TICK s/ready_o  = .*;/ready_o = 1'b1;/
// control: TWICE s/holds = !taken_i/holds = 1'b1/
// control: DROPS s/holds = !taken_i/holds = 1'b0/
// control: NO_RATE s/sent_o   = .*;/sent_o = 1'b0;/
// control: SWAPS_ON s/(border_o \&\& zero_i)/zero_i/
// control: KEEPS_SUM s/control_o = word.*;/control_o = '0;/
// control: NO_RESET s/      .rst_ni,/      .rst_ni(1'b1),/
// long: proved
`default_nettype none
module time_sequencer_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic tick_i,
    input wire logic lands_i,
    input wire logic stops_i,
    input wire logic ends_i,
    input wire logic high_i,
    input wire logic negative_i,
    input wire logic zero_i,
    input wire logic taken_i
);

  localparam int Most = 57;  // kSerialScaleClocks, less one to hand it over

  logic ready;
  logic sent;
  logic [time_control_pkg::Bits-1:0] control;
  logic [time_control_pkg::Bits-1:0] ahead;
  logic fine;
  logic border;
  logic rests;
  logic moves;
  time_sequencer u_dut (
      .clk_i,
      .rst_ni,
      .ready_o(ready),
      .tick_i(tick_i && ready),
      .lands_i,
      .stops_i,
      .ends_i,
      .high_i,
      .sent_o(sent),
      .taken_i,
      .control_o(control),
      .ahead_o(ahead),
      .fine_o(fine),
      .border_o(border),
      .negative_i,
      .zero_i,
      .rests_o(rests),
      .moves_o(moves)
  );
  logic unused;
  assign unused = ^{ahead, fine, border, rests, moves};

  logic started_q = 1'b0;
  logic owed_q;  // a tick came that gave no rate yet
  logic empty_q;  // the sum is 0
  logic sent_q;  // the rate waits
  logic [5:0] clocks_q;
  logic kept_high_q;
  logic mirrors;  // the rate is turned: the way's sign counts 6 clocks later, that it is 0 after 9
  logic [8:0] mirrors_q;
  assign mirrors = empty_q && control[time_control_pkg::Read+:4] == 4'd0 &&
      control[time_control_pkg::Minus];
  always_ff @(posedge clk_i) begin
    started_q   <= 1'b1;
    kept_high_q <= high_i;
    mirrors_q   <= {mirrors_q[7:0], mirrors};
    if (!rst_ni || control[time_control_pkg::Clear]) empty_q <= 1'b1;
    else if (control[time_control_pkg::Add]) empty_q <= 1'b0;
    sent_q <= rst_ni && owed_q && (sent_q || sent);
    if (!rst_ni) begin
      owed_q    <= 1'b0;
      clocks_q  <= '0;
      mirrors_q <= '0;
    end else begin
      if (tick_i && ready) owed_q <= 1'b1;
      else if (sent && taken_i) owed_q <= 1'b0;
      clocks_q <= owed_q && !sent_q ? clocks_q + 1'b1 : '0;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (owed_q && clocks_q != '0) assume (high_i == kept_high_q);
      assume (!(negative_i && zero_i));
      if (mirrors_q[5]) assume (!negative_i);
      if (mirrors_q[8]) assume (!zero_i);

      if (ready) OneAtATime : assert (!owed_q);
      if (ready) Begins : assert (control[time_control_pkg::Clear]);
      if (ready) Keeps : assert (!control[time_control_pkg::Store]);
      if (sent) RatePerTick : assert (owed_q);
      InTime : assert (clocks_q < 6'(Most));

      Sends : cover (sent && stops_i);
      Longest : cover (clocks_q == 6'(Most - 1));
    end
  end

endmodule
`default_nettype wire
