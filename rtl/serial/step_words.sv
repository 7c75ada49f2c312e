// SPDX-License-Identifier: Apache-2.0
// Words of a step for its bank (rtl/sampler/bank_pkg.sv), a clock after they are written to the
// word memory of the networks' program (serial/program_word.hpp, serial/spline_places.hpp):
//
//   Mode 0            X Y Z         orders from 1 of rows 0, 2, 4
//   Mode 1, arcs      X Y Z, F G H  order 0 of rows 0, 2, 4 and 1, 3, 5
//                     Own           the sine, odd orders of row 6; the cosine, even ones of row 7
//   Mode 1, splines   Own           orders of row 16
//                     X Y Z         V, order 0 of rows 22 to 24; B' and a', places 5 and 3 of rows
//                                   1, 3, 5
`default_nettype none
module step_words #(
    parameter int Curves   = 3,   // 1 lines and arcs, 2 splines, 3 both
    parameter int Order    = 6,   // [2, 12]
    parameter int CoefBits = 36,  // [18, 36]
    parameter int Mode     = 0    // 0 series, 1 polynomial
) (
    input wire logic clk_i,
    input wire logic rst_ni,

    input wire logic                spline_i,
    input wire logic [         1:0] bank_i,
    input wire logic                write_i,
    input wire logic [         8:0] address_i,
    input wire logic [CoefBits-1:0] word_i,

    output logic [          bank_pkg::Bits-1:0] arc_write_o,
    output logic [          bank_pkg::Bits-1:0] spline_write_o,
    output logic [bank_pkg::Lanes*CoefBits-1:0] words_o
);

  logic [               4:0] row;
  logic [               3:0] place;
  logic [               2:0] axis;  // a bit each
  logic [bank_pkg::Bits-1:0] write;
  assign row   = address_i[8:4];
  assign place = address_i[3:0];
  always_comb begin
    axis = 3'b000;
    if (row[4:3] == 2'd0) begin
      case (row[2:1])
        2'd0:    axis = 3'b001;
        2'd1:    axis = 3'b010;
        2'd2:    axis = 3'b100;
        default: axis = 3'b000;
      endcase
    end
  end

  always_comb begin
    write = '0;
    write[bank_pkg::Bank+:2] = bank_i;
    write[bank_pkg::OwnPlace+:4] = place;
    write[bank_pkg::Place+:4] = place;
    if (Mode == 0) begin
      if (!row[0] && place != 4'd0) write[bank_pkg::Lane+bank_pkg::X+:3] = axis;
    end else if (Curves == 2 || (Curves == 3 && spline_i)) begin
      write[bank_pkg::Lane+bank_pkg::Own] = row == 5'd16;
      if (row[0] && (place == 4'd3 || place == 4'd5)) begin
        write[bank_pkg::Lane+bank_pkg::X+:3] = axis;
        write[bank_pkg::Place+:4] = place[1] ? 4'd3 : 4'd2;
      end
      if (row >= 5'd22 && row <= 5'd24 && place == 4'd0) begin
        write[bank_pkg::Lane+bank_pkg::X+:3] = {row[3], row[0] && !row[3], !row[0] && !row[3]};
        write[bank_pkg::Place+:4] = 4'd1;
      end
    end else begin
      if (!row[0] && place == 4'd0) write[bank_pkg::Lane+bank_pkg::X+:3] = axis;
      if (row[0] && place == 4'd0) write[bank_pkg::Lane+bank_pkg::F+:3] = axis;
      write[bank_pkg::Lane+bank_pkg::Own] = row[4:1] == 4'd3 && row[0] != place[0] &&
          place != 4'd0 && place <= 4'(Order);
    end
    if (!write_i || !rst_ni) write[bank_pkg::Lane+:bank_pkg::Lanes] = '0;
  end

  logic                      spline_q;
  logic [bank_pkg::Bits-1:0] write_q;
  logic [      CoefBits-1:0] word_q;
  always_ff @(posedge clk_i) begin
    spline_q <= Curves == 2 || (Curves == 3 && spline_i);
    write_q  <= write;
    word_q   <= word_i;
  end
  assign words_o = {bank_pkg::Lanes{word_q}};
  always_comb begin
    arc_write_o    = write_q;
    spline_write_o = write_q;
    if (spline_q) arc_write_o[bank_pkg::Lane+:bank_pkg::Lanes] = '0;
    else spline_write_o[bank_pkg::Lane+:bank_pkg::Lanes] = '0;
  end

endmodule
`default_nettype wire
