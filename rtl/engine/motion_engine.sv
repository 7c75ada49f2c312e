// SPDX-License-Identifier: Apache-2.0
// One microprogrammed engine for all that happens once per sample, tick, step, segment or byte: an
// instruction is an operation on whole words, limb by limb, on one 16 x 16 multiplier.
// hls/instruction.hpp is its instruction set, formats, clocks and hazards; twin, bit for bit and
// clock for clock: hls/engine.hpp.
//
//   clock             s         s + 1      s + 2    s + 3       s + 4
//   term              operands  limbs               product     limb written
//   IN                          in_valid_o          in_data_i   limb written
//   OUT                                    out_valid_o
//   BR                conditions_i, tick_i
//
// Two programs: due_i starts the foreground; late_o stays 1 if it still ran then. changed_o stays 1
// from the clock behind the first term of an instruction that is not as it was made.
`default_nettype none
module motion_engine #(
    parameter int Instructions = 2048,  // [2, 32768]
    parameter int WordBits     = 8,     // [8, 12]: 2^WordBits words of data
    parameter int Form         = 0,     // multiplier: 0 portable, 1 ECP5, 2 UP5K
    parameter int Foreground   = 1,     // 0: there is none, due_i is 0
    parameter     Program      = "",    // files of hexadecimal words
    parameter     Data         = ""
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic due_i,
    input  wire logic tick_i,    // the foreground may wait for it, exactly
    output logic      busy_o,    // the foreground runs
    output logic      late_o,
    output logic      changed_o,

    input  wire logic [12:0] conditions_i,     // 3 to 15
    output logic             in_next_o,        // in_valid_o of the next clock
    output logic             in_valid_o,
    output logic      [ 4:0] in_port_o,
    output logic      [ 1:0] in_limb_o,
    input  wire logic [15:0] in_data_i,
    output logic             out_next_o,       // out_valid_o of the next clock, at this port
    output logic      [ 4:0] out_next_port_o,
    output logic             out_valid_o,
    output logic      [ 4:0] out_port_o,
    output logic      [ 1:0] out_limb_o,
    output logic      [15:0] out_data_o
);

  initial if (Foreground < 0 || Foreground > 1) $fatal(1, "Foreground must be 0 or 1");
  localparam int PlaceBits = $clog2(Instructions);
  localparam int LimbPlaceBits = WordBits + 2;

  // Sequence
  logic fetch, run, thread, next_thread, ahead_thread;
  logic last, ends;
  logic branch, goes, is_in, is_out, result, sum, minus, product, power, single, round, wide;
  logic gathers, adds, adds_up, high;
  logic [1:0] most_j;
  logic [2:0] last_limb;
  logic stall;
  engine_sequencer #(
      .Foreground(Foreground)
  ) u_sequencer (
      .clk_i,
      .rst_ni,
      .due_i,
      .ends_i        (ends),
      .busy_o,
      .late_o,
      .last_i        ((last || branch) && !stall),
      .branch_i      (branch),
      .out_i         (is_out),
      .fetch_o       (fetch),
      .run_o         (run),
      .thread_o      (thread),
      .next_thread_o (next_thread),
      .ahead_thread_o(ahead_thread)
  );

  // Program
  logic [PlaceBits-1:0] place;
  logic [31:0] ahead;
  logic [31:0] instruction;
  logic [23:0] fields;
  assign fields = instruction[23:0];
  always_ff @(posedge clk_i) changed_o <= rst_ni && (changed_o || (run && !(^instruction)));
  engine_program #(
      .Instructions(Instructions),
      .Form(Form),
      .Program(Program)
  ) u_program (
      .clk_i,
      .place_i      (place),
      .fetch_i      (fetch),
      .ahead_o      (ahead),
      .instruction_o(instruction)
  );
  engine_decoder u_decoder (
      .clk_i,
      .fetch_i    (fetch),
      .ahead_i    (ahead),
      .high_o     (high),
      .last_limb_o(last_limb),
      .branch_o   (branch),
      .goes_o     (goes),
      .in_o       (is_in),
      .out_o      (is_out),
      .result_o   (result),
      .sum_o      (sum),
      .minus_o    (minus),
      .product_o  (product),
      .power_o    (power),
      .single_o   (single),
      .round_o    (round),
      .wide_o     (wide),
      .gathers_o  (gathers),
      .adds_o     (adds),
      .adds_up_o  (adds_up),
      .most_j_o   (most_j)
  );

  // What OUT puts out, a clock behind its term
  logic out_q, out_last_q;
  logic [1:0] out_limb_q;
  logic [15:0] first_limb, second_limb;
  logic own;
  assign out_next_o = out_q && !changed_o;
  assign out_next_port_o = fields[12:8];
  assign own = out_q && out_last_q;

  // Places
  logic negative, zero;
  logic [PlaceBits-1:0] link;
  engine_branch #(
      .PlaceBits(PlaceBits)
  ) u_branch (
      .clk_i,
      .rst_ni,
      .next_thread_i (next_thread),
      .place_o       (place),
      .fetch_i       (fetch),
      .ahead_thread_i(ahead_thread),
      .run_i         (run),
      .thread_i      (thread),
      .branch_i      (goes),
      .waits_i       (instruction[24]),
      .fields_i      (fields),
      .tick_i,
      .negative_i    (negative),
      .zero_i        (zero),
      .board_i       (conditions_i),
      .stall_o       (stall),
      .ends_o        (ends),
      .link_i        (own && out_next_port_o == engine_pkg::PortLink),
      .link_place_i  (first_limb[PlaceBits-1:0]),
      .link_o        (link)
  );

  // Terms
  logic [2:0] i, limb;
  logic [1:0] j;
  logic added, empty, afresh, begins, ends_column, kept, last_column;
  engine_terms u_terms (
      .clk_i,
      .start_i      (fetch),
      .high_i       (high),
      .last_limb_i  (last_limb),
      .run_i        (run && !stall),
      .single_i     (single),
      .wide_i       (wide),
      .adds_i       (adds),
      .adds_up_i    (adds_up),
      .most_j_i     (most_j),
      .i_o          (i),
      .j_o          (j),
      .added_o      (added),
      .empty_o      (empty),
      .afresh_o     (afresh),
      .begins_o     (begins),
      .ends_o       (ends_column),
      .kept_o       (kept),
      .limb_o       (limb),
      .last_column_o(last_column),
      .last_o       (last)
  );

  // Operands
  logic [LimbPlaceBits-1:0] first_place, second_place, result_place;
  logic [2:0] written_limb;
  logic constant;
  engine_operands #(
      .WordBits(WordBits)
  ) u_operands (
      .clk_i,
      .rst_ni,
      .fields_i  (fields),
      .thread_i  (thread),
      .page_x_i  (own && out_next_port_o == engine_pkg::PortX),
      .page_y_i  (own && out_next_port_o == engine_pkg::PortY),
      .page_i    (first_limb[WordBits-6:0]),
      .product_i (product),
      .sum_i     (sum),
      .minus_i   (minus),
      .power_i   (power),
      .gathers_i (gathers),
      .adds_up_i (adds_up),
      .i_i       (i),
      .j_i       (j),
      .limb_i    (limb),
      .added_i   (added),
      .empty_i   (empty),
      .first_o   (first_place),
      .second_o  (second_place),
      .written_i (written_limb),
      .result_o  (result_place),
      .constant_o(constant)
  );
  logic write;
  logic [15:0] data;
  engine_memory #(
      .PlaceBits(LimbPlaceBits),
      .Data     (Data)
  ) u_memory (
      .clk_i,
      .write_i      (write && !constant),
      .write_place_i(result_place),
      .write_limb_i (data),
      .first_i      (first_place),
      .first_o      (first_limb),
      .second_i     (second_place),
      .second_o     (second_limb)
  );

  // Product, sum, result
  logic signed [15:0] first_factor;
  logic signed [15:0] second_factor;
  logic signed [31:0] limb_product;
  logic signed [33:0] column_total;
  assign first_factor  = $signed(first_limb);
  assign second_factor = $signed(second_limb);
  limb_product #(
      .Form(Form)
  ) u_product (
      .clk_i,
      .a_i      (first_factor),
      .b_i      (second_factor),
      .product_o(limb_product)
  );
  column_sum u_sum (
      .clk_i,
      .begins_i (run && begins),
      .afresh_i (run && afresh),
      .round_i  (run && begins && kept && limb == 3'd0 && round),
      .product_i(limb_product),
      .sum_o    (column_total)
  );
  logic [ 2:0] asked_limb;
  logic [15:0] answer;
  engine_result u_result (
      .clk_i,
      .rst_ni,
      .thread_i     (thread),
      .run_i        (run),
      .result_i     (result),
      .product_i    (product),
      .in_i         (is_in),
      .limb_i       (limb),
      .kept_i       (kept),
      .ends_i       (ends_column),
      .last_column_i(last_column),
      .sum_i        (column_total),
      .answer_i     (answer),
      .asks_o       (in_next_o),
      .ask_o        (in_valid_o),
      .write_o      (write),
      .limb_o       (written_limb),
      .asked_o      (asked_limb),
      .data_o       (data),
      .negative_o   (negative),
      .zero_o       (zero)
  );

  // Ports
  assign in_port_o = fields[20:16];
  assign in_limb_o = asked_limb[1:0];
  assign answer = in_port_o == engine_pkg::PortLink ? 16'(link) : in_data_i;
  always_ff @(posedge clk_i) begin
    out_q       <= rst_ni && run && is_out;
    out_last_q  <= last_column;
    out_limb_q  <= limb[1:0];
    out_valid_o <= rst_ni && out_next_o;
    out_port_o  <= out_next_port_o;
    out_limb_o  <= out_limb_q;
    out_data_o  <= first_limb;
  end

endmodule
`default_nettype wire
