// SPDX-License-Identifier: Apache-2.0
// The rate of time, tick by tick, in the serial build: the program of rtl/path/time_datapath.sv.
// Twin: TimeScaler::tick of hls/time_scaler.hpp. Its words: rtl/path/time_control_pkg.sv.
//
// The rate is kept relative to its direction: while it falls, it and its goal are negative. So the
// way left is positive, and every step is an addition. Turned words have their sign while it falls.
//
// A word is read from memory while the one before is written, so it does not see that word.
`default_nettype none
module time_program (
    input  wire logic                                  clk_i,
    input  wire logic                                  en_i,
    input  wire logic [                           5:0] place_i,
    output logic      [time_control_pkg::WordBits-1:0] word_o    // word of the clock before
);

  // A word continues with the one below, or with the target of its jump.
  typedef enum logic [5:0] {
    Start,
    NoBraking,
    NoStopSlope,
    // A tick's end, and the next one
    Again,
    Out,
    Send,
    Wait,
    Kind,
    Follow,
    LandAtOnce,
    LandRest,
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
    // The rest of the way when the slope stays, and when it grows
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
    // A step of a stop branch
    Stop,
    StopStep,
    StopMove,
    MayEnd,
    End,
    EndRate
  } place_t;

  // Words of the datapath's memory, and ports
  localparam logic [3:0] Rate = 4'd0;
  localparam logic [3:0] Slope = 4'd1;  // n a, of the last tick
  localparam logic [3:0] Braking = 4'd2;  // a n (n - 1) / 2: way that the rate still moves in it
  localparam logic [3:0] StopSlope = 4'd3;
  localparam logic [3:0] Way = 4'd4;
  localparam logic [3:0] Acceleration = 4'd8;  // a
  localparam logic [3:0] MaxSlope = 4'd9;
  localparam logic [3:0] ToGoal = 4'd10;
  localparam logic [3:0] Change = 4'd11;

  localparam int Bits = time_control_pkg::WordBits;
  localparam logic [Bits-1:0] One = 1;
  localparam logic [Bits-1:0] Clear = One << time_control_pkg::Clear;
  localparam logic [Bits-1:0] Turned = One << time_control_pkg::Turned;
  localparam logic [Bits-1:0] Ready = One << time_control_pkg::Ready;
  localparam logic [Bits-1:0] Sends = One << time_control_pkg::Send;
  localparam logic [Bits-1:0] Turns = One << time_control_pkg::Turn;
  localparam logic [Bits-1:0] Moves = One << time_control_pkg::Moves;
  localparam logic [Bits-1:0] Settles = One << time_control_pkg::Settles;
  localparam logic [Bits-1:0] Settled = One << time_control_pkg::Settled;
  localparam logic [Bits-1:0] Swaps = One << time_control_pkg::Swap;
  localparam logic [Bits-1:0] Coarse = One << time_control_pkg::Coarse;
  localparam logic [Bits-1:0] OfBorder = One << time_control_pkg::Border;
  localparam logic [Bits-1:0] Rests = One << time_control_pkg::Rests;
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
  function automatic logic [Bits-1:0] go_if(input logic [3:0] condition, input logic [5:0] target);
    go_if = '0;
    go_if[time_control_pkg::Condition+:4] = condition;
    go_if[time_control_pkg::Target+:6] = target;
  endfunction
  function automatic logic [Bits-1:0] stay_if(input logic [3:0] condition);
    stay_if = go_if(condition, 6'd0);
    stay_if[time_control_pkg::Stay] = 1'b1;
  endfunction
  function automatic logic [Bits-1:0] go(input logic [5:0] target);
    go = go_if(time_control_pkg::Always, target);
  endfunction

  (* ram_style = "block" *)
  logic [Bits-1:0] program_rom[64];
`ifdef FORMAL
  logic [5:0] place_q;  // the same with fewer states, for proofs
  always_ff @(posedge clk_i) if (en_i) place_q <= place_i;
  assign word_o = program_rom[place_q];
`else
  always_ff @(posedge clk_i) if (en_i) word_o <= program_rom[place_i];
`endif

  initial begin
    for (int n = 0; n < 64; n = n + 1) program_rom[n] = '0;
    program_rom[Start]       = write(Slope);
    program_rom[NoBraking]   = write(Braking);
    program_rom[NoStopSlope] = write(StopSlope) | go(Wait);
    program_rom[Again]       = Clear;
    program_rom[Out]         = Turned | add(Rate);
    program_rom[Send]        = Sends | stay_if(time_control_pkg::NotTaken);
    program_rom[Wait]        = Clear | Ready | stay_if(time_control_pkg::NoTick);
    program_rom[Kind]        = go_if(time_control_pkg::Stops, Stop);
    program_rom[Follow]      = go_if(time_control_pkg::Follows, Goal);
    program_rom[LandAtOnce]  = Swaps | Turns | write(Slope) | Moves | Settled;
    program_rom[LandRest]    = write(Braking) | add(ToGoal) | go(KeepRate);
    program_rom[Goal]        = Turned | add(ToGoal);
    program_rom[LessRate]    = less(Rate);
    program_rom[Rest]        = go_if(time_control_pkg::Moving, LessBraking);
    program_rom[Ahead]       = go_if(time_control_pkg::Positive, AtRest);
    program_rom[Turn]        = Clear | Turns;
    program_rom[Mirror]      = less(Rate);
    program_rom[Mirrored]    = write(Rate) | Clear | go(Goal);
    program_rom[AtRest]      = Rests | Settled | go_if(time_control_pkg::Settling, Again);
    program_rom[MaySwap]     = go_if(time_control_pkg::NoSwap, Near);
    program_rom[Swap]        = Clear | Swaps;
    program_rom[Border]      = Turned | add(ToGoal) | OfBorder;
    program_rom[AtBorder]    = write(Rate) | Clear | go(Goal);
    program_rom[Near]        = write(Way) | less(Acceleration) | Settles;
    program_rom[MayLand]     = go_if(time_control_pkg::Positive, Far);
    program_rom[Land]        = Clear;
    program_rom[LandGoal]    = Turned | add(ToGoal) | go(KeepRate);
    program_rom[Far]         = Clear | Settled;
    program_rom[FarRest]     = add(Way);
    program_rom[LessBraking] = less(Braking);
    program_rom[LessSlope]   = less(Slope);
    program_rom[Steady]      = less(Slope) | go_if(time_control_pkg::Negative, Down);
    program_rom[Faster]      = less(Acceleration);
    program_rom[MayFaster]   = Clear | go_if(time_control_pkg::Negative, On);
    program_rom[Bound]       = add(MaxSlope);
    program_rom[BoundSlope]  = less(Slope);
    program_rom[BoundFaster] = less(Acceleration);
    program_rom[MayBound]    = Clear | go_if(time_control_pkg::Negative, On);
    program_rom[Up]          = add(Braking);
    program_rom[UpBraking]   = add(Slope);
    program_rom[UpSlope]     = write(Braking) | Clear;
    program_rom[AddSlope]    = add(Slope);
    program_rom[UpFaster]    = add(Acceleration) | go(Move);
    program_rom[Down]        = Clear;
    program_rom[DownSlope]   = add(Slope);
    program_rom[DownSlower]  = less(Acceleration);
    program_rom[KeepSlope]   = write(Slope) | Clear;
    program_rom[DownBraking] = add(Braking);
    program_rom[LessNext]    = less(Slope);
    program_rom[KeepBraking] = write(Braking) | Clear;
    program_rom[On]          = add(Slope);
    program_rom[Move]        = write(Slope) | add(Rate) | Moves;
    program_rom[KeepRate]    = write(Rate) | go(Again);
    program_rom[Stop]        = add(StopSlope);
    program_rom[StopStep]    = add(Change);
    program_rom[StopMove]    = write(StopSlope) | add(Rate);
    program_rom[MayEnd]      = go_if(time_control_pkg::GoesOn, KeepRate);
    program_rom[End]         = Clear | Coarse;
    program_rom[EndRate]     = write(StopSlope) | go(KeepRate);
  end

endmodule
`default_nettype wire
