// SPDX-License-Identifier: Apache-2.0
// rtl/engine/column_sum.sv adds as hls/engine.hpp does: a column begins with the sum before,
// shifted by a limb, and with its half where it rounds; and 34 bits hold every sum of an
// instruction: three products and a limb a column.
// control: NO_HALF s/round \&\& sum_o\[14\]/1'b0/
// control: OTHER_HALF s/round \&\& sum_o\[14\]/round \&\& sum_o[13]/
// control: LOGICAL_SHIFT s/sum_o >>> 15/sum_o >> 15/
// control: BEGINS_EARLY s/= control_q\[2\]/= control_q[1]/
// control: KEEPS_ON s/if (afresh) base = '0/if (begins \&\& afresh \&\& round) base = '0/
`default_nettype none
module column_sum_formal (
    input wire logic               clk_i,
    input wire logic               rst_ni,
    input wire logic               begins_i,
    input wire logic               afresh_i,
    input wire logic               round_i,
    input wire logic signed [31:0] product_i
);

  logic signed [33:0] sum;
  column_sum u_dut (
      .clk_i,
      .begins_i,
      .afresh_i,
      .round_i,
      .product_i,
      .sum_o(sum)
  );

  // The term whose product is there was said three clocks before.
  logic [2:0] begins_q, afresh_q, round_q;
  logic [2:0] terms_q;  // of the column, with this one
  logic known_q;  // an instruction has begun
  logic known;
  logic begins, afresh, round;
  logic [2:0] terms;
  logic signed [39:0] total_q;
  logic signed [39:0] total;
  assign begins = begins_q[2];
  assign afresh = afresh_q[2];
  assign round  = round_q[2];
  assign known  = known_q || afresh;
  assign terms  = begins ? 3'd1 : terms_q + 3'd1;
  always_comb begin
    total = total_q;
    if (begins) total = (total_q >>> 15) + (round && (total_q & 40'sd16384) != 0 ? 40'sd1 : 40'sd0);
    if (afresh) total = '0;
    total = total + 40'(product_i);
  end

  logic [2:0] started_q = '0;  // reset lasts three clocks: what was said before them is over
  always_ff @(posedge clk_i) begin
    started_q <= {started_q[1:0], 1'b1};
    begins_q  <= {begins_q[1:0], begins_i};
    afresh_q  <= {afresh_q[1:0], afresh_i};
    round_q   <= {round_q[1:0], round_i};
    if (!rst_ni) begin
      known_q <= 1'b0;
      terms_q <= '0;
      total_q <= '0;
    end else begin
      known_q <= known;
      terms_q <= terms;
      total_q <= known ? total : '0;
    end
  end

  localparam logic signed [39:0] Product = 40'sd1 <<< 30;
  localparam logic signed [39:0] Limb = 40'sd1 <<< 15;
  logic signed [39:0] most;
  assign most = 40'sd131072 + (terms_q > 3'd3 ? 40'sd3 * Product + Limb : $signed(
      {37'd0, terms_q}
  ) * Product);
  always_comb begin
    if (!started_q[2]) assume (!rst_ni);
    if (afresh_i || round_i) assume (begins_i);
    if (afresh_i) assume (!round_i);
    // A column has three products, and a limb behind them.
    if (known && rst_ni) assume (terms <= 3'd4);
    if (terms == 3'd4) assume (product_i >= -Limb && product_i < Limb);
    assume (product_i >= -Product && product_i <= Product);
    if (started_q[2] && rst_ni && known_q) begin
      Sum : assert (40'(sum) == total_q);
      Fits : assert (total_q <= most && total_q >= -most && terms_q <= 3'd4);

      Full : cover (terms_q == 3'd4 && total_q > 40'sd3 * Product);
      Rounds : cover (round && total_q[14] && total_q[39]);
    end
  end

endmodule
`default_nettype wire
