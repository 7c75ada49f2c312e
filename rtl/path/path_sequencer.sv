// SPDX-License-Identifier: Apache-2.0
// Profile pieces tick by tick, in the serial build: the program of rtl/path/path_datapath.sv and
// the decisions in it. Twin: PathKernel::tick of hls/path_kernel.hpp.
//
//   clock          0    5    6    13   15     n
//   rate_valid_i   1
//   rate_ready_o   1                          n + 1
//   tick_taken_o        1                             inside a piece
//   tick_taken_o             1                        no piece follows
//   tick_taken_o                  1    1              a program, a piece begins; at the earliest
//   ds_valid_o                                1       n < kSerialTickClocks of hls/clocks.hpp, +
//   ds_ready_i                                1       what it waited for a piece; every other clock
//                                                     until it is taken
//
// A tick of rate r moves time by r / 2^16 ticks; what goes beyond a piece's end is time in the next
// piece. Time waits at the end of the last piece there is. A tick waits while its piece is queued
// but not loaded. No program begins in a tick that is held. One tick is under way at a time.
`default_nettype none
module path_sequencer (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Pieces
    input  wire logic       queued_i,              // complete ones, the next included
    input  wire logic       next_valid_i,          // until next_take_o
    output logic            next_take_o,
    input  wire logic       next_final_i,
    input  wire logic [4:0] next_time_exponent_i,  // m
    input  wire logic [5:0] next_exponent_i,       // e

    // Ticks
    input  wire logic        rate_valid_i,
    output logic             rate_ready_o,
    input  wire logic [16:0] rate_i,
    input  wire logic        held_i,        // target 0
    output logic             tick_taken_o,
    output logic      [16:0] rate_o,        // of the tick under way

    // Datapath
    output logic      [path_control_pkg::Bits-1:0] control_o,
    output logic      [                       1:0] pass_o,
    input  wire logic                              negative_i, // the sum

    // Increments
    output logic      ds_valid_o,   // the sum is one
    input  wire logic ds_ready_i,
    output logic      ds_active_o,  // a program was under way
    output logic      look_o,       // the sum is time in the piece less its end

    // The present piece
    output logic active_o,
    output logic last_o
);

  // A state goes on to the one below, or to where its jump leads.
  typedef enum logic [5:0] {
    Start,
    Wait,
    TakeRate,
    AddTime,
    AddRate,
    LessEnd,
    Decide,
    // Beyond the piece's end
    MayStop,
    MayPass,
    Over,
    WholeDs,
    LessPath,
    KeepRest,
    // The next piece
    SetEnd,
    AtStart,
    NextLessEnd,
    Take,
    Whole,
    // The first piece of a program
    Begin,
    // No piece follows
    Stop,
    StopTime,
    StopAtEnd,
    // Inside: coefficients times time, from the highest on
    Inside,
    Highest,
    SetFactor,
    ReadTime,
    LoadTime,
    Product,
    RoundProduct,
    NextPower,
    // in quanta
    Scale,
    NoScale,
    Halves,
    RoundHalves,
    Double,
    AddDouble,
    // up to the piece's end
    LessDs,
    Compare,
    AtEnd,
    ReadDs,
    // never back
    Change,
    CompareChange,
    NewPath,
    Nothing,
    AddRest,
    Send,
    Hold,
    BackToPath
  } state_t;

  // Conditions of jumps
  typedef enum logic [3:0] {
    Never,
    Always,
    NoRate,
    Runs,
    Stops,
    NotLoaded,
    NotActive,
    WasNotActive,
    MoreBits,
    LastPass,
    IsAbove,
    IsExact,
    MoreHalves,
    MoreDoubles,
    Negative,
    Sent
  } condition_t;

  logic [5:0] state_q;
  logic [5:0] target;
  logic [3:0] condition;
  logic jump;

  // Words of the datapath's memory
  localparam logic [3:0] Zero = 4'd0;
  localparam logic [3:0] Time = 4'd1;  // in the piece, 16 fraction bits
  localparam logic [3:0] Factor = 4'd2;
  localparam logic [3:0] End = 4'd3;  // of the piece, 16 fraction bits
  localparam logic [3:0] Path = 4'd4;  // since the piece began
  localparam logic [3:0] Rate = 4'd5;
  localparam logic [3:0] Rest = 4'd6;  // of the piece before
  localparam logic [3:0] Ds = 4'd8;  // of the piece
  localparam logic [3:0] Coefficient = 4'd9;  // c3, c2, c1, by pass_o

  // Its control words
  localparam int Bits = path_control_pkg::Bits;
  localparam logic [Bits-1:0] One = 1;
  localparam logic [Bits-1:0] OfRate = One << path_control_pkg::OfRate;
  localparam logic [Bits-1:0] OfTicks = One << path_control_pkg::OfTicks;
  localparam logic [Bits-1:0] Clear = One << path_control_pkg::Clear;
  localparam logic [Bits-1:0] Round = One << path_control_pkg::Round;
  localparam logic [Bits-1:0] Multiply = One << path_control_pkg::Multiply;
  localparam logic [Bits-1:0] Load = One << path_control_pkg::Load;
  function automatic logic [Bits-1:0] add(input logic [3:0] place);
    add = One << path_control_pkg::Add;
    add[path_control_pkg::Read+:4] = place;
  endfunction
  function automatic logic [Bits-1:0] less(input logic [3:0] place);
    less = add(place);
    less[path_control_pkg::Minus] = 1'b1;
  endfunction
  function automatic logic [Bits-1:0] halve(input logic [3:0] place);
    halve = add(place);
    halve[path_control_pkg::Halve] = 1'b1;
  endfunction
  function automatic logic [Bits-1:0] write(input logic [3:0] place);
    write = One << path_control_pkg::Store;
    write[path_control_pkg::Write+:4] = place;
  endfunction

  // The program
  always_comb begin
    {control_o, condition, target} = {{Bits{1'b0}}, Never, Start};
    case (state_q)
      Start:         control_o = write(Zero) | Clear;
      Wait:          {control_o, condition, target} = {Clear, NoRate, Wait};
      TakeRate:      control_o = write(Rate) | OfRate;
      AddTime:       control_o = write(Rest) | add(Time);
      AddRate:       control_o = add(Rate);
      LessEnd:       control_o = write(Time) | less(End);
      Decide:        {condition, target} = {Runs, Inside};
      MayStop:       {condition, target} = {Stops, Stop};
      MayPass:       {condition, target} = {NotLoaded, MayStop};
      Over:          {control_o, condition, target} = {write(Time) | Clear, NotActive, Begin};
      WholeDs:       control_o = add(Ds);
      LessPath:      control_o = less(Path);
      KeepRest:      control_o = write(Rest) | Clear;
      SetEnd:        control_o = write(End) | OfTicks;
      AtStart:       control_o = write(Path) | add(Time);
      NextLessEnd:   control_o = less(End);
      Take:          {condition, target} = {Negative, Inside};
      Whole:         {control_o, condition, target} = {Clear, Always, ReadDs};
      Begin:         {control_o, condition, target} = {write(Time) | OfRate, Always, SetEnd};
      Stop:          {control_o, condition, target} = {Clear, WasNotActive, AddRest};
      StopTime:      control_o = add(End);
      StopAtEnd:     {control_o, condition, target} = {write(Time) | Clear, Always, ReadDs};
      Inside:        control_o = Clear;
      Highest:       control_o = add(Coefficient);
      SetFactor:     control_o = write(Factor) | Clear;
      ReadTime:      control_o = add(Time);
      LoadTime:      control_o = Load | Clear;
      Product:       {control_o, condition, target} = {Multiply | halve(Factor), MoreBits, Product};
      RoundProduct:  {control_o, condition, target} = {Round | add(Zero), LastPass, Scale};
      NextPower:     {control_o, condition, target} = {add(Coefficient), Always, SetFactor};
      Scale:         {condition, target} = {IsAbove, Double};
      NoScale:       {condition, target} = {IsExact, LessDs};
      Halves:        {control_o, condition, target} = {halve(Zero), MoreHalves, Halves};
      RoundHalves:   {control_o, condition, target} = {Round | add(Zero), Always, LessDs};
      Double:        control_o = write(Factor);
      AddDouble:     {control_o, condition, target} = {add(Factor), MoreDoubles, Double};
      LessDs:        {control_o, condition, target} = {less(Ds), Negative, Nothing};
      Compare:       {condition, target} = {Negative, BackToPath};
      AtEnd:         control_o = Clear;
      ReadDs:        control_o = add(Ds);
      Change:        control_o = less(Path);
      CompareChange: {control_o, condition, target} = {add(Path), Negative, Nothing};
      NewPath:       {control_o, condition, target} = {write(Path) | less(Path), Always, AddRest};
      Nothing:       control_o = Clear;
      AddRest:       control_o = add(Rest);
      Send:          {condition, target} = {Sent, Wait};
      Hold:          {condition, target} = {Always, Send};
      BackToPath:    {control_o, condition, target} = {add(Ds), Always, Change};
      default:       ;
    endcase
  end

  // Numbers of halves: 16 + m of a product, 34 - e of a result; below 0 it doubles
  logic held_q;
  logic [4:0] time_exponent_q;
  logic [5:0] exponent_q;
  logic [6:0] count_q;  // down from m to -15, from -1 - e to -34, or up to -36
  always_comb begin
    case (condition)
      Always:       jump = 1'b1;
      NoRate:       jump = !rate_valid_i;
      Runs:         jump = active_o && negative_i;
      Stops:        jump = last_o || (held_q && !active_o) || !queued_i;
      NotLoaded:    jump = !next_valid_i;
      NotActive:    jump = !active_o;
      WasNotActive: jump = !ds_active_o;
      MoreBits:     jump = count_q != -7'd15;
      LastPass:     jump = pass_o == 2'd3;
      IsAbove:      jump = exponent_q > 6'd34;
      IsExact:      jump = exponent_q == 6'd34;
      MoreHalves:   jump = count_q != -7'd34;
      MoreDoubles:  jump = count_q != -7'd36;
      Negative:     jump = negative_i;
      Sent:         jump = ds_ready_i;
      default:      jump = 1'b0;
    endcase
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) state_q <= Start;
    else if (jump) state_q <= target;
    else state_q <= state_q + 6'd1;
  end

  logic runs;
  logic stops;
  assign runs         = state_q == Decide && jump;
  assign stops        = state_q == MayStop && jump;
  assign rate_ready_o = state_q == Wait;
  assign next_take_o  = state_q == Take;
  assign tick_taken_o = runs || stops || next_take_o;
  assign ds_valid_o   = state_q == Send;
  assign look_o       = runs || next_take_o || (stops && active_o);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      active_o <= 1'b0;
      last_o   <= 1'b0;
    end else if (next_take_o) begin
      active_o <= 1'b1;
      last_o   <= next_final_i;
    end else if (stops) begin
      active_o <= active_o && !last_o;
      last_o   <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (rate_ready_o) begin
      rate_o <= rate_i;
      held_q <= held_i;
    end
    if (tick_taken_o) ds_active_o <= active_o || !stops;
    if (next_take_o) begin
      time_exponent_q <= next_time_exponent_i;
      exponent_q      <= next_exponent_i;
    end
    if (state_q == Inside) pass_o <= 2'd0;
    else if (state_q == Highest || state_q == NextPower) pass_o <= pass_o + 2'd1;
    if (state_q == LoadTime) count_q <= {2'b0, time_exponent_q};
    else if (state_q == Scale || state_q == NoScale) count_q <= {1'b1, ~exponent_q};
    else if (state_q == AddDouble) count_q <= count_q + 7'd1;
    else if (state_q == Product || state_q == Halves) count_q <= count_q - 7'd1;
  end

endmodule
`default_nettype wire
