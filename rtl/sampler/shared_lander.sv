// SPDX-License-Identifier: Apache-2.0
// All axes of a sample on one adder, an axis a clock, where samples are Axes clocks apart or more:
// each the step's origin plus the displacement, or the segment's end exactly, as it is in
// rtl/sampler/lander.sv.
//
//   clock       0                            4 + axis
//   valid_i     d, down, bank, land          fine_o; push_o if sample_i
`default_nettype none
module shared_lander #(
    parameter int CoefBits  = 36,  // [18, 36]
    parameter int FineBits  = 42,  // [18, 44]
    parameter int GuardBits = 10,  // [2, 12]
    parameter int Axes      = 3    // [3, 8]
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Points of the step in a bank: {there, axis, end, origin}
    input wire logic [           1:0] write_bank_i,
    input wire logic [2*FineBits+4:0] point_i,

    input  wire logic                       valid_i,
    input  wire logic                       sample_i,
    input  wire logic   [Axes*CoefBits-1:0] d_i,
    input  wire logic   [              4:0] down_i,
    input  wire logic   [              1:0] bank_i,
    input  wire logic                       land_i,
    output logic                            push_o,
    output logic signed [     FineBits-1:0] fine_o
);

  // Clock 1 + axis: its displacement in the low bits.
  logic [              3:0] busy_q;
  logic [Axes*CoefBits-1:0] d_q;
  logic [              4:0] down_q;
  logic [              2:0] axis_q;
  logic [              1:0] bank_q;
  logic                     land_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      busy_q <= '0;
    end else begin
      busy_q <= {busy_q[2:0], busy_q[0] && axis_q != 3'(Axes - 1)};
      if (valid_i) busy_q[0] <= sample_i;
    end
  end
  always_ff @(posedge clk_i) begin
    if (valid_i) begin
      d_q    <= d_i;
      axis_q <= 3'd0;
      down_q <= down_i;
      bank_q <= bank_i;
      land_q <= land_i;
    end else begin
      d_q    <= {{CoefBits{1'b0}}, d_q[Axes*CoefBits-1:CoefBits]};
      axis_q <= axis_q + 3'd1;
    end
  end

  // A clock later
  logic [4:0] place_q;
  logic       none_q;
  always_ff @(posedge clk_i) begin
    place_q <= {axis_q, bank_q};
    none_q  <= land_q;
  end

  logic signed [FineBits-1:0] origin_memory[32];
  logic signed [FineBits-1:0] end_memory   [32];
  logic        [         4:0] write_place;
  assign write_place = {point_i[2*FineBits+:3], write_bank_i};
  always_ff @(posedge clk_i) begin
    if (point_i[2*FineBits+4]) begin
      origin_memory[write_place] <= point_i[0+:FineBits];
      end_memory[write_place]    <= point_i[FineBits+:FineBits];
    end
  end

  logic signed [FineBits:0] doubled;
  fine_scale #(
      .CoefBits (CoefBits),
      .FineBits (FineBits),
      .GuardBits(GuardBits)
  ) u_scale (
      .clk_i,
      .en_i(1'b1),
      .d_i(d_q[CoefBits-1:0]),
      .down_i(down_q),
      .none_i(none_q),
      .doubled_o(doubled)
  );

  logic signed [FineBits-1:0] base_q;
  logic signed [  FineBits:0] base_half;
  logic signed [  FineBits:0] twice;
  assign base_half = {base_q, 1'b1};
  assign twice     = base_half + doubled;
  assign push_o    = busy_q[3];
  always_ff @(posedge clk_i) begin
    base_q <= none_q ? end_memory[place_q] : origin_memory[place_q];
    fine_o <= twice[FineBits:1];
  end

endmodule
`default_nettype wire
