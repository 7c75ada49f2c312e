// SPDX-License-Identifier: Apache-2.0
// Displacements of the auxiliary axes, d = advance tau in units of 2^k, as late as those of xyz.
//
//   clock           0                       Latency
//   phase_i         0
//                   tau_i, tau_bank_i       d_o
`default_nettype none
module auxiliary_sampler #(
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int AuxAxes        = 1,   // [1, 6]
    parameter int SampleInterval = 1,   // 1, 2, 4, 8
    parameter int Latency        = 37,  // two or more above that of a `horner` of one pass
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Words of the segment, into a bank
    input wire logic [         1:0] bank_i,
    input wire logic [CoefBits+4:0] rate_i,  // {there, axis, rate}

    // Samples
    input  wire logic [                 2:0] phase_i,
    input  wire logic [        CoefBits-1:0] tau_i,
    input  wire logic [                 1:0] tau_bank_i,
    output logic      [AuxAxes*CoefBits-1:0] d_o
);

  localparam int Wait = Latency - curvecore_pkg::horner_latency(1, SampleInterval);

  logic [CoefBits+1:0] late;
  logic [         2:0] late_phase;
  delay_line #(
      .Bits  (CoefBits + 2),
      .Clocks(Wait)
  ) u_delay (
      .clk_i,
      .rst_ni,
      .en_i  (1'b1),
      .data_i({tau_bank_i, tau_i}),
      .data_o(late)
  );
  assign late_phase = phase_i - 3'(Wait % 8);

  // Lanes are written one at a time.
  for (genvar a = 0; a < AuxAxes; a++) begin : g_axis
    logic write;
    logic unused_valid;
    logic [1:0] unused_tag;
    assign write = rate_i[CoefBits+4] && rate_i[CoefBits+:4] == 4'(a + 3);
    horner #(
        .Passes(1),
        .Lanes(1),
        .Bits(CoefBits),
        .Shift(CoefBits - 1),
        .Interval(SampleInterval),
        .BankBits(2),
        .TagBits(2),
        .Form(MultiplierForm)
    ) u_horner (
        .clk_i,
        .rst_ni,
        .en_i(1'b1),
        .write_i(write),
        .write_lanes_i({1{1'b1}}),
        .write_bank_i(bank_i),
        .write_pass_i(4'd0),
        .write_coef_i(rate_i[CoefBits-1:0]),
        .phase_i(late_phase & 3'(SampleInterval - 1)),
        .valid_i(1'b0),
        .x_i(late[CoefBits-1:0]),
        .tag_i(late[CoefBits+1:CoefBits]),
        .valid_o(unused_valid),
        .d_o(d_o[a*CoefBits+:CoefBits]),
        .tag_o(unused_tag)
    );
  end

endmodule
`default_nettype wire
