// SPDX-License-Identifier: Apache-2.0
// Carries of an adder in LUTs, one after the other: Yosys' own, which are fast, need more of them.
(* techmap_celltype = "$lcu" *)
module gowin_carries (P, G, CI, CO);
  parameter WIDTH = 2;
  input [WIDTH-1:0] P;
  input [WIDTH-1:0] G;
  input CI;
  output [WIDTH-1:0] CO;
  genvar n;
  generate
    for (n = 0; n < WIDTH; n = n + 1) begin : g_carry
      if (n == 0) assign CO[n] = G[n] | (P[n] & CI);
      else assign CO[n] = G[n] | (P[n] & CO[n-1]);
    end
  endgenerate
endmodule
