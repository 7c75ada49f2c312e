// SPDX-License-Identifier: Apache-2.0
// Polynomials without constant term by Horner's rule, `Lanes` of them in the same variable:
//
//     a = 0;  for p = 0 .. Passes-1:  a = floor((coefficient[p] + a) x / 2^Shift + 1/2);  d_o = a
//
// with LastShift for the last pass.  coefficient[0] is that of the highest power.  The coefficients
// live here, in banks: write a bank while no evaluation uses it, then name it in the low bits of an
// evaluation's tag.
//
// A multiplier per lane does Interval passes; there are ceil(Passes / Interval) of them.  `phase_i`
// counts enabled clocks modulo Interval; an evaluation enters in phase 0.
//
//   enabled clock   0              Latency         Interval   Loop   Latency
//   phase_i         0                              1          6      6 Passes + 1
//   valid_i         1                              2          7      7 Passes
//   x_i, tag_i      x, tag                         4, 8       9      9 Passes
//   valid_o                        1
//   d_o, tag_o                     d, tag
//
// Reset clears what is under way.  Coefficients are written whether enabled or not.
// No overflow as long as every a and every sum fits Bits: see to it when writing coefficients.
`default_nettype none
module horner #(
    parameter int Passes    = 6,      // [1, 12]
    parameter int Lanes     = 1,      // [1, 6]
    parameter int Bits      = 36,     // [18, 36]
    parameter int Shift     = 35,     // [16, Bits - 1]
    parameter int LastShift = Shift,  // [16, Bits - 1]
    parameter int Interval  = 1,      // 1, 2, 4, 8
    parameter int BankBits  = 2,      // [1, 5]
    parameter int TagBits   = 2,      // [BankBits, 28]
    parameter int Form      = 0       // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic en_i,

    // Coefficients of one pass, of the lanes named, lane 0 in the low bits
    input wire logic                  write_i,
    input wire logic [     Lanes-1:0] write_lanes_i,
    input wire logic [  BankBits-1:0] write_bank_i,
    input wire logic [           3:0] write_pass_i,
    input wire logic [Lanes*Bits-1:0] write_coef_i,

    // Evaluations
    input  wire logic        [           2:0] phase_i,
    input  wire logic                         valid_i,
    input  wire logic signed [      Bits-1:0] x_i,
    input  wire logic        [   TagBits-1:0] tag_i,
    output logic                              valid_o,
    output logic             [Lanes*Bits-1:0] d_o,
    output logic             [   TagBits-1:0] tag_o
);

  initial if (Passes < 1 || Passes > 12) $fatal(1, "Passes must be in [1, 12]");
  initial if (Lanes < 1 || Lanes > 6) $fatal(1, "Lanes must be in [1, 6]");
  initial if (Bits < 18 || Bits > 36) $fatal(1, "Bits must be in [18, 36]");
  initial if (Shift < 16 || Shift >= Bits) $fatal(1, "Shift must be in [16, Bits - 1]");
  initial if (LastShift < 16 || LastShift >= Bits) $fatal(1, "LastShift must be in [16, Bits - 1]");
  initial
    if (LastShift != Shift && Interval == 2 && Passes % 2 == 0)
      $fatal(1, "LastShift needs the last pass alone in its stage");
  initial if (BankBits < 1 || BankBits > 5) $fatal(1, "BankBits must be in [1, 5]");
  initial if (TagBits < BankBits || TagBits > 28) $fatal(1, "TagBits must be in [BankBits, 28]");
  initial
    if (Interval != 1 && Interval != 2 && Interval != 4 && Interval != 8)
      $fatal(1, "Interval must be 1, 2, 4 or 8");

  localparam int Loop = curvecore_pkg::horner_loop(Interval);
  localparam int Stages = (Passes + Interval - 1) / Interval;
  localparam int PassBits = $clog2(Interval);
  localparam int Address = PassBits + BankBits;
  localparam int WordBits = TagBits + Bits;

  logic [2:0] place_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) place_q <= 3'd0;
    else if (en_i) place_q <= (place_q == 3'(Loop - 2)) ? 3'd0 : place_q + 3'd1;
  end

  // The next clock's phase: every stage has registers of its own for it.
  logic [2:0] next_phase;
  always_comb begin
    next_phase = phase_i;
    if (en_i) next_phase = (phase_i + 3'd1) & 3'(Interval - 1);
    if (!rst_ni) next_phase = 3'd0;
  end

  // Index 0: the input; s + 1: what leaves stage s.
  logic                       loop_valid[        Stages+1];
  logic        [WordBits-1:0] loop_word [        Stages+1];
  logic signed [      Bits:0] late      [(Stages+1)*Lanes];  // a word and the bit below
  assign loop_valid[0] = valid_i;
  assign loop_word[0]  = {tag_i, x_i};
  for (genvar l = 0; l < Lanes; l++) begin : g_start
    assign late[l] = '0;
  end

  for (genvar s = 0; s < Stages; s++) begin : g_stage
    logic [2:0] phase;
    logic       first;
    local_copy #(
        .Bits(3)
    ) u_phase (
        .clk_i,
        .data_i(next_phase),
        .data_o(phase)
    );
    assign first = (Interval == 1) || phase == 3'd0;

    logic [WordBits-1:0] slot_word;
    horner_slot #(
        .Bits(WordBits),
        .Loop(Loop)
    ) u_slot (
        .clk_i,
        .rst_ni,
        .en_i,
        .first_i(first),
        .place_i(place_q),
        .valid_i(loop_valid[s]),
        .word_i(loop_word[s]),
        .slot_word_o(slot_word),
        .loop_valid_o(loop_valid[s+1]),
        .loop_word_o(loop_word[s+1])
    );

    logic [Bits-1:0] x;
    delay_line #(
        .Bits  (Bits),
        .Clocks((Interval > 2) ? 3 : 2)
    ) u_x (
        .clk_i,
        .rst_ni,
        .en_i,
        .data_i(slot_word[Bits-1:0]),
        .data_o(x)
    );

    // Pass p = s Interval + phase.
    logic               write;
    logic [Address-1:0] write_address;
    logic [Address-1:0] address;
    assign write = write_i && (write_pass_i >> PassBits) == 4'(s);
    if (Interval > 1) begin : g_pass
      assign write_address = {write_pass_i[PassBits-1:0], write_bank_i};
      assign address       = {phase[PassBits-1:0], slot_word[Bits+:BankBits]};
    end else begin : g_one_pass
      assign write_address = write_bank_i;
      assign address       = slot_word[Bits+:BankBits];
    end

    // The last pass is alone in its stage up to Interval = 2, else it has its phase.
    localparam int Own = (s == Stages - 1 && Interval <= 2) ? LastShift : Shift;
    localparam int Other = (s == Stages - 1) ? LastShift : Shift;
    logic next_last;
    assign next_last = next_phase == 3'((Passes - 1) % Interval);
    for (genvar l = 0; l < Lanes; l++) begin : g_lane
      horner_stage #(
          .Bits(Bits),
          .Shift(Own),
          .LastShift(Other),
          .Address(Address),
          .Interval(Interval),
          .First(s == 0 ? 1 : 0),
          .Last(s == Stages - 1 ? 1 : 0),
          .Form(Form)
      ) u_stage (
          .clk_i,
          .en_i,
          .write_i(write && write_lanes_i[l]),
          .write_address_i(write_address),
          .write_coef_i(write_coef_i[l*Bits+:Bits]),
          .address_i(address),
          .first_i(first),
          .next_last_i(next_last),
          .x_i(x),
          .previous_i(late[s*Lanes+l]),
          .late_o(late[(s+1)*Lanes+l])
      );
    end
  end

  // The last pass has come back.  With one pass per stage its product is a clock behind its tag.
  if (Interval > 1) begin : g_result
    localparam int Back = Passes % Interval;
    assign valid_o = loop_valid[Stages] && phase_i == 3'(Back);
    assign tag_o   = loop_word[Stages][Bits+:TagBits];
  end else begin : g_late_result
    logic               valid_q;
    logic [TagBits-1:0] tag_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) valid_q <= 1'b0;
      else if (en_i) valid_q <= loop_valid[Stages];
    end
    always_ff @(posedge clk_i) begin
      if (en_i) tag_q <= loop_word[Stages][Bits+:TagBits];
    end
    assign valid_o = valid_q;
    assign tag_o   = tag_q;
  end
  for (genvar l = 0; l < Lanes; l++) begin : g_d
    assign d_o[l*Bits+:Bits] = late[Stages*Lanes+l][Bits:1];
  end

endmodule
`default_nettype wire
