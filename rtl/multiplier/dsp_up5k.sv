// SPDX-License-Identifier: Apache-2.0
// One UP5K DSP multiplier, 16 x 16 bits, with its input and output registers: the product follows
// its operands two clocks later.
`default_nettype none
module dsp_up5k #(
    parameter int ASigned = 1,  // 0, 1
    parameter int BSigned = 1   // 0, 1
) (
    input  wire logic        clk_i,
    input  wire logic        en_i,
    input  wire logic [15:0] a_i,
    input  wire logic [15:0] b_i,
    output logic      [31:0] product_o
);

  // The output register is the one behind the 16 x 16 multiplier; the adders are bypassed.
  SB_MAC16 #(
      .A_REG(1'b1),
      .B_REG(1'b1),
      .PIPELINE_16x16_MULT_REG2(1'b1),
      .TOPOUTPUT_SELECT(2'd3),
      .BOTOUTPUT_SELECT(2'd3),
      .A_SIGNED(ASigned != 0),
      .B_SIGNED(BSigned != 0)
  ) u_dsp (
      .CLK(clk_i),
      .CE(en_i),
      .A(a_i),
      .B(b_i),
      .C(16'd0),
      .D(16'd0),
      .AHOLD(1'b0),
      .BHOLD(1'b0),
      .CHOLD(1'b0),
      .DHOLD(1'b0),
      .IRSTTOP(1'b0),
      .IRSTBOT(1'b0),
      .ORSTTOP(1'b0),
      .ORSTBOT(1'b0),
      .OLOADTOP(1'b0),
      .OLOADBOT(1'b0),
      .ADDSUBTOP(1'b0),
      .ADDSUBBOT(1'b0),
      .OHOLDTOP(1'b0),
      .OHOLDBOT(1'b0),
      .CI(1'b0),
      .ACCUMCI(1'b0),
      .SIGNEXTIN(1'b0),
      .O(product_o),
      .CO(),
      .ACCUMCO(),
      .SIGNEXTOUT()
  );

endmodule
`default_nettype wire
