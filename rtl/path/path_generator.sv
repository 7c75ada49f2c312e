// SPDX-License-Identifier: Apache-2.0
// Increments of the path from rates of time and profile pieces.
// Twin: PathKernel of hls/path_kernel.hpp.
//
//     s = min(max(2^e (c1 tau + c2 tau^2 + c3 tau^3), s before), ds)     tau = t / 2^m
//
//   clock          0     Latency            Interval   Latency
//   tick_taken_o   1                        1          35
//   ds_valid_o           1                  2          37
//   ds_o                 increment          4, 8       43
//
// One tick per Interval clocks; results are not held: the sender of rates has room for them. A
// piece boundary costs no clock when the piece before was 6 clocks long and the next is queued.
`default_nettype none
module path_generator #(
    parameter int Interval       = 1,  // 1, 2, 4, 8 clocks from tick to tick
    parameter int MultiplierForm = 0   // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Profile words
    input  wire logic        word_valid_i,
    output logic             word_ready_o,
    input  wire logic [47:0] word_i,
    input  wire logic        queued_i,      // complete pieces that have not begun
    input  wire logic        begin_i,       // a program may begin

    // Ticks
    input  wire logic        rate_valid_i,
    output logic             rate_ready_o,
    input  wire logic [16:0] rate_i,
    input  wire logic        held_i,        // target 0: no program begins
    output logic             tick_taken_o,

    // Stop branches, to the time scaler: rtl/time/stop_memory.sv
    input  wire logic        scaled_i,      // a tick that the scaler takes
    input  wire logic        steady_i,
    input  wire logic        passed_i,
    output logic      [20:0] due_o,         // begins, next_wait
    output logic             step_valid_o,
    input  wire logic        step_ready_i,
    output logic      [43:0] step_o,

    // Increments, a tick each
    output logic        ds_valid_o,
    output logic [47:0] ds_o,
    output logic [16:0] ds_rate_o,
    output logic        ds_active_o, // a program was under way

    // The present piece; piece_take_o: the next one begins
    output logic               piece_take_o,
    output logic               active_o,
    output logic               last_o,
    output logic signed [21:0] ticks_left_o,
    output logic        [19:0] next_ticks_o,
    output logic               next_final_o
);

  initial
    if (Interval != 1 && Interval != 2 && Interval != 4 && Interval != 8)
      $fatal(1, "Interval must be 1, 2, 4 or 8");

  // Pieces are 6 clocks apart at least, evaluations 36 clocks long at most: a bank that is written
  // is no longer used.
  localparam int BankBits = 3;

  // Pieces
  logic stop_write;
  logic step_write;
  logic coef_write;
  logic [3:0] coef_pass;
  logic signed [35:0] coef;
  logic bound_write;
  logic [5:0] next_exponent;
  logic [47:0] next_ds;
  logic [BankBits-1:0] next_bank;
  logic next_valid;
  logic [4:0] next_time_exponent;
  piece_loader #(
      .BankBits(BankBits)
  ) u_loader (
      .clk_i,
      .rst_ni,
      .word_valid_i,
      .word_ready_o,
      .word_i,
      .stop_write_o(stop_write),
      .step_write_o(step_write),
      .coef_write_o(coef_write),
      .coef_pass_o(coef_pass),
      .coef_o(coef),
      .bound_write_o(bound_write),
      .exponent_o(next_exponent),
      .ds_o(next_ds),
      .bank_o(next_bank),
      .piece_valid_o(next_valid),
      .piece_take_i(piece_take_o),
      .ticks_o(next_ticks_o),
      .time_exponent_o(next_time_exponent),
      .final_o(next_final_o)
  );

  stop_memory u_stops (
      .clk_i,
      .rst_ni,
      .stop_write_i(stop_write),
      .step_write_i(step_write),
      .word_i(word_i[43:0]),
      .tick_taken_i(tick_taken_o),
      .take_i(piece_take_o),
      .first_i(!active_o),
      .tick_i(scaled_i),
      .steady_i,
      .passed_i,
      .next_wait_o(due_o[19:0]),
      .begins_o(due_o[20]),
      .step_valid_o,
      .step_ready_i,
      .step_o
  );

  logic may_pass;
  assign may_pass = active_o || begin_i;

  localparam int TagBits = BankBits + 17 + 3;
  localparam int StartPhase = (Interval == 1) ? 0 : (Interval == 2) ? 1 : 3;  // -5
  logic [2:0] phase_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) phase_q <= 3'd0;
    else phase_q <= (phase_q == 3'(Interval - 1)) ? 3'd0 : phase_q + 3'd1;
  end

  logic event_valid;
  logic event_begin;
  logic event_still;
  logic event_end;
  logic [35:0] event_time;
  logic [4:0] event_time_exponent;
  logic [BankBits-1:0] event_bank;
  logic [16:0] event_rate;
  piece_clock #(
      .BankBits(BankBits)
  ) u_clock (
      .clk_i,
      .rst_ni,
      .slot_i(phase_q == 3'(StartPhase)),
      .queued_i(queued_i && may_pass),
      .next_valid_i(next_valid && may_pass),
      .next_take_o(piece_take_o),
      .next_ticks_i(next_ticks_o),
      .next_time_exponent_i(next_time_exponent),
      .next_final_i(next_final_o),
      .next_bank_i(next_bank),
      .rate_valid_i,
      .rate_ready_o,
      .rate_i,
      .held_i,
      .tick_taken_o,
      .valid_o(event_valid),
      .begin_o(event_begin),
      .still_o(event_still),
      .end_o(event_end),
      .time_o(event_time),
      .time_exponent_o(event_time_exponent),
      .bank_o(event_bank),
      .rate_o(event_rate),
      .active_o,
      .last_o,
      .ticks_left_o
  );

  // Polynomial
  logic tau_valid;
  logic [35:0] tau;
  logic [TagBits-1:0] tau_tag;
  tau_shift #(
      .TagBits(TagBits)
  ) u_tau (
      .clk_i,
      .rst_ni,
      .valid_i(event_valid),
      .time_i(event_time),
      .time_exponent_i(event_time_exponent),
      .tag_i({event_rate, event_begin, event_still, event_end, event_bank}),
      .valid_o(tau_valid),
      .tau_o(tau),
      .tag_o(tau_tag)
  );

  logic d_valid;
  logic [35:0] d;
  logic [TagBits-1:0] d_tag;
  horner #(
      .Passes(3),
      .Lanes(1),
      .Bits(36),
      .Shift(35),
      .Interval(Interval),
      .BankBits(BankBits),
      .TagBits(TagBits),
      .Form(MultiplierForm)
  ) u_horner (
      .clk_i,
      .rst_ni,
      .en_i(1'b1),
      .write_i(coef_write),
      .write_lanes_i({1{1'b1}}),
      .write_bank_i(next_bank),
      .write_pass_i(coef_pass),
      .write_coef_i(coef),
      .phase_i(phase_q),
      .valid_i(tau_valid),
      .x_i(tau),
      .tag_i(tau_tag),
      .valid_o(d_valid),
      .d_o(d),
      .tag_o(d_tag)
  );

  // Increments
  logic [53:0] bounds[2**BankBits];
  always_ff @(posedge clk_i) begin
    if (bound_write) bounds[next_bank] <= {next_exponent, next_ds};
  end
  logic [53:0] bound;
  assign bound = bounds[d_tag[BankBits-1:0]];

  path_increment u_increment (
      .clk_i,
      .rst_ni,
      .valid_i(d_valid),
      .begin_i(d_tag[BankBits+2]),
      .still_i(d_tag[BankBits+1]),
      .end_i(d_tag[BankBits]),
      .d_i(d),
      .exponent_i(bound[53:48]),
      .ds_i(bound[47:0]),
      .rate_i({!d_tag[BankBits+1], d_tag[BankBits+3+:17]}),
      .valid_o(ds_valid_o),
      .ds_o,
      .rate_o({ds_active_o, ds_rate_o})
  );

endmodule
`default_nettype wire
