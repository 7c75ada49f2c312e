// SPDX-License-Identifier: Apache-2.0
// Bytes of SLIP, RFC 1055.
`default_nettype none
package slip_pkg;
  localparam logic [7:0] End = 8'hc0;
  localparam logic [7:0] Escape = 8'hdb;
  localparam logic [7:0] EscapedEnd = 8'hdc;
  localparam logic [7:0] EscapedEscape = 8'hdd;
endpackage
`default_nettype wire
