// SPDX-License-Identifier: Apache-2.0
// rtl/serial/serial_sequencer.sv with its program, at Order 2: parts of the network end, each sample
// that is taken gives one first result, in bounded time while there is room; three at most are
// under way; network and samples keep apart; quiet is quiet.
// control: LOSES_SAMPLE s/active_q\[turn_q\] <= 1'b1;/active_q[turn_q] <= !land_i;/
// control: TAKES_BESIDE_NET s/sample_q <= sample_i \&\& !net_busy_o;/sample_q <= sample_i;/
// control: NEVER_HALTS s/halt = control == 3'd4;/halt = 1'b0;/
// control: QUIET_EARLY s/if (!rst_ni || fetch || active_q != '0) drain_q/if (!rst_ni || fetch) drain_q/
// control: NO_RESET s/      active_q  <= '0;//
`default_nettype none
module serial_sequencer_formal (
    input wire logic       clk_i,
    input wire logic       rst_ni,
    input wire logic       net_start_i,
    input wire logic [2:0] net_part_i,
    input wire logic       sample_i,
    input wire logic       land_i,
    input wire logic       room_i
);

  // A part's entry and its first order (serial_tracker.sv).
  logic [6:0] entry;
  logic [3:0] order;
  always_comb begin
    order = 4'd1;
    case (net_part_i)
      3'd0: begin
        entry = serial_program_pkg::WeightsEntry[6:0];
        order = 4'd2;
      end
      3'd1:    entry = serial_program_pkg::AngleEntry[6:0];
      3'd2:    entry = serial_program_pkg::StepEntry[6:0];
      default: entry = serial_program_pkg::ExpandEntry[6:0];
    endcase
  end

  logic busy;
  logic take;
  logic issued;
  logic quiet;
  serial_sequencer #(
      .Order(2),
      .AuxAxes(0),
      .Mode(0),
      .Splines(0)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .net_start_i,
      .net_entry_i(entry),
      .net_order_i(order),
      .net_busy_o(busy),
      .spline_i(1'b0),
      .sample_i,
      .land_i,
      .sample_take_o(take),
      .context_o(),
      .free_o(),
      .room_i,
      .issued_o(issued),
      .quiet_o(quiet),
      .a_address_o(),
      .b_address_o(),
      .c_address_o(),
      .d_address_o(),
      .scale_o(),
      .first_o(),
      .more_o(),
      .target_o()
  );

  logic started_q = 1'b0;
  logic reset_q;  // in the cycle before
  logic took_q;
  logic offered_q;
  logic after_net_q;  // the network was the last to run
  logic [1:0] inside_q;  // samples taken without a result
  logic [5:0] wait_q;  // for a first result, with room
  logic [5:0] offer_q;  // of a sample, with room
  logic [6:0] part_q;  // clocks of a part
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    reset_q   <= !rst_ni;
    took_q    <= take;
    offered_q <= sample_i;
    if (!rst_ni) begin
      inside_q    <= '0;
      wait_q      <= '0;
      offer_q     <= '0;
      part_q      <= '0;
      after_net_q <= 1'b0;
      took_q      <= 1'b0;
      offered_q   <= 1'b0;
    end else begin
      inside_q <= inside_q + {1'b0, take} - {1'b0, issued};
      wait_q   <= (issued || inside_q == '0 || !room_i) ? '0 : wait_q + 6'd1;
      offer_q  <= (take || !sample_i || busy || !room_i) ? '0 : offer_q + 6'd1;
      part_q   <= busy ? part_q + 7'd1 : '0;
      if (take) after_net_q <= 1'b0;
      if (net_start_i) after_net_q <= 1'b1;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      // What serial_tracker does: a sample stays until it is taken, and one clock more; a part
      // starts when all is quiet, or after another part.
      if (offered_q && !took_q) assume (sample_i);
      if (net_start_i) assume (!busy && !sample_i && !offered_q && (quiet || after_net_q));
      if (busy) assume (!sample_i);
      if (took_q) assume (sample_i);

      FewInside : assert (inside_q != 2'd3 || !take || issued);
      if (issued) NothingInvented : assert (inside_q != '0);
      if (take) Wanted : assert (offered_q && !took_q);
      if (take) Apart : assert (!busy);
      if (wait_q == 6'd50) GivesResult : assert (1'b0);
      if (offer_q == 6'd50) TakesSample : assert (1'b0);
      if (part_q == 7'd100) PartEnds : assert (1'b0);
      if (quiet) Quiet : assert (inside_q == '0 && part_q == '0);
      if (reset_q) Fresh : assert (!busy && !take && !issued && !quiet);

      Two : cover (inside_q == 2'd2);
      Resumes : cover (take && after_net_q && part_q == '0);
    end
  end

endmodule
`default_nettype wire
