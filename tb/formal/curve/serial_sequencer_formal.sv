// SPDX-License-Identifier: Apache-2.0
// rtl/serial/serial_sequencer.sv with its program, as serial_environment.sv uses it: a sample that
// is taken has its frames in the turns that follow, as many as it has, and its results leave at
// their clock, in order, with its land bit; no third result is on its way; tau stays until it has
// been read; a part of the network has its words; quiet is quiet; all of it in bounded time.
// A reset lasts two clocks.
//
// A sample has no frame in rotations without room: its bounds are in rotations with room.
// configuration: order_2 Order=2 AuxAxes=4 Mode=0 Splines=1
// configuration: order_6 Order=6 AuxAxes=0 Mode=0 Splines=0
// configuration: order_12 Order=12 AuxAxes=6 Mode=1 Splines=1
// long: proved.order_12
// control: LOSES_SAMPLE s/active_q\[turn_q\] <= 1'b1;/active_q[turn_q] <= !land_i;/
// control: STARTS_LATE s/run \&\& word_q == 2'd0 \&\& turn_q/run \&\& turn_q/
// control: MIXES_SAMPLES s/2'(Spacing)/2'(Spacing - 1)/
// control: SKIPS_FRAME s/advance = PlaceBits'(3)/advance = PlaceBits'(6)/
// control: OTHER_LAND s/land_i : land_q\[turn_q\]/land_i : land_q[0]/
// control: ORDER_MISSING s/net_last = .*/net_last = 4'(Order - 1);/
// control: NEVER_HALTS s/halt = control == 3'd4;/halt = 1'b0;/
// control: NEVER_TAKES s/spacing_q != 2'd0) begin/spacing_q == 2'd3) begin/
// control: NO_ROOM_NEEDED s/? room_i : run_q/? 1'b1 : run_q/
// control: FREE_EARLY s/free_q == 2'd3/free_q != 2'd0/
// control: QUIET_EARLY s/fetch || active_q != '0) drain_q/fetch) drain_q/
// control: STALE_ENTRY s/Splines != 0 \&\& net_start_i/1'b0/
// control: NO_RESET s/      active_q  <= '0;//
// forget: u_core.u_dut.net_place_q u_core.u_dut.net_frame_q unless u_core.u_dut.net_busy_o
// forget: u_core.u_dut.net_order_q unless u_core.u_dut.net_busy_o
// forget: u_core.u_dut.follow_q unless u_core.u_dut.slice_q
// forget: u_core.u_dut.fetched u_core.u_dut.fetched_net_q unless u_core.u_dut.fetched_valid_q
// forget: u_core.u_dut.fetched_context_q unless u_core.u_dut.fetched_valid_q
// forget: u_core.u_dut.fetched_i_q u_core.u_dut.fetched_flag_q unless u_core.u_dut.fetched_valid_q
// forget: u_core.u_dut.word u_core.u_dut.net_q u_core.u_dut.context_q unless u_core.u_dut.valid_q
// forget: u_core.u_dut.i_q u_core.u_dut.flag_q unless u_core.u_dut.valid_q
// forget: u_core.u_dut.land_q[0] unless u_core.u_dut.active_q[0]
// forget: u_core.u_dut.land_q[1] unless u_core.u_dut.active_q[1]
// forget: u_core.u_dut.land_q[2] unless u_core.u_dut.active_q[2]
`default_nettype none
module serial_sequencer_formal #(
    parameter int Order   = 3,
    parameter int AuxAxes = 1,
    parameter int Mode    = 1,
    parameter int Splines = 1
) (
    input wire logic       clk_i,
    input wire logic       rst_ni,
    input wire logic [2:0] act_i,
    input wire logic       land_i,
    input wire logic       user_take_i
);

  localparam int Groups = 1 + (AuxAxes + 2) / 3;  // frames with three results each

  logic net_start;
  logic busy;
  logic spline;
  logic sample;
  logic take;
  logic [1:0] free_context;
  logic free;
  logic issued;
  logic quiet;
  logic [1:0] held;
  logic [7+Splines:0] a_address;
  logic [7+Splines:0] b_address;
  logic [7+Splines:0] d_address;
  logic [1:0] target;
  serial_environment #(
      .Order(Order),
      .AuxAxes(AuxAxes),
      .Mode(Mode),
      .Splines(Splines)
  ) u_core (
      .clk_i,
      .rst_ni,
      .act_i,
      .land_i,
      .take_i(user_take_i),
      .net_start_o(net_start),
      .net_busy_o(busy),
      .spline_o(spline),
      .sample_o(sample),
      .sample_take_o(take),
      .context_o(free_context),
      .free_o(free),
      .quiet_o(quiet),
      .issued_o(issued),
      .held_o(held),
      .a_address_o(a_address),
      .b_address_o(b_address),
      .c_address_o(),
      .d_address_o(d_address),
      .more_o(),
      .target_o(target)
  );

  // The samples of this turn and of the next two: land bit, and frame, counted from 1.
  logic [4:0] first;  // with results
  logic [4:0] last;
  always_comb begin
    first = spline ? 5'(Order + 3) : 5'(4 + Order / 2);
    if (Mode == 0) first = 5'(Order);
    last = first + 5'(Groups - 1);
  end
  logic [1:0] turn_q;
  logic [1:0] word_q;
  logic run_q;
  logic [5:0] here_q;
  logic [5:0] soon_q;
  logic [5:0] later_q;
  logic begins;
  logic rotation;  // one with room begins
  logic runs;
  logic [5:0] here;
  assign begins   = turn_q == 2'd0 && word_q == 2'd0;
  assign rotation = begins && !held[1];
  assign runs     = begins ? rotation : run_q;
  always_comb begin
    here = here_q;
    if (word_q == 2'd0 && runs) begin
      if (take) here = {land_i, 5'd1};
      else if (here_q != '0) here = here_q + 6'd1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      turn_q  <= 2'd0;
      word_q  <= 2'd0;
      run_q   <= 1'b0;
      here_q  <= '0;
      soon_q  <= '0;
      later_q <= '0;
    end else begin
      word_q <= (word_q == 2'd2) ? 2'd0 : word_q + 2'd1;
      run_q  <= runs;
      here_q <= here;
      if (word_q == 2'd2) begin
        turn_q  <= (turn_q == 2'd2) ? 2'd0 : turn_q + 2'd1;
        here_q  <= soon_q;
        soon_q  <= later_q;
        later_q <= (here_q[4:0] == last) ? '0 : here_q;
      end
    end
  end

  // Land bit and group of results, from 1, of the word that is fetched, and where it goes.
  logic [2:0] group;
  logic [2:0] fetched_q;
  logic [2:0] decoded_q;
  logic [2:0] issued_q;
  always_comb begin
    group = '0;
    if (runs && here[4:0] >= first) group = {here[5], 2'(here[4:0] - first + 5'd1)};
  end
  always_ff @(posedge clk_i) begin
    fetched_q <= rst_ni ? group : '0;
    decoded_q <= rst_ni ? fetched_q : '0;
    issued_q  <= rst_ni ? decoded_q : '0;
  end
  logic [3:0] context_row;  // of the turn before, which is issued
  logic [3:0] axis;
  logic [7+Splines:0] tau;  // of the context that is next
  assign context_row = (turn_q == 2'd0) ? 4'd15 : 4'd12 + {2'b00, turn_q};
  assign axis        = 4'(3 * (issued_q[1:0] - 2'd1)) + {2'b00, word_q};
  assign tau         = (8 + Splines)'({4'd13 + {2'b00, free_context}, 4'd3});

  // Time
  logic started_q = 1'b0;
  logic low_q = 1'b0;  // reset in the clock before
  logic reset_q = 1'b0;  // and in that before it
  logic [1:0] part_q;
  logic [10:0] words_q;  // of the part until now
  logic [10:0] words;
  logic [2:0] offer_q;  // rotations in which a sample has waited
  logic [4:0] lull_q;  // rotations since the last one was taken
  always_comb begin
    case (part_q)
      2'd0:    words = 11'(11 * (Order - 1));
      2'd1:    words = 11'(11 * Order + 18);
      2'd2:    words = 11'd18;
      default: words = 11'(15 * Order + 14);
    endcase
  end
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    low_q     <= !rst_ni;
    reset_q   <= low_q;
    if (!rst_ni) begin
      part_q  <= 2'd0;
      words_q <= '0;
      offer_q <= '0;
      lull_q  <= '0;
    end else begin
      words_q <= busy ? words_q + 11'd1 : '0;
      if (net_start) part_q <= act_i[1:0];
      else if (!busy) part_q <= 2'd0;
      if (!sample) offer_q <= '0;
      else if (rotation) offer_q <= offer_q + 3'd1;
      if (sample || busy || quiet) lull_q <= '0;
      else if (rotation) lull_q <= lull_q + 5'd1;
    end
  end

  always_comb begin
    if (!started_q || (low_q && !reset_q)) assume (!rst_ni);
    if (started_q && rst_ni) begin
      // Samples
      if (take) Wanted : assert (sample && !busy && here_q == '0 && free_context == turn_q);
      FirstResult : assert (issued == (decoded_q[1:0] == 2'd1 && word_q == 2'd2));
      Results : assert ((target == 2'd2) == (issued_q != '0));
      if (issued_q != '0) begin
        InOrder : assert (d_address[3:0] == axis && b_address[7:4] == context_row);
        Land : assert (d_address[7] == issued_q[2]);
      end
      if (group[1:0] == 2'd1) NotMixed : assert (soon_q[4:0] < first && later_q[4:0] < first);
      Room : assert (held != 2'd3);
      if (free || sample) begin
        KeepsTau : assert (target == 2'd0 || (a_address != tau && b_address != tau));
      end

      // The network
      if (busy) Apart : assert (here_q == '0 && soon_q == '0 && later_q == '0);
      if (!busy && words_q != '0 && !spline) Part : assert (words_q == words);
      SplinePart : assert (words_q <= 11'(4 * Order * Order + 40 * Order + 120));

      // All of it
      if (quiet) begin
        Quiet : assert (words_q == '0 && target == 2'd0);
        NoSample : assert (here_q == '0 && soon_q == '0 && later_q == '0);
      end
      Taken : assert (offer_q <= 3'(Groups + 1));
      if (lull_q > last) Frees : assert (free);
      Settles : assert (lull_q <= last + 5'd4);
      if (low_q) Fresh : assert (!busy && !take && !issued && !quiet && target == 2'd0);

      Three : cover (here_q != '0 && soon_q != '0 && later_q != '0);
      Waits : cover (held == 2'd2 && soon_q != '0);
      NextStep : cover (take && quiet);
      OfSplines : cover (issued && spline);
    end
  end

endmodule
`default_nettype wire
