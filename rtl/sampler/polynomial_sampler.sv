// SPDX-License-Identifier: Apache-2.0
// Displacements as r0 cos + f0 sin, in units of 2^k: from two series of the angle in tau2 = tau^2,
//
//     sine = y_1 + y_3 tau2 + ..     versine = z_2 tau2 + z_4 tau2^2 + ..     (y_1 = 1)
//     d = (t sine + advance) tau + n versine
//
// Twin: hls/curves/arc.hpp, polynomial mode.
//
//   clock           0        5    B = 5 + Lv      B+1      B+Offset    B+1+Offset    Latency
//                   tau_i    tau2 versine, sine   t sine   n versine   rate tau      d_o, tag_o
//
//   Lv = horner latency of Order / 2 passes;  Offset = 6, for SampleInterval 2: 7
//   Latency = Lv + Offset + 12
`default_nettype none
module polynomial_sampler #(
    parameter int Order          = 6,   // [2, 12]
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int SampleInterval = 1,   // 1, 2, 4, 8
    parameter int TagBits        = 5,   // the low two are the bank
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    // Words of spherical_steps, into a bank; a rate {there, axis, rate} into the one that write_i
    // names
    input wire logic [                CoefBits+4:0] rate_i,
    input wire logic [          bank_pkg::Bits-1:0] write_i,
    input wire logic [bank_pkg::Lanes*CoefBits-1:0] words_i,

    // Samples
    input  wire logic [           2:0] phase_i,
    input  wire logic                  valid_i,
    input  wire logic [  CoefBits-1:0] tau_i,
    input  wire logic [   TagBits-1:0] tag_i,
    output logic                       valid_o,
    output logic      [3*CoefBits-1:0] d_o,
    output logic      [   TagBits-1:0] tag_o
);

  localparam int Square = curvecore_pkg::MultiplierLatency;
  localparam int SinePasses = (Order - 1) / 2;
  localparam int VersinePasses = Order / 2;
  localparam int VersineClocks = curvecore_pkg::horner_latency(VersinePasses, SampleInterval);
  localparam int Base = Square + VersineClocks;
  localparam int Offset = (SampleInterval == 2) ? 7 : 6;
  localparam int Tail = Offset + 7;  // clocks from Base to the result
  localparam logic [2:0] PhaseMask = 3'(SampleInterval - 1);

  logic       unused_place;
  logic       collect;
  logic [1:0] bank;
  logic [3:0] order;
  assign unused_place = &write_i;
  assign collect = write_i[bank_pkg::Lane+bank_pkg::Own];
  assign bank    = write_i[bank_pkg::Bank+:2];
  assign order   = write_i[bank_pkg::OwnPlace+:4];

  // Coefficients of the angle: odd orders are the sine's, even ones the versine's.
  logic                       write_sine_q;
  logic                       write_versine_q;
  logic        [         1:0] bank_q;
  logic        [         3:0] sine_pass;
  logic        [         3:0] versine_pass;
  logic        [         3:0] order_q;
  logic signed [CoefBits-1:0] angle_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      write_sine_q    <= 1'b0;
      write_versine_q <= 1'b0;
    end else begin
      write_sine_q    <= collect && order[0] && order != 4'd1;
      write_versine_q <= collect && !order[0];
    end
  end
  always_ff @(posedge clk_i) begin
    if (collect) begin
      bank_q  <= bank;
      order_q <= order;
      angle_q <= words_i[bank_pkg::Own*CoefBits+:CoefBits];
    end
  end
  assign sine_pass    = 4'(SinePasses) - {1'b0, order_q[3:1]};
  assign versine_pass = 4'(VersinePasses) - {1'b0, order_q[3:1]};

  // tau2 = tau^2
  logic signed [ CoefBits:0] tau2;
  logic        [ Square-1:0] valid_q;
  logic        [TagBits-1:0] tag_late;
  logic        [        2:0] tau2_phase;
  multiplier #(
      .ABits(CoefBits),
      .BBits(CoefBits),
      .Shift(CoefBits - 1),
      .Form (MultiplierForm)
  ) u_square (
      .clk_i,
      .en_i(1'b1),
      .a_i(tau_i),
      .b_i(tau_i),
      .product_o(tau2)
  );
  delay_line #(
      .Bits  (TagBits),
      .Clocks(Square)
  ) u_tag (
      .clk_i,
      .rst_ni,
      .en_i  (1'b1),
      .data_i(tag_i),
      .data_o(tag_late)
  );
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= {valid_q[Square-2:0], valid_i};
  end
  assign tau2_phase = phase_i - 3'(Square);

  logic                versine_valid;
  logic [CoefBits-1:0] versine;
  logic [ TagBits-1:0] versine_tag;
  horner #(
      .Passes(VersinePasses),
      .Lanes(1),
      .Bits(CoefBits),
      .Shift(CoefBits - 1),
      .Interval(SampleInterval),
      .BankBits(2),
      .TagBits(TagBits),
      .Form(MultiplierForm)
  ) u_versine (
      .clk_i,
      .rst_ni,
      .en_i(1'b1),
      .write_i(write_versine_q),
      .write_lanes_i({1{1'b1}}),
      .write_bank_i(bank_q),
      .write_pass_i(versine_pass),
      .write_coef_i(angle_q),
      .phase_i(tau2_phase & PhaseMask),
      .valid_i(valid_q[Square-1]),
      .x_i(tau2[CoefBits-1:0]),
      .tag_i(tag_late),
      .valid_o(versine_valid),
      .d_o(versine),
      .tag_o(versine_tag)
  );

  // The sine minus one, as late as the versine.
  logic [CoefBits-1:0] less;
  if (SinePasses > 0) begin : g_sine
    logic                unused_valid;
    logic [CoefBits-1:0] early;
    logic [ TagBits-1:0] unused_tag;
    horner #(
        .Passes(SinePasses),
        .Lanes(1),
        .Bits(CoefBits),
        .Shift(CoefBits - 1),
        .Interval(SampleInterval),
        .BankBits(2),
        .TagBits(TagBits),
        .Form(MultiplierForm)
    ) u_sine (
        .clk_i,
        .rst_ni,
        .en_i(1'b1),
        .write_i(write_sine_q),
        .write_lanes_i({1{1'b1}}),
        .write_bank_i(bank_q),
        .write_pass_i(sine_pass),
        .write_coef_i(angle_q),
        .phase_i(tau2_phase & PhaseMask),
        .valid_i(valid_q[Square-1]),
        .x_i(tau2[CoefBits-1:0]),
        .tag_i(tag_late),
        .valid_o(unused_valid),
        .d_o(early),
        .tag_o(unused_tag)
    );
    delay_line #(
        .Bits  (CoefBits),
        .Clocks(VersineClocks - curvecore_pkg::horner_latency(SinePasses, SampleInterval))
    ) u_wait (
        .clk_i,
        .rst_ni,
        .en_i  (1'b1),
        .data_i(early),
        .data_o(less)
    );
  end else begin : g_one
    logic unused;
    assign unused = &{write_sine_q, sine_pass};
    assign less   = '0;
  end

  // The three axes.
  logic signed [CoefBits-1:0] sine_q;
  logic        [CoefBits-1:0] versine_late;
  logic        [CoefBits-1:0] tau_late;
  logic        [         2:0] sine_phase;
  logic        [         2:0] versine_phase;
  delay_line #(
      .Bits  (CoefBits),
      .Clocks(Offset)
  ) u_versine_wait (
      .clk_i,
      .rst_ni,
      .en_i  (1'b1),
      .data_i(versine),
      .data_o(versine_late)
  );
  delay_line #(
      .Bits  (CoefBits),
      .Clocks(Base + 1 + Offset)
  ) u_tau_wait (
      .clk_i,
      .rst_ni,
      .en_i  (1'b1),
      .data_i(tau_i),
      .data_o(tau_late)
  );
  always_ff @(posedge clk_i) begin
    sine_q <= less + {2'b01, {(CoefBits - 2) {1'b0}}};
  end
  assign sine_phase    = (phase_i - 3'((Base + 1) % 8)) & PhaseMask;
  assign versine_phase = (phase_i - 3'((Base + Offset) % 8)) & PhaseMask;

  // Samples and their places, from clock Base on.
  logic [   Tail-1:0] sample_valid_q;
  logic [TagBits-1:0] sample_tag_q  [Tail];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) sample_valid_q <= '0;
    else sample_valid_q <= {sample_valid_q[Tail-2:0], versine_valid};
  end
  always_ff @(posedge clk_i) begin
    sample_tag_q[0] <= versine_tag;
    for (int c = 1; c < Tail; c++) sample_tag_q[c] <= sample_tag_q[c-1];
  end
  assign valid_o = sample_valid_q[Tail-1];
  assign tag_o   = sample_tag_q[Tail-1];

  for (genvar a = 0; a < 3; a++) begin : g_axis
    logic advance_write;
    assign advance_write = rate_i[CoefBits+4] && rate_i[CoefBits+:4] == 4'(a);
    polynomial_axis #(
        .CoefBits(CoefBits),
        .SampleInterval(SampleInterval),
        .MultiplierForm(MultiplierForm)
    ) u_axis (
        .clk_i,
        .bank_i(bank),
        .advance_write_i(advance_write),
        .advance_i(rate_i[CoefBits-1:0]),
        .normal_write_i(write_i[bank_pkg::Lane+bank_pkg::X+a]),
        .normal_i(words_i[(bank_pkg::X+a)*CoefBits+:CoefBits]),
        .tangent_write_i(write_i[bank_pkg::Lane+bank_pkg::F+a]),
        .tangent_i(words_i[(bank_pkg::F+a)*CoefBits+:CoefBits]),
        .tangent_bank_i(versine_tag[1:0]),
        .advance_bank_i(sample_tag_q[5][1:0]),
        .normal_bank_i(sample_tag_q[Offset-2][1:0]),
        .sine_phase_i(sine_phase == 3'd0),
        .versine_phase_i(versine_phase == 3'd0),
        .sine_i(sine_q),
        .versine_i(versine_late),
        .tau_i(tau_late),
        .d_o(d_o[a*CoefBits+:CoefBits])
    );
  end

endmodule
`default_nettype wire
