// SPDX-License-Identifier: Apache-2.0
// Runs the program (serial_program.sv) on the folded datapath: one network part alone, or up to
// three samples, which take turns with frames of three words.  A rotation is nine clocks.  With
// Samples 0 there are none.
//
//   cycle      0                 1      2        3
//              place in program  word   decode   addresses_o, target_o
//
//   net_start_i   runs the part at net_entry_i, orders from net_order_i; net_busy_o until fetched
//   sample_i      a sample waits, its tau is in the memory at context_o; taken with sample_take_o
//   spline_i      whose samples they are; changes while all is quiet, before a net_start_i
//   free_o        nothing reads the tau of context_o any more
//   room_i        a rotation may issue results
//   quiet_o       no operation is under way, nor on its way to a sample
//
// Control of a frame, in its last word but two: 1 next frame; 2 the same frame with the next order
// until the orders are over (a spline's one earlier); 3 the next frame, or that after it when the
// orders are over; 4 halt; 5 halt without auxiliary axes; 6 halt up to three of them; 7 as 2, with
// all orders, then halt.
`default_nettype none
module serial_sequencer #(
    parameter int Order   = 6,  // [2, 12]
    parameter int AuxAxes = 0,  // [0, 6]
    parameter int Mode    = 0,  // 0 series, 1 polynomial
    parameter int Splines = 1,  // 0, 1
    parameter int Samples = 1   // 0 the network alone, 1
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic               net_start_i,
    input  wire logic [6+Splines:0] net_entry_i,
    input  wire logic [        3:0] net_order_i,
    output logic                    net_busy_o,

    input  wire logic       spline_i,
    input  wire logic       sample_i,
    input  wire logic       land_i,
    output logic            sample_take_o,
    output logic      [1:0] context_o,
    output logic            free_o,
    input  wire logic       room_i,
    output logic            issued_o,       // a sample's first result is on its way
    output logic            quiet_o,

    output logic [7+Splines:0] a_address_o,
    output logic [7+Splines:0] b_address_o,
    output logic [7+Splines:0] c_address_o,
    output logic [7+Splines:0] d_address_o,  // target 2: {land, 000, axis} in the low bits
    output logic [        2:0] scale_o,
    output logic               first_o,
    output logic               more_o,
    output logic [        1:0] target_o
);

  localparam int Spacing = 1 + (AuxAxes + 2) / 3;  // rotations between samples' first results
  localparam int PlaceBits = 7 + Splines;
  localparam logic [7:0] ArcEntry = (Mode == 0) ? serial_program_pkg::SeriesEntry
                                                : serial_program_pkg::PolynomialEntry;
  localparam logic [7:0] SplineEntry = (Mode == 0) ? serial_program_pkg::SeriesEntry
                                                   : serial_program_pkg::SplinePolynomialEntry;
  localparam logic [3:0] EvenFirst = 4'((Order / 2) * 2 - 1);
  localparam logic [4:0] Drain = 5'd24;

  // Start of a sample: splines and series advance by single orders, arcs' polynomials by two.
  logic                 spline;
  logic [PlaceBits-1:0] entry;
  logic [          3:0] first;
  logic [          3:0] stride;
  assign spline = (Splines != 0) && spline_i;
  assign entry  = spline ? SplineEntry[PlaceBits-1:0] : ArcEntry[PlaceBits-1:0];
  assign first  = (Mode == 0 || spline) ? 4'(Order - 1) : EvenFirst;
  assign stride = (Mode == 0 || spline) ? 4'd1 : 4'd2;

  logic [PlaceBits-1:0] net_place_q;
  logic [PlaceBits-1:0] net_frame_q;
  logic [          3:0] net_order_q;

  logic [          1:0] turn_q;
  logic [          1:0] word_q;
  logic                 run_q;
  logic                 slice_q;
  logic [          2:0] active_q;
  logic [          2:0] land_q;
  logic [          1:0] next_q;
  logic [          1:0] spacing_q;
  logic                 sample_q;
  logic [PlaceBits-1:0] follow_q;
  logic [PlaceBits-1:0] frame_q     [3];  // first frame of a resting context
  logic [          3:0] order_q     [3];

  // Fetch
  logic                 run;
  logic                 start;
  logic                 slice;
  logic                 fetch;
  logic [PlaceBits-1:0] place;
  logic [          3:0] order;
  logic                 turn_active;
  assign turn_active = Samples != 0 && active_q[turn_q];
  assign run = (turn_q == 2'd0 && word_q == 2'd0) ? room_i : run_q;
  assign start       = Samples != 0 && run && word_q == 2'd0 && turn_q == next_q && !turn_active
                     && sample_q && spacing_q == 2'd0;
  assign slice = (word_q == 2'd0) ? (start || (run && turn_active)) : slice_q;
  assign fetch = net_busy_o || (Samples != 0 && slice);
  always_comb begin
    place = (word_q == 2'd0) ? frame_q[turn_q] : follow_q;
    order = order_q[turn_q];
    if (Samples == 0 || net_busy_o) begin
      place = net_place_q;
      order = net_order_q;
    end
  end
  assign sample_take_o = start;
  assign context_o     = next_q;

  logic stall;
  logic [60:0] fetched;
  logic [60:0] word;
  serial_program #(
      .Splines(Splines)
  ) u_program (
      .clk_i,
      .en_i   (!stall),
      .place_i(place),
      .word_o (fetched)
  );

  // Decode
  logic       valid_q;
  logic       net_q;
  logic [1:0] context_q;
  logic [3:0] i_q;
  logic       flag_q;
  logic       fetched_valid_q;
  logic       fetched_net_q;
  logic [1:0] fetched_context_q;
  logic [3:0] fetched_i_q;
  logic       fetched_flag_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fetched_valid_q <= 1'b0;
      valid_q         <= 1'b0;
    end else if (!stall) begin
      fetched_valid_q <= fetch;
      valid_q         <= fetched_valid_q;
    end
    if (!stall) begin
      fetched_net_q     <= net_busy_o;
      fetched_context_q <= turn_q;
      fetched_i_q       <= order;
      fetched_flag_q    <= start ? land_i : land_q[turn_q];
      word              <= fetched;
      net_q             <= fetched_net_q;
      context_q         <= fetched_context_q;
      i_q               <= fetched_i_q;
      flag_q            <= fetched_flag_q;
    end
  end
  serial_issue #(
      .Splines(Splines)
  ) u_issue (
      .clk_i,
      .rst_ni,
      .valid_i       (valid_q),
      .word_i        (word),
      .i_i           (i_q),
      .context_i     ((Samples != 0) ? context_q : 2'd0),
      .land_i        (flag_q),
      .stall_o       (stall),
      .first_result_o(issued_o),
      .a_address_o,
      .b_address_o,
      .c_address_o,
      .d_address_o,
      .scale_o,
      .first_o,
      .more_o,
      .target_o
  );

  logic [2:0] control;
  logic [3:0] net_last;
  logic       over;
  logic       halt;
  logic       loop;
  assign control  = valid_q ? word[56:54] : 3'd0;
  assign net_last = (spline && control == 3'd2) ? 4'(Order - 1) : 4'(Order);
  assign over     = net_q ? i_q == net_last : i_q <= stride;
  assign loop     = (control == 3'd2 || control == 3'd7) && !over;
  always_comb begin
    halt = control == 3'd4;
    if (control == 3'd5) halt = AuxAxes == 0;
    if (control == 3'd6) halt = AuxAxes <= 3;
    if (control == 3'd7) halt = over;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      net_busy_o <= 1'b0;
    end else if (net_start_i) begin
      net_busy_o <= 1'b1;
    end else if (net_q && halt && !stall) begin
      net_busy_o <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (!stall) begin
      net_place_q <= net_place_q + PlaceBits'(1);
      if (net_q && control != 3'd0) begin
        if (loop) begin
          net_place_q <= net_frame_q;
          net_order_q <= net_order_q + 4'd1;
        end else begin
          net_frame_q <= net_place_q + PlaceBits'(1);
        end
      end
    end
    if (net_start_i) begin
      net_place_q <= net_entry_i;
      net_frame_q <= net_entry_i;
      net_order_q <= net_order_i;
    end
  end

  // The contexts
  logic last_word;
  assign last_word = word_q == 2'd2;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      turn_q    <= 2'd0;
      word_q    <= 2'd0;
      run_q     <= 1'b0;
      slice_q   <= 1'b0;
      active_q  <= '0;
      next_q    <= 2'd0;
      spacing_q <= 2'd0;
      sample_q  <= 1'b0;
    end else begin
      // A taken sample stays for one more clock, which starts none.
      sample_q <= sample_i && !net_busy_o;
      run_q    <= run;
      slice_q  <= slice;
      word_q   <= last_word ? 2'd0 : word_q + 2'd1;
      if (last_word) turn_q <= (turn_q == 2'd2) ? 2'd0 : turn_q + 2'd1;
      if (last_word && turn_q == 2'd2 && run && spacing_q != 2'd0) begin
        spacing_q <= spacing_q - 2'd1;
      end
      if (start) begin
        active_q[turn_q] <= 1'b1;
        next_q           <= (next_q == 2'd2) ? 2'd0 : next_q + 2'd1;
        spacing_q        <= 2'(Spacing);
      end
      if (!net_q && halt) active_q[context_q] <= 1'b0;
    end
  end
  logic [PlaceBits-1:0] advance;
  always_comb begin
    advance = PlaceBits'(3);
    if (control == 3'd3 && over) advance = PlaceBits'(6);
    if (loop) advance = '0;
  end
  always_ff @(posedge clk_i) begin
    follow_q <= place + PlaceBits'(1);
    if (start) land_q[turn_q] <= land_i;
    if (!rst_ni || (Splines != 0 && net_start_i)) begin
      for (int n = 0; n < 3; n = n + 1) begin
        frame_q[n] <= entry;
        order_q[n] <= first;
      end
    end else if (!net_q && halt) begin
      frame_q[context_q] <= entry;
      order_q[context_q] <= first;
    end else if (!net_q && control != 3'd0) begin
      frame_q[context_q] <= frame_q[context_q] + advance;
      if (control == 3'd2 || control == 3'd3) order_q[context_q] <= i_q - stride;
    end
  end

  // Free when the last word's addresses have been read, quiet when its result is in the sample.
  logic [1:0] free_q;
  logic [4:0] drain_q;
  assign free_o  = free_q == 2'd3;
  assign quiet_o = drain_q == 5'd0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || active_q[next_q] || start) free_q <= 2'd0;
    else if (free_q != 2'd3) free_q <= free_q + 2'd1;
    if (!rst_ni || fetch || active_q != '0) drain_q <= Drain;
    else if (drain_q != 5'd0) drain_q <= drain_q - 5'd1;
  end

endmodule
`default_nettype wire
