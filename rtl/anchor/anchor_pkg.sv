// SPDX-License-Identifier: Apache-2.0
// Operations of rtl/anchor/spline_anchor.sv.
package anchor_pkg;
  localparam logic [3:0] Nothing = 4'd0;
  localparam logic [3:0] Mean = 4'd1;  // b + 3a v / 2
  localparam logic [3:0] V = 4'd2;  // 2c + 2 mean v
  localparam logic [3:0] Slope = 4'd3;  // b + 3a v
  localparam logic [3:0] N = 4'd4;  // V.V
  localparam logic [3:0] M = 4'd5;  // -(N phi)
  localparam logic [3:0] Z = 4'd6;  // 1 - m phi
  localparam logic [3:0] Phi = 4'd7;  // phi + z phi / 2
  localparam logic [3:0] S = 4'd8;  // phi^2
  localparam logic [3:0] Q = 4'd9;  // -(S phi)
  localparam logic [3:0] E = 4'd10;  // b + a v
  localparam logic [3:0] F = 4'd11;  // c + e v
  localparam logic [3:0] D = 4'd12;  // f v
endpackage
