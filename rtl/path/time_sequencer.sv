// SPDX-License-Identifier: Apache-2.0
// The rate of time, tick by tick, in the serial build: the program of rtl/path/time_datapath.sv and
// the decisions in it. Twin: TimeScaler::tick of hls/time_scaler.hpp.
//
//   clock        0    1             n
//   tick_i       1
//   first_i, ..       of the tick   until sent_o
//   sent_o                          1        n < kSerialScaleClocks - 1 of hls/clocks.hpp
//   taken_i                         1        it is offered every other clock until then
//
// The rate is kept as it is seen in the direction that it has: falling, it and its goal are
// negative. So the way that is left is positive, and every step an addition.
`default_nettype none
module time_sequencer (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Ticks
    output logic      ready_o,
    input  wire logic tick_i,   // only when ready
    input  wire logic first_i,  // it lands on its target
    input  wire logic stops_i,  // it is one of a stop branch
    input  wire logic ends_i,   // the last one
    input  wire logic high_i,   // its target is on the fine side of 7/8
    output logic      sent_o,   // the sum is the rate
    input  wire logic taken_i,

    // Datapath
    output logic      [time_control_pkg::Bits-1:0] control_o,
    output logic                                   fine_o,
    output logic                                   border_o,    // the goal is 7/8
    input  wire logic                              negative_i,  // the sum
    input  wire logic                              zero_i,

    output logic rests_o,  // on the target, before the tick
    output logic moves_o   // with a slope
);

  // A state goes on to the one below, or to where its jump leads.
  typedef enum logic [5:0] {
    Start,
    NoBraking,
    NoStopSlope,
    Wait,
    Kind,
    Follow,
    First,
    FirstGoal,
    // The way to the goal
    Goal,
    LessRate,
    Rest,
    Ahead,
    Turn,
    Mirror,
    Mirrored,
    // At rest
    AtRest,
    MaySwap,
    Swap,
    Border,
    AtBorder,
    Near,
    MayLand,
    Land,
    LandGoal,
    Far,
    FarRest,
    // What is left of it when the slope stays, and when it grows
    LessBraking,
    LessSlope,
    Steady,
    Faster,
    MayFaster,
    Bound,
    BoundSlope,
    BoundFaster,
    MayBound,
    // Faster
    Up,
    UpBraking,
    UpSlope,
    AddSlope,
    UpFaster,
    // Slower
    Down,
    DownSlope,
    DownSlower,
    KeepSlope,
    DownBraking,
    LessNext,
    KeepBraking,
    // On
    On,
    Move,
    KeepRate,
    Again,
    Out,
    Send,
    Hold,
    // A step of a stop branch
    Stop,
    StopStep,
    StopMove,
    MayEnd,
    End,
    EndRate
  } state_t;

  // Conditions of jumps
  typedef enum logic [3:0] {
    Never,
    Always,
    NoTick,
    Stops,
    Follows,
    Moving,
    Positive,
    Settling,
    NoSwap,
    Negative,
    GoesOn,
    Taken
  } condition_t;

  logic [5:0] state_q;
  logic [5:0] target;
  logic [3:0] condition;
  logic jump;

  // Words of the datapath's memory, and ports
  localparam logic [3:0] Rate = 4'd0;
  localparam logic [3:0] Slope = 4'd1;  // n a: of the last tick
  localparam logic [3:0] Braking = 4'd2;  // a n (n - 1) / 2: what the rate still moves in it
  localparam logic [3:0] StopSlope = 4'd3;
  localparam logic [3:0] Way = 4'd4;
  localparam logic [3:0] Acceleration = 4'd8;  // a
  localparam logic [3:0] MaxSlope = 4'd9;
  localparam logic [3:0] ToGoal = 4'd10;
  localparam logic [3:0] Change = 4'd11;

  // Its control words
  localparam int Bits = time_control_pkg::Bits;
  localparam logic [Bits-1:0] One = 1;
  localparam logic [Bits-1:0] Clear = One << time_control_pkg::Clear;
  function automatic logic [Bits-1:0] add(input logic [3:0] place);
    add = One << time_control_pkg::Add;
    add[time_control_pkg::Read+:4] = place;
  endfunction
  function automatic logic [Bits-1:0] less(input logic [3:0] place);
    less = add(place);
    less[time_control_pkg::Minus] = 1'b1;
  endfunction
  function automatic logic [Bits-1:0] write(input logic [3:0] place);
    write = One << time_control_pkg::Store;
    write[time_control_pkg::Write+:3] = place[2:0];
  endfunction

  // The program; what is turned has its sign in falling.
  logic [Bits-1:0] control;
  logic turned;
  always_comb begin
    {turned, control, condition, target} = {1'b0, {Bits{1'b0}}, Never, Start};
    case (state_q)
      Start:       control = write(Slope);
      NoBraking:   control = write(Braking);
      NoStopSlope: control = write(StopSlope);
      Wait:        {control, condition, target} = {Clear, NoTick, Wait};
      Kind:        {condition, target} = {Stops, Stop};
      Follow:      {condition, target} = {Follows, Goal};
      First:       ;
      FirstGoal:   {control, condition, target} = {add(ToGoal), Always, KeepRate};
      Goal:        {turned, control} = {1'b1, add(ToGoal)};
      LessRate:    control = less(Rate);
      Rest:        {condition, target} = {Moving, LessBraking};
      Ahead:       {condition, target} = {Positive, AtRest};
      Turn:        control = Clear;
      Mirror:      control = less(Rate);
      Mirrored:    {control, condition, target} = {write(Rate) | Clear, Always, Goal};
      AtRest:      {condition, target} = {Settling, Again};
      MaySwap:     {condition, target} = {NoSwap, Near};
      Swap:        control = Clear;
      Border:      {turned, control} = {1'b1, add(ToGoal)};
      AtBorder:    {control, condition, target} = {write(Rate) | Clear, Always, Goal};
      Near:        control = write(Way) | less(Acceleration);
      MayLand:     {condition, target} = {Positive, Far};
      Land:        control = Clear;
      LandGoal:    {turned, control, condition, target} = {1'b1, add(ToGoal), Always, KeepRate};
      Far:         control = Clear;
      FarRest:     control = add(Way);
      LessBraking: control = less(Braking);
      LessSlope:   control = less(Slope);
      Steady:      {control, condition, target} = {less(Slope), Negative, Down};
      Faster:      control = less(Acceleration);
      MayFaster:   {control, condition, target} = {Clear, Negative, On};
      Bound:       control = add(MaxSlope);
      BoundSlope:  control = less(Slope);
      BoundFaster: control = less(Acceleration);
      MayBound:    {control, condition, target} = {Clear, Negative, On};
      Up:          control = add(Braking);
      UpBraking:   control = add(Slope);
      UpSlope:     control = write(Braking) | Clear;
      AddSlope:    control = add(Slope);
      UpFaster:    {control, condition, target} = {add(Acceleration), Always, Move};
      Down:        control = Clear;
      DownSlope:   control = add(Slope);
      DownSlower:  control = less(Acceleration);
      KeepSlope:   control = write(Slope) | Clear;
      DownBraking: control = add(Braking);
      LessNext:    control = less(Slope);
      KeepBraking: control = write(Braking) | Clear;
      On:          control = add(Slope);
      Move:        control = write(Slope) | add(Rate);
      KeepRate:    control = write(Rate);
      Again:       control = Clear;
      Out:         {turned, control} = {1'b1, add(Rate)};
      Send:        {condition, target} = {Taken, Wait};
      Hold:        {condition, target} = {Always, Send};
      Stop:        control = add(StopSlope);
      StopStep:    control = add(Change);
      StopMove:    control = write(StopSlope) | add(Rate);
      MayEnd:      {condition, target} = {GoesOn, KeepRate};
      End:         control = Clear;
      EndRate:     {control, condition, target} = {write(StopSlope), Always, KeepRate};
      default:     ;
    endcase
  end

  logic falling_q;
  logic settling_q;  // the last tick moved less than a step of slope: the next one rests
  always_comb begin
    control_o = control;
    if (turned && falling_q) control_o[time_control_pkg::Minus] = 1'b1;
  end

  always_comb begin
    case (condition)
      Always:   jump = 1'b1;
      NoTick:   jump = !tick_i;
      Stops:    jump = stops_i;
      Follows:  jump = !first_i;
      Moving:   jump = moves_o;
      Positive: jump = !negative_i;
      Settling: jump = settling_q;
      NoSwap:   jump = !(border_o && zero_i);
      Negative: jump = negative_i;
      GoesOn:   jump = !ends_i;
      Taken:    jump = taken_i;
      default:  jump = 1'b0;
    endcase
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) state_q <= Start;
    else if (jump) state_q <= target;
    else state_q <= state_q + 6'd1;
  end

  assign ready_o  = state_q == Wait;
  assign sent_o   = state_q == Send;
  assign border_o = high_i != fine_o || state_q == Border;
  assign rests_o  = state_q == AtRest && zero_i && !border_o;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      falling_q  <= 1'b0;
      moves_o    <= 1'b0;
      settling_q <= 1'b0;
    end else begin
      if (state_q == Turn) falling_q <= !falling_q;
      if (state_q == Move) moves_o <= !zero_i;
      if (state_q == Near) settling_q <= !zero_i;
      else if (state_q == Far || state_q == AtRest) settling_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (state_q == First || state_q == Swap) fine_o <= high_i;
    else if (state_q == End) fine_o <= 1'b0;
  end

endmodule
`default_nettype wire
