// SPDX-License-Identifier: Apache-2.0
// The rate of time, tick by tick, in the serial build: the decisions in the program
// (rtl/path/time_program.sv) of rtl/path/time_datapath.sv. Twin: TimeScaler::tick of
// hls/time_scaler.hpp.
//
//   clock        0    1             n
//   tick_i       1
//   lands_i, ..       of the tick   until sent_o
//   sent_o                          1        n < kSerialScaleClocks - 1 of hls/clocks.hpp
//   taken_i                         1        it is offered until then
`default_nettype none
module time_sequencer (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Ticks
    output logic      ready_o,
    input  wire logic tick_i,   // only when ready
    input  wire logic lands_i,  // it lands on its target
    input  wire logic stops_i,  // it is a step of a stop branch
    input  wire logic ends_i,   // it is the last one
    input  wire logic high_i,   // its target is on the fine side of 7/8
    output logic      sent_o,   // the sum is the rate
    input  wire logic taken_i,

    // Datapath
    output logic      [time_control_pkg::Bits-1:0] control_o,
    output logic      [time_control_pkg::Bits-1:0] ahead_o,     // word of the next clock
    output logic                                   fine_o,
    output logic                                   border_o,    // the goal is 7/8
    input  wire logic                              negative_i,  // the sum
    input  wire logic                              zero_i,

    output logic rests_o,  // rests on the target before the tick
    output logic moves_o   // moves with a slope
);

  // The program
  localparam int Bits = time_control_pkg::WordBits;
  logic [5:0] place;
  logic fetch;
  logic stay;
  logic jump;
  logic holds;
  logic [3:0] condition;
  logic [Bits-1:0] fetched;
  logic [Bits-1:0] word;
  time_program u_program (
      .clk_i,
      .en_i   (fetch),
      .place_i(place),
      .word_o (fetched)
  );
  program_fetch #(
      .Bits(Bits)
  ) u_fetch (
      .clk_i,
      .rst_ni,
      .stay_i   (stay),
      .jump_i   (jump),
      .target_i (word[time_control_pkg::Target+:6]),
      .place_o  (place),
      .fetch_o  (fetch),
      .fetched_i(fetched),
      .word_o   (word)
  );
  assign condition = word[time_control_pkg::Condition+:4];
  assign stay      = holds && word[time_control_pkg::Stay];
  assign jump      = holds && !word[time_control_pkg::Stay];
  assign ahead_o   = fetched[time_control_pkg::Bits-1:0];

  logic falling_q;
  logic settling_q;  // the last tick moved less than a step of slope: the next one rests
  always_comb begin
    control_o = word[time_control_pkg::Bits-1:0];
    if (word[time_control_pkg::Turned] && falling_q) control_o[time_control_pkg::Minus] = 1'b1;
  end

  always_comb begin
    case (condition)
      time_control_pkg::Always:   holds = 1'b1;
      time_control_pkg::NoTick:   holds = !tick_i;
      time_control_pkg::Stops:    holds = stops_i;
      time_control_pkg::Follows:  holds = !lands_i;
      time_control_pkg::Moving:   holds = moves_o;
      time_control_pkg::Positive: holds = !negative_i;
      time_control_pkg::Settling: holds = settling_q;
      time_control_pkg::NoSwap:   holds = !(border_o && zero_i);
      time_control_pkg::Negative: holds = negative_i;
      time_control_pkg::GoesOn:   holds = !ends_i;
      time_control_pkg::NotTaken: holds = !taken_i;
      default:                    holds = 1'b0;
    endcase
  end

  assign ready_o  = word[time_control_pkg::Ready];
  assign sent_o   = word[time_control_pkg::Send];
  assign border_o = high_i != fine_o || word[time_control_pkg::Border];
  assign rests_o  = word[time_control_pkg::Rests] && zero_i && !border_o;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      falling_q  <= 1'b0;
      moves_o    <= 1'b0;
      settling_q <= 1'b0;
    end else begin
      if (word[time_control_pkg::Turn]) falling_q <= !falling_q && !word[time_control_pkg::Swap];
      if (word[time_control_pkg::Moves]) moves_o <= !zero_i;
      if (word[time_control_pkg::Settles]) settling_q <= !zero_i;
      else if (word[time_control_pkg::Settled]) settling_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (word[time_control_pkg::Swap]) fine_o <= high_i;
    else if (word[time_control_pkg::Coarse]) fine_o <= 1'b0;
  end

endmodule
`default_nettype wire
