// SPDX-License-Identifier: Apache-2.0
// A large memory of one port, which is written or read. Nobody gives it a content at first.
//
//   clock     0       1
//   place_i   place
//   word_o            word; any behind a write
`default_nettype none
module single_port_memory #(
    parameter int Bits  = 16,     // [1, 64]
    parameter int Words = 26112,  // [16, 262144], with Form 2 65536 at most
    parameter int Form  = 0       // 2: SPRAM of UP5K
) (
    input wire logic clk_i,

    input wire logic                     write_i,
    input wire logic [$clog2(Words)-1:0] place_i,
    input wire logic [         Bits-1:0] word_i,

    output logic [Bits-1:0] word_o
);

  initial if (Words < 16 || Words > 262144) $fatal(1, "Words must be in [16, 262144]");

  if (Form == 2) begin : g_spram
    localparam int Slices = (Bits + 15) / 16;
    localparam int Blocks = (Words + 16383) / 16384;
    initial if (Blocks > 4) $fatal(1, "Form 2 works with Words up to 65536 only");
    logic [15:0] place;
    logic [1:0] block_q;
    logic [16*Slices-1:0] data;
    logic [16*Slices-1:0] words[4];
    logic [16*Slices-1:0] word;
    assign place = 16'(place_i);
    assign data  = (16 * Slices)'(word_i);
    for (genvar n = 0; n < 4; n++) begin : g_block
      if (n < Blocks) begin : g_memory
        for (genvar s = 0; s < Slices; s++) begin : g_slice
          SB_SPRAM256KA u_memory (
              .ADDRESS(place[13:0]),
              .DATAIN(data[16*s+:16]),
              .MASKWREN(4'hf),
              .WREN(write_i && place[15:14] == 2'(n)),
              .CHIPSELECT(1'b1),
              .CLOCK(clk_i),
              .STANDBY(1'b0),
              .SLEEP(1'b0),
              .POWEROFF(1'b1),
              .DATAOUT(words[n][16*s+:16])
          );
        end
      end else begin : g_none
        assign words[n] = '0;
      end
    end
    always_ff @(posedge clk_i) block_q <= place[15:14];
    assign word   = words[block_q];
    assign word_o = word[Bits-1:0];
  end else begin : g_memory
    (* no_rw_check *)
    logic [Bits-1:0] memory[Words];
    always_ff @(posedge clk_i) begin
      if (write_i) memory[place_i] <= word_i;
      word_o <= memory[place_i];
    end
  end

endmodule
`default_nettype wire
