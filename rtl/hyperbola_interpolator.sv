// SPDX-License-Identifier: Apache-2.0
// A hyperbola y = 1 / (k (t0 + t)) in steps of h: [Chikurov] Fig. 3 as a core of its own.
// Twin: hls::HyperbolaNetwork.
//
// Each step gives the series of y and of its derivative z in tau (0 .. 1 over the step), one order
// per pulse of y_valid_o, of z_valid_o; order_o is that of both.
//
//   cycle                                      Digits = ceil(CoefBits / 2)
//   0                                          step_i and ready_o; with load_i: from y_i, else one
//                                              step on
//   1                                          y_valid_o, order_o = 0
//   14                                         z_valid_o, order_o = 0
//   16 + (i - 1) (Digits + 16) + 2 i (i + 1)   y_valid_o, order_o = i >= 1
//   .. + 4 (i + 1) + 9                         z_valid_o, order_o = i < Order
//   (y of Order's) + 1                         ready_o again
//
// With Anchor = 0, unless load_i, z_0 comes with y_0 and all else 13 clocks earlier; and in every
// step z of order Order comes too, 4 (Order + 1) + 9 clocks after y's, and ready_o after it.
//
// Formats: CoefBits fraction bits, of h k y = h / (t0 + t) and h^2 k z.  Legal: 0 < y_i < 1/2.
`default_nettype none
module hyperbola_interpolator #(
    parameter int Order          = 6,   // [2, 12]
    parameter int CoefBits       = 36,  // [18, 36]
    parameter int Anchor         = 1,   // 0, 1
    parameter int MultiplierForm = 0    // 0 portable, 1 ECP5, 2 UP5K
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input  wire logic                       step_i,
    output logic                            ready_o,
    input  wire logic                       load_i,
    input  wire logic signed [CoefBits-1:0] y_i,

    output logic                       y_valid_o,
    output logic                       z_valid_o,
    output logic        [         3:0] order_o,
    output logic signed [CoefBits-1:0] y_o,
    output logic signed [CoefBits-1:0] z_o
);

  initial if (Order < 2 || Order > 12) $fatal(1, "Order must be in [2, 12]");
  initial if (CoefBits < 18 || CoefBits > 36) $fatal(1, "CoefBits must be in [18, 36]");
  initial if (Anchor < 0 || Anchor > 1) $fatal(1, "Anchor must be 0 or 1");
  initial
    if (MultiplierForm < 0 || MultiplierForm > 2) $fatal(1, "MultiplierForm must be in [0, 2]");

  logic rst_n;
  reset_stretcher u_reset (
      .clk_i,
      .rst_ni,
      .rst_no(rst_n)
  );

  // A step: y_0, from y_i or from the last step.  The nodes' reset is a clock late.
  logic reset_late_q;
  logic busy_q;
  logic fresh_q;
  logic begins;
  logic load;
  logic again;
  logic done;
  assign ready_o = !busy_q && rst_n && reset_late_q;
  assign begins  = step_i && ready_o;
  assign load    = begins && load_i;
  assign again   = begins && !load_i;
  always_ff @(posedge clk_i) begin
    reset_late_q <= rst_n;
    if (!rst_n) busy_q <= 1'b0;
    else if (begins) busy_q <= 1'b1;
    else if (done) busy_q <= 1'b0;
    if (begins) fresh_q <= load_i;
  end

  // z_i follows y_i, except those not read and a carried z_0.
  localparam logic [3:0] LastZ = (Anchor != 0) ? 4'(Order - 1) : 4'(Order);
  logic [CoefBits+4:0] y;
  logic [CoefBits+4:0] z;
  logic [         3:0] order;
  logic                carried;
  logic                start_z;
  logic                again_z;
  assign order   = y[CoefBits+3:CoefBits];
  assign carried = Anchor == 0 && !fresh_q && order == 4'd0;
  assign start_z = y[CoefBits+4] && order <= LastZ && !carried;
  assign again_z = again && Anchor == 0;

  hyperbola_network #(
      .Order(Order),
      .CoefBits(CoefBits),
      .Form(MultiplierForm % 2)
  ) u_network (
      .clk_i,
      .rst_ni(rst_n),
      .control_y_i({load, again}),
      .control_z_i({start_z, order, 1'b0, again_z}),
      .y_i,
      .y_o(y),
      .z_o(z)
  );

  logic last_y;
  logic last_z;
  assign last_y    = y_valid_o && order == 4'(Order);
  assign last_z    = z_valid_o && order == 4'(Order);
  assign done      = (Anchor != 0) ? last_y : last_z;
  assign y_valid_o = y[CoefBits+4];
  assign z_valid_o = z[CoefBits+4];
  assign order_o   = order;
  assign y_o       = y[CoefBits-1:0];
  assign z_o       = z[CoefBits-1:0];

endmodule
`default_nettype wire
