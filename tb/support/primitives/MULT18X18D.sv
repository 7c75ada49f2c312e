// SPDX-License-Identifier: Apache-2.0
// Behaviour of the ECP5 DSP multiplier as `dsp_ecp5` uses it: input, output and perhaps pipeline
// registers on CLK0 with CE0 and the synchronous RST0, no cascade.  After Lattice's "ECP5 and
// ECP5-5G sysDSP Usage Guide" (FPGA-TN-02205); the signs travel with the operands.
`default_nettype none
module MULT18X18D #(
    parameter REG_INPUTA_CLK   = "NONE",
    parameter REG_INPUTB_CLK   = "NONE",
    parameter REG_PIPELINE_CLK = "NONE",
    parameter REG_OUTPUT_CLK   = "NONE"
) (
    input  wire CLK0,
    CE0,
    RST0,
    input  wire SIGNEDA,
    SIGNEDB,
    SOURCEA,
    SOURCEB,
    input  wire A0,
    A1,
    A2,
    A3,
    A4,
    A5,
    A6,
    A7,
    A8,
    A9,
    A10,
    A11,
    A12,
    A13,
    A14,
    A15,
    A16,
    A17,
    input  wire B0,
    B1,
    B2,
    B3,
    B4,
    B5,
    B6,
    B7,
    B8,
    B9,
    B10,
    B11,
    B12,
    B13,
    B14,
    B15,
    B16,
    B17,
    output wire P0,
    P1,
    P2,
    P3,
    P4,
    P5,
    P6,
    P7,
    P8,
    P9,
    P10,
    P11,
    P12,
    P13,
    P14,
    P15,
    P16,
    P17,
    P18,
    P19,
    P20,
    P21,
    P22,
    P23,
    P24,
    P25,
    P26,
    P27,
    P28,
    P29,
    P30,
    P31,
    P32,
    P33,
    P34,
    P35
);

  wire [17:0] a = {A17, A16, A15, A14, A13, A12, A11, A10, A9, A8, A7, A6, A5, A4, A3, A2, A1, A0};
  wire [17:0] b = {B17, B16, B15, B14, B13, B12, B11, B10, B9, B8, B7, B6, B5, B4, B3, B2, B1, B0};

  reg  [18:0] a_q;
  reg  [18:0] b_q;
  reg  [37:0] pipeline_q;
  reg  [35:0] output_q;
  wire [37:0] a_wide = {{19{a_q[18]}}, a_q};
  wire [37:0] b_wide = {{19{b_q[18]}}, b_q};

  wire [37:0] direct = a_wide * b_wide;

  always @(posedge CLK0) begin
    if (RST0) begin
      a_q <= 19'd0;
      b_q <= 19'd0;
      pipeline_q <= 38'd0;
      output_q <= 36'd0;
    end else if (CE0) begin
      a_q <= {SIGNEDA & a[17], a};
      b_q <= {SIGNEDB & b[17], b};
      pipeline_q <= direct;
      output_q <= REG_PIPELINE_CLK == "CLK0" ? pipeline_q[35:0] : direct[35:0];
    end
  end

  assign {
    P35, P34, P33, P32, P31, P30, P29, P28, P27,
    P26, P25, P24, P23, P22, P21, P20, P19, P18,
    P17, P16, P15, P14, P13, P12, P11, P10, P9,
    P8, P7, P6, P5, P4, P3, P2, P1, P0
  } = output_q;

  initial begin
    if (REG_INPUTA_CLK != "CLK0" || REG_INPUTB_CLK != "CLK0") $fatal(1, "input registers unused");
    if (REG_PIPELINE_CLK != "CLK0" && REG_PIPELINE_CLK != "NONE") $fatal(1, "no such clock");
    if (REG_OUTPUT_CLK != "CLK0") $fatal(1, "output register unused");
    if (SOURCEA || SOURCEB) $fatal(1, "cascades are not modelled");
  end

endmodule
`default_nettype wire
