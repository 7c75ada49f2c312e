// SPDX-License-Identifier: Apache-2.0
// rtl/bus/position_buffer.sv: a sample is taken whole or refused whole, and refused only when the
// buffer is full; room and waiting samples are reported; whole samples are offered, an offer stays,
// and none begins when it ends. Values of positions: tb/unit/system/position_mode_test.cpp.
// control: LOSES s/write_i \&\& ready_o;/write_i \&\& ready_o \&\& data_i[5:0] != 6'd5;/
// control: OVERFLOWS s/first ? room_q != '0 : !refused_q/1'b1/
// control: MISTAKES_AXES s/ : !refused_q;/ : room_q != '0;/
// control: OFFERS_PARTS s/assign comes = .*/assign comes = reserves;/
// control: WITHDRAWS s/(offered_q || !ends_i)/!ends_i/
// control: GOES_ON s/(offered_q || !ends_i)/1'b1/
// control: KEEPS_A_PART s/!rst_ni || empty_i) axis_q/!rst_ni) axis_q/
`default_nettype none
module position_buffer_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic write_i,
    input wire logic ready_i,
    input wire logic ends_i
);

  localparam int Axes = 2;
  localparam int Most = 16;  // samples

  logic [5:0] sent_q;  // positions, modulo more than it holds
  logic [5:0] taken_q;
  logic part_q;  // of a sample came
  logic refused_q;  // it was refused
  logic ready;
  logic valid;
  logic empty;
  logic [15:0] room;
  logic [15:0] queued;
  assign empty = ends_i && !valid;
  position_buffer #(
      .Axes (Axes),
      .Bits (16),
      .Words(32)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .write_i,
      .ready_o (ready),
      .data_i  (16'(sent_q)),
      .room_o  (room),
      .queued_o(queued),
      .ends_i,
      .empty_i (empty),
      .valid_o (valid),
      .ready_i,
      .axis_i  ('0)
  );

  logic [5:0] held;
  assign held = sent_q - taken_q;
  logic started_q = 1'b0;
  logic kept_q;
  logic ended_q;
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    kept_q    <= rst_ni && valid && !ready_i;
    ended_q   <= rst_ni && ends_i && (!valid || ready_i);
    if (!rst_ni || empty) begin
      sent_q    <= '0;
      taken_q   <= '0;
      part_q    <= 1'b0;
      refused_q <= 1'b0;
    end else begin
      if (write_i) part_q <= !part_q;
      if (write_i && !part_q) refused_q <= !ready;
      if (write_i && ready) sent_q <= sent_q + 1'b1;
      if (valid && ready_i) taken_q <= taken_q + 6'(Axes);
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      Whole : assert (!write_i || !part_q || ready == !refused_q);
      Fits : assert (!write_i || part_q || ready == (held != 6'(Axes * Most)));
      Told : assert (queued == 16'(held[5:1]) && room == 16'(Most) - 16'(held[5:1]) - 16'(held[0]));
      Complete : assert (!valid || held >= 6'(Axes));
      Stays : assert (!kept_q || valid);
      Begins_none : assert (!(ended_q && ends_i && valid));
      Nothing_hidden : assert (ends_i || valid == (held >= 6'(Axes)));
      Fills : cover (held == 6'(Axes * Most) && write_i);
      Ends : cover (ends_i && valid && held == 6'd3);
    end
  end

endmodule
`default_nettype wire
