// SPDX-License-Identifier: Apache-2.0
// Rates of the axes on their way to step_axis, so shaped that what swings behind a drive is where
// the path is: of the last places p(n) of an axis
//
//   q(n) = p(n-k) + near (p(n) - p(n-k)) + far (p(n-k) - p(n-2k))
//
// is the place that its steps go to. k and both gains are words of the axis. Twin:
// hls/input_shaper.hpp.
//
//   clock      0            Axes - 1    26 Axes + 1    ..
//   load_i     axis 0  ..   the last
//   load_o                              axis 0         ..
//
// A period without rates is one in which no axis has moved. fresh_i: the axis stands, and has stood
// here before. Memory: a word of PlaceBits for each place that is kept, of 4 axes or 16.
`default_nettype none
module input_shaper #(
    parameter int Axes       = 3,   // [1, 9]
    parameter int PeriodLog2 = 13,  // [7, 13]
    parameter int Places     = 64   // [64, 512], a power of two: that are kept of an axis
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Words, written while off_i: of an axis k, 2 k < Places, or a gain of 2^-13, signed. They
    // count until the axes are off again: then who does not write any has q = p.
    input wire logic        off_i,
    input wire logic        write_i,
    input wire logic [ 1:0] kind_i,   // k, near, far
    input wire logic [ 3:0] axis_i,
    input wire logic [17:0] value_i,

    // Rates, axis by axis: rtl/pulse/sample_period.sv
    input wire logic [Axes-1:0] load_i,
    input wire logic none_i,
    input wire logic fresh_i,
    input wire logic moves_i,
    input wire logic refused_i,
    input wire logic [pulse_pkg::StepFraction+PeriodLog2-1:0] rate_i,
    input wire logic [Axes-1:0] referenced_i,

    // The same, shaped
    output logic [Axes-1:0] load_o,
    output logic fresh_o,
    output logic moves_o,
    output logic refused_o,
    output logic [pulse_pkg::StepFraction+PeriodLog2-1:0] rate_o,
    output logic settled_o  // all axes are at their places, and have not moved for 2 k samples
);

  localparam int Clocks = 25;  // an axis
  initial if (Axes < 1 || Axes > 9) $fatal(1, "Axes must be in [1, 9]");
  initial if (PeriodLog2 > 13) $fatal(1, "PeriodLog2 must be at most 13 with a shaper");
  initial
    if (Axes * (Clocks + 2) + 6 > 2 ** PeriodLog2)
      $fatal(1, "27 clocks an axis and 6 must fit in a period");
  initial
    if (Places < 64 || Places > 512 || 2 ** $clog2(Places) != Places)
      $fatal(1, "Places must be a power of two in [64, 512]");

  localparam int RateBits = pulse_pkg::StepFraction + PeriodLog2;
  localparam int Address = $clog2(Places);
  localparam int AxisBits = (Axes > 4) ? 4 : 2;
  localparam int PlaceBits = RateBits + Address;  // sum of as many rates
  localparam int Whole = 5;  // bits of a gain before its fraction
  localparam int SumBits = PlaceBits + Whole + 2;

  // Rates as they come
  logic [RateBits+1:0] rates[16];
  logic [3:0] load_axis;
  always_comb begin
    load_axis = '0;
    for (int a = 0; a < Axes; a++) if (load_i[a]) load_axis = 4'(a);
  end
  logic counts;
  assign counts = !none_i && moves_i;
  always_ff @(posedge clk_i)
    if (load_i != '0)
      rates[load_axis] <= {
        refused_i && !none_i,
        fresh_i && !none_i,
        (counts || (fresh_i && !none_i)) ? rate_i : RateBits'(0)
      };

  // One axis after the other, in Clocks clocks
  logic work_q;
  logic [3:0] axis_q;
  logic [4:0] clock_q;
  logic last;
  assign last = clock_q == 5'(Clocks - 1);
  logic [Address-1:0] now_q;  // where this period's places stand
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      work_q  <= 1'b0;
      axis_q  <= '0;
      clock_q <= '0;
      now_q   <= '0;
    end else if (load_i[Axes-1]) begin
      work_q  <= 1'b1;
      axis_q  <= '0;
      clock_q <= '0;
      now_q   <= now_q + 1'b1;
    end else if (work_q) begin
      clock_q <= last ? '0 : clock_q + 1'b1;
      if (last) axis_q <= axis_q + 1'b1;
      if (last && axis_q == 4'(Axes - 1)) work_q <= 1'b0;
    end
  end

  // Words of the axis: one comes in each of its first clocks
  logic on_q, off_q;
  always_ff @(posedge clk_i) begin
    off_q <= off_i;
    if (!rst_ni || (off_i && !off_q)) on_q <= 1'b0;
    else if (write_i) on_q <= 1'b1;
  end
  logic [17:0] words[64];
  logic [17:0] word, near_q, far_q;
  logic [Address-1:0] delay_q;
  assign word = on_q ? words[{clock_q[1:0], axis_q}] : '0;
  always_ff @(posedge clk_i) begin
    if (write_i) words[{kind_i, axis_i}] <= value_i;
    if (clock_q == 5'd0) delay_q <= word[Address-1:0];
    if (clock_q == 5'd1) near_q <= word;
    if (clock_q == 5'd2) far_q <= word;
  end

  // Its state
  logic [PlaceBits-1:0] place[16];
  logic [PlaceBits-1:0] given[16];
  logic [  Address-1:0] known[16];  // places that are kept since it was fresh
  logic fresh_q, refused_q;
  logic [RateBits-1:0] rate_q;
  logic [PlaceBits-1:0] place_q, given_q, next_place;
  logic [Address-1:0] known_q;
  assign next_place = place_q + PlaceBits'($signed(rate_q));
  always_ff @(posedge clk_i) begin
    if (work_q && clock_q == 5'd0) begin
      {refused_q, fresh_q, rate_q} <= rates[axis_q];
      place_q <= place[axis_q];
      given_q <= given[axis_q];
      known_q <= known[axis_q];
    end
    if (work_q && clock_q == 5'd1) place_q <= next_place;
  end

  // Places of the axis: now, k samples and 2 k samples before. What was before it was fresh is 0.
  logic [PlaceBits-1:0] places[2**(Address+AxisBits)];
  logic [PlaceBits-1:0] read_q;
  logic [Address-1:0] back;
  logic unknown_q;
  assign back = (clock_q == 5'd2) ? delay_q : Address'(delay_q << 1);
  always_ff @(posedge clk_i) begin
    if (work_q && clock_q == 5'd1) places[{axis_q[AxisBits-1:0], now_q}] <= next_place;
    read_q <= places[{axis_q[AxisBits-1:0], now_q-back}];
    unknown_q <= back > known_q;
  end
  logic [PlaceBits-1:0] earlier, way;
  assign earlier = unknown_q ? '0 : read_q;

  // Ways between them
  logic [PlaceBits-1:0] middle_q, near_way_q, both_way_q, far_way_q;
  assign way = ((clock_q == 5'd5) ? middle_q : place_q) - earlier;
  always_ff @(posedge clk_i) begin
    if (clock_q == 5'd3) {middle_q, near_way_q} <= {earlier, way};
    if (clock_q == 5'd4) both_way_q <= way;
    if (clock_q == 5'd5) far_way_q <= way;
  end

  // The sum: a bit of both gains a clock, the lowest first; what falls out is never needed again.
  logic [SumBits-1:0] sum_q, added, part;
  logic signed [PlaceBits+Whole-1:0] parts;
  logic [17:0] near_bits_q, far_bits_q;
  always_comb begin
    case ({
      far_bits_q[0], near_bits_q[0]
    })
      2'b00:   parts = '0;
      2'b01:   parts = {near_way_q, Whole'(0)};
      2'b10:   parts = {far_way_q, Whole'(0)};
      default: parts = {both_way_q, Whole'(0)};
    endcase
  end
  assign part  = SumBits'(parts);
  assign added = (clock_q == 5'd23) ? sum_q - part : sum_q + part;

  logic [PlaceBits-1:0] shaped, moved;
  logic referenced, rest, rest_q;  // of the axes so far
  assign rest = (rest_q || axis_q == '0) &&
      (!referenced || fresh_q || (near_way_q == '0 && far_way_q == '0 && moved == '0));
  assign shaped = middle_q + sum_q[PlaceBits-1:0];
  assign moved = shaped - given_q;
  assign referenced = (Axes'(1) << axis_q & referenced_i) != '0;
  logic [RateBits+2:0] shaped_rates[16];
  always_ff @(posedge clk_i) begin
    if (work_q) begin
      case (clock_q)
        5'd1: place[axis_q] <= fresh_q ? '0 : next_place;
        5'd5: begin
          near_bits_q <= near_q;
          far_bits_q  <= far_q;
          sum_q       <= '0;
        end
        5'd24: begin
          given[axis_q] <= fresh_q ? '0 : shaped;
          known[axis_q] <= fresh_q ? '0 : (known_q == '1) ? known_q : known_q + 1'b1;
          shaped_rates[axis_q] <= {
            refused_q || (!fresh_q && referenced &&
                moved[PlaceBits-1:RateBits-1] != {(Address + 1) {moved[RateBits-1]}}),
            fresh_q,
            !fresh_q && referenced && moved != '0,
            fresh_q ? rate_q : moved[RateBits-1:0]
          };
          rest_q <= rest;
          if (axis_q == 4'(Axes - 1)) settled_o <= rest;
        end
        default: begin
          sum_q <= {added[SumBits-1], added[SumBits-1:1]};
          near_bits_q <= {1'b0, near_bits_q[17:1]};
          far_bits_q <= {1'b0, far_bits_q[17:1]};
        end
      endcase
    end
    if (!rst_ni) settled_o <= 1'b1;
  end

  // Out together, an axis a clock, as they have come
  logic [3:0] out_q;
  logic outs_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      outs_q <= 1'b0;
      out_q  <= '0;
      load_o <= '0;
    end else begin
      if (work_q && last && axis_q == 4'(Axes - 1)) outs_q <= 1'b1;
      else if (out_q == 4'(Axes - 1)) outs_q <= 1'b0;
      out_q  <= (outs_q && out_q != 4'(Axes - 1)) ? out_q + 1'b1 : '0;
      load_o <= outs_q ? Axes'(1) << out_q : '0;
    end
    {refused_o, fresh_o, moves_o, rate_o} <= shaped_rates[out_q];
  end

endmodule
`default_nettype wire
