// SPDX-License-Identifier: Apache-2.0
// rtl/engine/motion_engine.sv does what hls/instruction.hpp says, of every instruction after any
// other, whatever stands in its memories and whatever comes in: when each instruction begins, of
// which program and at which place; where each term reads its limbs and how columns gather them;
// which limbs are written, when, where, from which bits of a sum; flags, pages and links; what
// ports are asked and told, and that nothing is told from a changed instruction on; that the
// foreground is late. Reset lasts a clock.
//
// The reference below executes instruction.hpp term by term. Products, sums, and what the memories
// read, may be anything: tb/unit/arithmetic/motion_engine_test.cpp has the numbers.
// cut: *engine_program*/t:$memrd* *engine_memory*/t:$memrd*
// cut: *limb_product*/w:product_o *column_sum*/w:sum_o
// control: NO_HALF engine_terms s/kept_o || column_q == 2'd2/kept_o || column_q == 2'd3/
// control: BEGINS_EARLY engine_sequencer s/: 4'b1000;/: 4'b0100;/
// control: BRANCHES_LATE engine_sequencer s/4'b0010 : out_i/4'b0100 : out_i/
// control: LATE_AT_END engine_sequencer s/due_i \&\& next_thread_o) late/due_i \&\& busy_o) late/
// control: SHORT_COLUMN engine_terms s/next_i > most_i/next_i >= most_i/
// control: OTHER_LIMB engine_terms s/j_o - 2'd1/j_o + 2'd1/
// control: ONE_PAGE engine_operands s/field\[5\] ? page_y : page_x/page_x/
// control: WRITES_CONSTANTS engine_operands s/WordBits-1:3\] == '0/WordBits-1:2] == '0/
// control: NARROW engine_operands s/result_word\[0\] | written_i\[2\]/result_word[0]/
// control: ADDS_OTHER engine_operands s/added_i ? gathers_i/added_i ? adds_up_i/
// control: LONG_SIGN engine_result s/product_i ? sum_i\[14\] : sum_i\[15\]/sum_i[15]/
// control: ONE_FLAG engine_result s/zero_q\[thread_i\] /zero_q[0] /
// control: WRITES_IN_RESET engine_result s/write_q <= rst_ni ?/write_q <= 1'b1 ?/
// control: TELLS_ON motion_engine s/out_q \&\& !changed_o/out_q/
// control: FORGETS_CHANGE motion_engine s/changed_o || (run/(run/
// control: ONE_LINK engine_branch s/link_q\[thread_i\] <= pc_q/link_q[0] <= pc_q/
// control: NO_WAIT engine_branch s/ \&\& !tick_i;/ \&\& !tick_i \&\& negative_i;/
// control: LINK_STAYS engine_branch s/      link_q\[1\] <= '0;//
// control: BR_OF_ALL engine_decoder s/op == engine_pkg::Br;/op == 4'd0 || op == 4'd3;/
// control: OWN_FIRST motion_engine s/out_q \&\& out_last_q/out_q/
// control: PORT_LINK motion_engine s/16'(link) : in_data_i/in_data_i : in_data_i/
// long: covered
`default_nettype none
module motion_engine_formal #(
    parameter int PlaceBits = 2,
    parameter int WordBits  = 8
) (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        due_i,
    input wire logic        tick_i,
    input wire logic [12:0] conditions_i,
    input wire logic [15:0] in_data_i
);

  logic busy, late, changed, in_valid, out_valid;
  logic [4:0] in_port, out_port;
  logic [1:0] in_limb, out_limb;
  logic [15:0] out_data;
  motion_engine #(
      .Instructions(2 ** PlaceBits),
      .WordBits(WordBits)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .due_i,
      .tick_i,
      .busy_o     (busy),
      .late_o     (late),
      .changed_o  (changed),
      .conditions_i,
      .in_valid_o (in_valid),
      .in_port_o  (in_port),
      .in_limb_o  (in_limb),
      .in_data_i,
      .out_valid_o(out_valid),
      .out_port_o (out_port),
      .out_limb_o (out_limb),
      .out_data_o (out_data)
  );

  // What the proof sees of the inside
  localparam int LimbPlaceBits = WordBits + 2;
  (* hierconn *) logic [PlaceBits-1:0] \u_dut.u_program.place_i ;
  (* hierconn *) logic [31:0] \u_dut.u_program.ahead_o ;
  (* hierconn *) logic [LimbPlaceBits-1:0] \u_dut.u_memory.first_i ;
  (* hierconn *) logic [LimbPlaceBits-1:0] \u_dut.u_memory.second_i ;
  (* hierconn *) logic [15:0] \u_dut.u_memory.first_o ;
  (* hierconn *) logic \u_dut.u_memory.write_i ;
  (* hierconn *) logic [LimbPlaceBits-1:0] \u_dut.u_memory.write_place_i ;
  (* hierconn *) logic [15:0] \u_dut.u_memory.write_limb_i ;
  (* hierconn *) logic \u_dut.u_sum.begins_i ;
  (* hierconn *) logic \u_dut.u_sum.afresh_i ;
  (* hierconn *) logic \u_dut.u_sum.round_i ;
  (* hierconn *) logic [33:0] \u_dut.u_sum.sum_o ;
  (* hierconn *) logic \u_dut.u_sequencer.run_o ;

  logic [PlaceBits-1:0] read_place;
  logic [31:0] read_word;
  logic [LimbPlaceBits-1:0] first, second, write_place;
  logic [15:0] first_limb_read, write_limb;
  logic [33:0] sum;
  logic write, begins, afresh, round, run;
  assign read_place      = \u_dut.u_program.place_i ;
  assign read_word       = \u_dut.u_program.ahead_o ;
  assign first           = \u_dut.u_memory.first_i ;
  assign second          = \u_dut.u_memory.second_i ;
  assign first_limb_read = \u_dut.u_memory.first_o ;
  assign write           = \u_dut.u_memory.write_i ;
  assign write_place     = \u_dut.u_memory.write_place_i ;
  assign write_limb      = \u_dut.u_memory.write_limb_i ;
  assign begins          = \u_dut.u_sum.begins_i ;
  assign afresh          = \u_dut.u_sum.afresh_i ;
  assign round           = \u_dut.u_sum.round_i ;
  assign sum             = \u_dut.u_sum.sum_o ;
  assign run             = \u_dut.u_sequencer.run_o ;

  // The reference: an instruction, its column, the column's term.
  logic [31:0] word_q;
  logic [3:0] op;
  logic [1:0] most;  // limbs - 1
  logic flag;
  logic [7:0] f0, f1, f2;
  assign op = word_q[31:28];
  assign most = word_q[27:26];
  assign flag = word_q[24];
  assign {f0, f1, f2} = word_q[23:0];
  logic is_br, is_out, is_in, is_sum, is_sub, is_branch;
  logic is_product, is_high, is_mac, is_shr, is_madr;
  assign is_br      = op == 4'd0;
  assign is_out     = op == 4'd1;
  assign is_in      = op == 4'd2;
  assign is_sub     = op == 4'd5;
  assign is_sum     = op == 4'd4 || is_sub;
  assign is_madr    = op == 4'd10;
  assign is_mac     = op == 4'd11;
  assign is_shr     = op == 4'd12;
  assign is_high    = op == 4'd9 || is_madr || is_shr;
  assign is_product = op >= 4'd8 && op <= 4'd12;
  assign is_branch  = !is_product && !is_sum && !is_in && !is_out;

  logic changed_q;  // an instruction had an even number of ones
  logic running_q;  // a term
  logic thread_q;  // its program
  logic [2:0] column_q;
  logic [2:0] term_q;

  logic [2:0] first_column, last_column, other, first_i, last_i, most_i;
  logic [3:0] products;
  logic is_power, adds;
  assign is_power     = f1 >= 8'hc0;
  assign first_column = is_high ? 3'd3 : 3'd0;
  assign last_column  = is_mac ? 3'd5 : is_branch ? 3'd0 : first_column + {1'b0, most};
  assign other        = is_power ? {1'b0, f1[5:4]} : 3'd2;
  assign first_i      = column_q > other ? column_q - other : 3'd0;
  assign most_i       = is_shr ? 3'd5 : 3'd2;
  assign last_i       = is_power ? first_i : column_q;
  assign products     = {1'b0, last_i < most_i ? last_i : most_i} + 4'd1 - {1'b0, first_i};
  logic [2:0] count;  // of products
  assign count = products[3] ? 3'd0 : products[2:0];
  assign adds  = is_mac ? !flag : is_madr && column_q >= 3'd3;
  logic [2:0] both, terms;
  assign both  = count + {2'b0, adds};
  assign terms = is_sum ? 3'd2 : !is_product || both == '0 ? 3'd1 : both;

  logic waits, last_term, last;
  assign waits     = is_br && flag && !tick_i;
  assign last_term = term_q + 3'd1 == terms;
  assign last      = last_term && column_q == last_column && !waits;

  // Two programs
  logic [PlaceBits-1:0] pc_q[2];
  logic [PlaceBits-1:0] link_q[2];
  logic [WordBits-6:0] x_q[2];
  logic [WordBits-6:0] y_q[2];
  logic [1:0] negative_q;
  logic [1:0] zero_q;
  logic foreground_q;
  logic late_q;
  logic ended_q;  // a clock ago
  logic next_thread_q;
  logic [2:0] left_q;  // clocks to the next first term

  // The next instruction is read two clocks before its first term: of OUT in its last term.
  logic reads;
  assign reads = left_q == 3'd2 || (running_q && last && is_out);

  logic goes, holds;
  logic [15:0] conditions;
  logic negative, zero;
  assign negative = negative_q[thread_q];
  assign zero = zero_q[thread_q];
  assign conditions = {conditions_i, zero, negative, 1'b0};
  assign holds = conditions[f0[3:0]] != f0[4];
  assign goes = running_q && is_br && !waits && holds;

  logic [PlaceBits-1:0] link;
  logic [WordBits-6:0] x, y;
  assign link = link_q[thread_q];
  assign x = x_q[thread_q];
  assign y = y_q[thread_q];
  function automatic logic [LimbPlaceBits-1:0] limb_place(
      input logic [7:0] field, input logic [2:0] limb, input logic [WordBits-6:0] px,
      input logic [WordBits-6:0] py);
    logic [WordBits-1:0] number;
    number = WordBits'(field[6:0]);
    if (field >= 8'd128) number = {field[5] ? py : px, field[4:0]};
    if (limb >= 3'd4) number = number | WordBits'(1);
    limb_place = {number, limb[1:0]};
  endfunction

  // Terms
  logic [2:0] i, j;
  logic [LimbPlaceBits-1:0] second_of_j, expected_first, expected_second;
  logic reads_first, reads_second;
  logic is_added;
  assign is_added = is_product && term_q == count;
  assign i = first_i + term_q;
  assign j = is_sum ? column_q : column_q - i;
  localparam logic [LimbPlaceBits-1:0] ZeroPlace = LimbPlaceBits'(16);
  always_comb begin
    second_of_j = limb_place(f1, j, x, y);
    if (is_power) second_of_j = {1'b0, f1[5:4]} == j ? LimbPlaceBits'(f1[3:0]) : ZeroPlace;
    expected_first  = limb_place(is_madr ? f2 : f0, is_product ? i : column_q, x, y);
    expected_second = second_of_j;
    reads_first     = is_sum || is_out || (is_product && both != '0);
    reads_second    = is_sum || is_product;
    if (is_sum && term_q == '0) expected_second = '0;
    if (is_sum && term_q != '0) expected_first = is_sub ? LimbPlaceBits'(15) : '0;
    if (is_added) begin
      expected_first = is_mac ? limb_place(f2, column_q, x, y) :
          limb_place(f0, column_q - 3'd3, x, y);
      expected_second = adds ? '0 : ZeroPlace;
    end
  end

  // Results: the limb of a column is written four clocks behind its last term.
  logic kept;
  logic [3:0] kept_q;
  logic [3:0] top_q;
  logic [2:0] limb_q[4];
  logic [15:0] answer_q, value;
  logic value_negative;
  assign kept = running_q && !is_branch && !is_out && last_term && column_q >= first_column;
  always_comb begin
    value = {top_q[3] && (is_product ? sum[14] : sum[15]), sum[14:0]};
    value_negative = is_product ? value[15] : sum[33];
    if (is_in) begin
      value = answer_q;
      value_negative = value[15];
    end
  end
  logic [LimbPlaceBits-1:0] expected_place;
  assign expected_place = limb_place(f2, limb_q[3], x, y);

  // Ports: OUT's limb is at the board two clocks behind its term.
  logic out_q, out_2_q, out_top_q;
  logic [1:0] out_limb_q, out_limb_2_q;
  logic [ 4:0] out_port_2_q;
  logic [15:0] out_data_2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      running_q     <= 1'b0;
      thread_q      <= 1'b0;
      pc_q[0]       <= '0;
      pc_q[1]       <= PlaceBits'(1);
      link_q[0]     <= '0;
      link_q[1]     <= '0;
      x_q[0]        <= '0;
      x_q[1]        <= '0;
      y_q[0]        <= '0;
      y_q[1]        <= '0;
      negative_q    <= '0;
      zero_q        <= '0;
      foreground_q  <= 1'b0;
      late_q        <= 1'b0;
      changed_q     <= 1'b0;
      ended_q       <= 1'b0;
      left_q        <= 3'd4;
      kept_q        <= '0;
      out_q         <= 1'b0;
      out_2_q       <= 1'b0;
      next_thread_q <= 1'b0;
    end else begin
      // Sequence
      if (left_q != '0) left_q <= left_q - 3'd1;
      if (reads) next_thread_q <= foreground_q;
      if (left_q == 3'd1) begin
        running_q           <= 1'b1;
        word_q              <= read_word;
        thread_q            <= next_thread_q;
        column_q            <= '0;
        term_q              <= '0;
        pc_q[next_thread_q] <= pc_q[next_thread_q] + PlaceBits'(1);
      end
      if (running_q && !waits) begin
        term_q <= last_term ? '0 : term_q + 3'd1;
        if (last_term) column_q <= column_q + 3'd1;
        if (last) begin
          running_q <= 1'b0;
          left_q    <= is_branch ? 3'd2 : is_out ? 3'd1 : 3'd4;
        end
      end

      if (running_q && ($countones(word_q) & 1) == 0) changed_q <= 1'b1;

      // Branches
      foreground_q <= foreground_q || due_i;
      ended_q      <= goes && f0[7] && thread_q;
      if (due_i && foreground_q) late_q <= 1'b1;
      if (goes) begin
        pc_q[thread_q] <= f0[6] ? link : PlaceBits'({f1, f2});
        if (f0[5]) link_q[thread_q] <= pc_q[thread_q];
        if (f0[7] && thread_q) foreground_q <= 1'b0;
      end

      // Results
      kept_q    <= {kept_q[2:0], kept};
      top_q     <= {top_q[2:0], column_q == last_column};
      limb_q[0] <= column_q - first_column;
      limb_q[1] <= limb_q[0];
      limb_q[2] <= limb_q[1];
      limb_q[3] <= limb_q[2];
      answer_q  <= f0[4:0] == 5'd2 ? 16'(link) : in_data_i;
      if (kept_q[3]) begin
        negative_q[thread_q] <= value_negative;
        zero_q[thread_q]     <= value == '0 && (limb_q[3] == '0 || zero_q[thread_q]);
      end

      // Ports
      out_q        <= running_q && is_out;
      out_top_q    <= last;
      out_limb_q   <= column_q[1:0];
      out_2_q      <= out_q && !changed_q;
      out_limb_2_q <= out_limb_q;
      out_port_2_q <= f1[4:0];
      out_data_2_q <= first_limb_read;
      if (out_q && out_top_q) begin
        if (f1[4:0] == 5'd0) x_q[thread_q] <= first_limb_read[WordBits-6:0];
        if (f1[4:0] == 5'd1) y_q[thread_q] <= first_limb_read[WordBits-6:0];
        if (f1[4:0] == 5'd2) link_q[thread_q] <= first_limb_read[PlaceBits-1:0];
      end
    end
  end

  logic started_q = 1'b0;
  always_ff @(posedge clk_i) started_q <= 1'b1;

  always_comb begin
    if (!started_q) assume (!rst_ni);
    if (started_q && rst_ni) begin
      // When and where
      Runs : assert (run == running_q);
      if (reads) Place : assert (read_place == pc_q[foreground_q]);
      Busy : assert (busy == (foreground_q || ended_q));
      Late : assert (late == late_q);
      Changed : assert (changed == changed_q);

      // Terms
      if (running_q && reads_first) First : assert (first == expected_first);
      if (running_q && reads_second) begin
        Second : assert (second == expected_second);
        Begins : assert (begins == (term_q == '0));
        Afresh : assert (afresh == (term_q == '0 && column_q == '0));
        Round : assert (round == (term_q == '0 && column_q == 3'd3 && is_high && !flag));
      end

      // Results
      Writes : assert (write == (kept_q[3] && expected_place[LimbPlaceBits-1:5] != '0));
      if (write) Where : assert (write_place == expected_place && write_limb == value);

      // Ports
      Asks : assert (in_valid == (kept_q[0] && is_in));
      if (in_valid) Asked : assert (in_port == f0[4:0] && in_limb == limb_q[0][1:0]);
      Tells : assert (out_valid == out_2_q);
      if (out_valid) begin
        Told : assert (out_port == out_port_2_q && out_limb == out_limb_2_q);
        Telling : assert (out_data == out_data_2_q);
      end

      LongSum : cover (write && is_mac && !flag && !is_power && limb_q[3] == 3'd5);
      Shift : cover (write && is_shr && !is_power && limb_q[3] == 3'd3);
      Ahead : cover (goes && thread_q && f0[7] && late_q);
      Calls : cover (goes && f0[5] && f0[6] && x != '0 && y != '0 && link != '0);
    end
  end

endmodule
`default_nettype wire
