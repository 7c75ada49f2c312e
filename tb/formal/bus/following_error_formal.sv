// SPDX-License-Identifier: Apache-2.0
// rtl/bus/following_error.sv: if no two edges of an axis are in one round of 8 Axes slots, every
// edge is counted, once and in its direction, and none is reported illegal, for any pauses between
// slots.
// control: BACKWARDS s/now\[3\] == was\[2\]/now[3] != was[2]/
// control: COUNTS_TWICE s/(visit \&\& here\[a\])/(visit \&\& here[a] \&\& !edge_q)/
// control: COUNTS_FOR_ALL s/(visit \&\& here\[a\])/visit/
// control: ONE_DIRECTION s/{{31{edge_back_q}}, 1'b1}/32'd1/
// control: WRITES_LATE s/3'd3:    write_word_o/3'd7:    write_word_o/
// control: TWO_IN_A_ROUND
// long: proved
`default_nettype none
module following_error_formal (
    input wire logic        clk_i,
    input wire logic        rst_ni,
    input wire logic        slot_i,
    input wire logic [ 1:0] goes_i,        // an edge of the axis
    input wire logic [ 1:0] back_i,
    input wire logic [ 3:0] steps_i,
    input wire logic [ 1:0] referenced_i,
    input wire logic [31:0] data_i
);

`ifdef TWO_IN_A_ROUND
  localparam int Apart = 8;
`else
  localparam int Apart = 16;  // slots
`endif

  // Encoders: the true count, with which they begin, slots since the last edge
  logic [1:0] count_q[2];  // modulo 4: all that the pins show
  logic [1:0] first_q[2];
  logic [4:0] since_q[2];
  logic [1:0] a, b;
  logic [1:0] read_q;  // what ENCODER was in the memory, of the axis that was read
  logic reads_q;
  logic [1:0] kept_q[2];
  logic [6:0] read_word;
  logic write;
  logic [6:0] write_word;
  logic [31:0] data;
  logic encoder;
  logic following;
  logic [3:0] axis;
  for (genvar n = 0; n < 2; n++) begin : gen_pins
    assign a[n] = count_q[n] == 2'd1 || count_q[n] == 2'd2;
    assign b[n] = count_q[n][1];
    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        first_q[n] <= count_q[n];
        since_q[n] <= '0;
      end else if (goes_i[n] && since_q[n] >= Apart) begin
        count_q[n] <= count_q[n] + (back_i[n] ? 2'd3 : 2'd1);
        since_q[n] <= '0;
      end else if (slot_i && since_q[n] < 5'd16) since_q[n] <= since_q[n] + 1'b1;
    end
  end

  following_error #(
      .Axes(2)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .a_i(a),
      .b_i(b),
      .steps_i,
      .referenced_i,
      .slot_i,
      .read_word_o(read_word),
      .data_i(reads_q ? {30'd0, read_q} : data_i),
      .write_o(write),
      .write_word_o(write_word),
      .data_o(data),
      .encoder_o(encoder),
      .following_o(following),
      .axis_o(axis)
  );

  // The memory, of counts alone; and its value at the axis' last visit
  localparam logic [6:0] First = registers_pkg::Encoder0;
  logic [1:0] seen_q[2];
  logic started_q = 1'b0;
  logic writes;
  logic of_1;
  assign writes = slot_i && write && (write_word == First || write_word == First + 7'd1);
  assign of_1   = write_word != First;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    reads_q   <= slot_i && (read_word == First || read_word == First + 7'd1);
    read_q    <= kept_q[read_word != First];
    if (!rst_ni) begin
      kept_q[0] <= '0;
      kept_q[1] <= '0;
    end else begin
      if (writes) kept_q[of_1] <= data[1:0];
      if (slot_i && read_word == First) seen_q[0] <= count_q[0];
      if (slot_i && read_word == First + 7'd1) seen_q[1] <= count_q[1];
    end
  end

  always_comb begin
    if (!started_q) assume (!rst_ni);
    if (started_q && rst_ni) begin
      Counted : assert (!writes || data[1:0] == seen_q[of_1] - first_q[of_1]);
      Both : cover (writes && of_1 && data[1:0] == 2'd3 && kept_q[1] == 2'd0);
      Fault : cover (following && axis == 4'd1);
    end
  end

endmodule
`default_nettype wire
