// SPDX-License-Identifier: Apache-2.0
// Profile pieces tick by tick, in the serial build: the program of rtl/path/path_datapath.sv.
// Twin: PathKernel::tick of hls/path_kernel.hpp. Its words: rtl/path/path_control_pkg.sv.
//
// A word is read from memory while the one before is written, so it does not see that word.
`default_nettype none
module path_program (
    input  wire logic                                  clk_i,
    input  wire logic                                  en_i,
    input  wire logic [                           5:0] place_i,
    output logic      [path_control_pkg::WordBits-1:0] word_o    // word of the clock before
);

  // A word continues with the one below, or with the target of its jump.
  typedef enum logic [5:0] {
    Start,
    // A tick's end, and the next one
    Nothing,
    AddRest,
    Send,
    Wait,
    TakeRate,
    AddTime,
    AddRate,
    KeepTime,
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
    Doubled,
    AddDouble,
    // up to the piece's end
    Forward,
    LessDs,
    Compare,
    AtEnd,
    ReadDs,
    // never back
    Change,
    CompareChange,
    NewPath,
    AddChange,
    BackToPath
  } place_t;

  // Words of the datapath's memory
  localparam logic [3:0] Zero = 4'd0;
  localparam logic [3:0] Time = 4'd1;  // time in the piece, 16 fraction bits
  localparam logic [3:0] Factor = 4'd2;
  localparam logic [3:0] End = 4'd3;  // end of the piece, 16 fraction bits
  localparam logic [3:0] Path = 4'd4;  // path since the piece began
  localparam logic [3:0] Rate = 4'd5;
  localparam logic [3:0] Rest = 4'd6;  // rest of the piece before
  localparam logic [3:0] Ds = 4'd11;  // path length of the piece
  localparam logic [3:0] Coefficient = 4'd8;  // c3, c2, c1, one after the other

  localparam int Bits = path_control_pkg::WordBits;
  localparam logic [Bits-1:0] One = 1;
  localparam logic [Bits-1:0] OfRate = One << path_control_pkg::OfRate;
  localparam logic [Bits-1:0] OfTicks = One << path_control_pkg::OfTicks;
  localparam logic [Bits-1:0] Clear = One << path_control_pkg::Clear;
  localparam logic [Bits-1:0] Round = One << path_control_pkg::Round;
  localparam logic [Bits-1:0] Multiply = One << path_control_pkg::Multiply;
  localparam logic [Bits-1:0] Choose = One << path_control_pkg::Choose;
  localparam logic [Bits-1:0] Load = One << path_control_pkg::Load;
  localparam logic [Bits-1:0] Takes = One << path_control_pkg::Take;
  localparam logic [Bits-1:0] Next = One << path_control_pkg::Next;
  localparam logic [Bits-1:0] Ready = One << path_control_pkg::Ready;
  localparam logic [Bits-1:0] Sends = One << path_control_pkg::Send;
  function automatic logic [Bits-1:0] add(input logic [3:0] place);
    add = One << path_control_pkg::Add;
    add[path_control_pkg::Read+:4] = place;
  endfunction
  function automatic logic [Bits-1:0] invert(input logic [3:0] place);
    invert = add(place);
    invert[path_control_pkg::Invert] = 1'b1;
  endfunction
  function automatic logic [Bits-1:0] halve(input logic [3:0] place);
    halve = add(place);
    halve[path_control_pkg::Halve] = 1'b1;
  endfunction
  function automatic logic [Bits-1:0] write(input logic [3:0] place);
    write = One << path_control_pkg::Store;
    write[path_control_pkg::Write+:4] = place;
  endfunction
  function automatic logic [Bits-1:0] go_if(input logic [3:0] condition, input logic [5:0] target);
    go_if = '0;
    go_if[path_control_pkg::Condition+:4] = condition;
    go_if[path_control_pkg::Target+:6] = target;
  endfunction
  function automatic logic [Bits-1:0] stay_if(input logic [3:0] condition);
    stay_if = go_if(condition, 6'd0);
    stay_if[path_control_pkg::Stay] = 1'b1;
  endfunction
  function automatic logic [Bits-1:0] go(input logic [5:0] target);
    go = go_if(path_control_pkg::Always, target);
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
    program_rom[Start] = write(Zero) | go(Wait);
    program_rom[Nothing] = Clear;
    program_rom[AddRest] = add(Rest);
    program_rom[Send] = Sends | stay_if(path_control_pkg::NotSent);
    program_rom[Wait] = Clear | Ready | stay_if(path_control_pkg::NoRate);
    program_rom[TakeRate] = write(Rate) | OfRate;
    program_rom[AddTime] = write(Rest) | add(Time);
    program_rom[AddRate] = add(Rate);
    program_rom[KeepTime] = write(Time) | invert(Zero);
    program_rom[LessEnd] = invert(End);
    program_rom[Decide] = go_if(path_control_pkg::Runs, Inside);
    program_rom[MayStop] = go_if(path_control_pkg::Stops, Stop);
    program_rom[MayPass] = go_if(path_control_pkg::NotLoaded, MayStop);
    program_rom[Over] = write(Time) | Clear | go_if(path_control_pkg::NotActive, Begin);
    program_rom[WholeDs] = invert(Ds);
    program_rom[LessPath] = invert(Path);
    program_rom[KeepRest] = write(Rest) | Clear;
    program_rom[SetEnd] = write(End) | OfTicks;
    program_rom[AtStart] = write(Path) | invert(Time);
    program_rom[NextLessEnd] = invert(End);
    program_rom[Take] = Takes | go_if(path_control_pkg::Negative, Inside);
    program_rom[Whole] = Clear | go(ReadDs);
    program_rom[Begin] = write(Time) | OfRate | go(SetEnd);
    program_rom[Stop] = Clear | go_if(path_control_pkg::WasNotActive, AddRest);
    program_rom[StopTime] = add(End);
    program_rom[StopAtEnd] = write(Time) | Clear | go(ReadDs);
    program_rom[Inside] = Clear;
    program_rom[Highest] = add(Coefficient) | Next;
    program_rom[SetFactor] = write(Factor) | Clear;
    program_rom[ReadTime] = add(Time);
    program_rom[LoadTime] = Load | Clear;
    program_rom[Product] = Multiply | Choose | halve(Zero) | stay_if(path_control_pkg::MoreBits);
    program_rom[RoundProduct] = Choose | Round | add(Zero) |
        go_if(path_control_pkg::LastPass, Scale);
    program_rom[NextPower] = add(Coefficient) | Next | go(SetFactor);
    program_rom[Scale] = Next | go_if(path_control_pkg::IsAbove, Double);
    program_rom[NoScale] = go_if(path_control_pkg::IsExact, Forward);
    program_rom[Halves] = halve(Zero) | stay_if(path_control_pkg::MoreHalves);
    program_rom[RoundHalves] = Round | add(Zero) | go(Forward);
    program_rom[Double] = write(Factor);
    program_rom[Doubled] = '0;
    program_rom[AddDouble] = add(Factor) | go_if(path_control_pkg::MoreDoubles, Double);
    program_rom[Forward] = invert(Zero) | go_if(path_control_pkg::Negative, Nothing);
    program_rom[LessDs] = invert(Ds);
    program_rom[Compare] = go_if(path_control_pkg::Negative, BackToPath);
    program_rom[AtEnd] = Clear;
    program_rom[ReadDs] = invert(Ds);
    program_rom[Change] = invert(Path);
    program_rom[CompareChange] = write(Factor) | add(Path) |
        go_if(path_control_pkg::Negative, Nothing);
    program_rom[NewPath] = write(Path) | Clear;
    program_rom[AddChange] = add(Factor) | go(AddRest);
    program_rom[BackToPath] = invert(Ds) | go(Change);
  end

endmodule
`default_nettype wire
