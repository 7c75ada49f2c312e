// SPDX-License-Identifier: Apache-2.0
// A word, `Clocks` enabled clocks later; long delays are small memories.
`default_nettype none
module delay_line #(
    parameter int Bits   = 36,  // [1, 64]
    parameter int Clocks = 6    // [0, 128]
) (
    input  wire logic            clk_i,
    input  wire logic            rst_ni,
    input  wire logic            en_i,
    input  wire logic [Bits-1:0] data_i,
    output logic      [Bits-1:0] data_o
);

  if (Clocks == 0) begin : g_wire
    logic unused;
    assign unused = &{clk_i, rst_ni, en_i};
    assign data_o = data_i;
  end else if (Clocks <= 3) begin : g_registers
    logic unused;
    assign unused = rst_ni;
    logic [Bits-1:0] data_q[Clocks];
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        data_q[0] <= data_i;
        for (int i = 1; i < Clocks; i++) data_q[i] <= data_q[i-1];
      end
    end
    assign data_o = data_q[Clocks-1];
  end else begin : g_ring
    localparam int PlaceBits = $clog2(Clocks - 1);
    localparam logic [PlaceBits-1:0] Top = PlaceBits'(Clocks - 2);
    logic [PlaceBits-1:0] place_q;
    (* ram_style = "distributed" *)logic [     Bits-1:0] ring    [2**PlaceBits];
    always_ff @(posedge clk_i) begin
      if (!rst_ni) place_q <= '0;
      else if (en_i) place_q <= (place_q == Top) ? '0 : place_q + PlaceBits'(1);
    end
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        data_o        <= ring[place_q];
        ring[place_q] <= data_i;
      end
    end
  end

endmodule
`default_nettype wire
