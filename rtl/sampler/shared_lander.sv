// SPDX-License-Identifier: Apache-2.0
// All axes of a sample on one lander, an axis a clock, where samples are Axes clocks apart or more.
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
  logic       lands_q;
  always_ff @(posedge clk_i) begin
    place_q <= {axis_q, bank_q};
    lands_q <= land_q;
  end

  lander #(
      .CoefBits (CoefBits),
      .FineBits (FineBits),
      .GuardBits(GuardBits),
      .PlaceBits(5)
  ) u_lander (
      .clk_i,
      .write_i       (point_i[2*FineBits+4]),
      .write_place_i ({point_i[2*FineBits+:3], write_bank_i}),
      .write_origin_i(point_i[0+:FineBits]),
      .write_end_i   (point_i[FineBits+:FineBits]),
      .d_i           (d_q[CoefBits-1:0]),
      .down_i        (down_q),
      .place_i       (place_q),
      .land_i        (lands_q),
      .fine_o
  );
  assign push_o = busy_q[3];

endmodule
`default_nettype wire
