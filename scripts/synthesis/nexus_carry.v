// SPDX-License-Identifier: Apache-2.0
// Techmap rule for Nexus: a carry that Yosys tied to a constant is left open, as nextpnr-nexus wants
// it; the first cell of a chain makes its own from A1 and does not look at CIN.
(* techmap_celltype = "CCU2" *)
module open_carry (input CIN, A0, B0, C0, D0, A1, B1, C1, D1, output S0, S1, COUT);
  parameter INIT0 = "0x0000", INIT1 = "0x0000", INJECT = "YES";
  parameter _TECHMAP_CONSTMSK_CIN_ = 0;
  wire _TECHMAP_FAIL_ = !_TECHMAP_CONSTMSK_CIN_;
  CCU2 #(.INIT0(INIT0), .INIT1(INIT1), .INJECT(INJECT)) _TECHMAP_REPLACE_ (
    .A0(A0), .B0(B0), .C0(C0), .D0(D0), .A1(A1), .B1(B1), .C1(C1), .D1(D1),
    .S0(S0), .S1(S1), .COUT(COUT));
endmodule
