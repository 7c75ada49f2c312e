// SPDX-License-Identifier: Apache-2.0
// The engine's large memory, limb by limb: queues of words and stop branches.
//
//   clock       0       1       2
//   address_i   1       1               limbs of the address, low one first
//   write_i                     1       at the address, which goes on by one
//   read_i                      1       the same
//   limb_o                              1       what was read, a clock behind
`default_nettype none
module engine_store #(
    parameter int Limbs = 26112,  // [16, 262144], with Form 2 65536 at most
    parameter int Form  = 0       // 2: SPRAM of UP5K
) (
    input wire logic clk_i,

    input wire logic        address_i,
    input wire logic        high_i,     // data_i is the address' second limb
    input wire logic        write_i,
    input wire logic [15:0] data_i,

    input  wire logic        read_i,
    output logic      [15:0] limb_o
);

  initial if (Limbs < 16 || Limbs > 262144) $fatal(1, "Limbs must be in [16, 262144]");
  localparam int PlaceBits = $clog2(Limbs);

  logic [17:0] address_q;
  always_ff @(posedge clk_i) begin
    if (address_i) begin
      if (high_i) address_q[17:15] <= data_i[2:0];
      else address_q <= {3'd0, data_i[14:0]};
    end else if (write_i || read_i) begin
      address_q <= address_q + 1'b1;
    end
  end

  if (Form == 2) begin : g_spram
    localparam int Blocks = (Limbs + 16383) / 16384;
    initial if (Blocks > 4) $fatal(1, "Form 2 works with Limbs up to 65536 only");
    logic [15:0] limbs[4];
    logic [1:0] block_q;
    for (genvar n = 0; n < 4; n++) begin : g_block
      if (n < Blocks) begin : g_memory
        SB_SPRAM256KA u_memory (
            .ADDRESS(address_q[13:0]),
            .DATAIN(data_i),
            .MASKWREN(4'hf),
            .WREN(write_i && address_q[15:14] == 2'(n)),
            .CHIPSELECT(1'b1),
            .CLOCK(clk_i),
            .STANDBY(1'b0),
            .SLEEP(1'b0),
            .POWEROFF(1'b1),
            .DATAOUT(limbs[n])
        );
      end else begin : g_none
        assign limbs[n] = '0;
      end
    end
    always_ff @(posedge clk_i) block_q <= address_q[15:14];
    assign limb_o = limbs[block_q];
  end else begin : g_memory
    logic [15:0] memory[Limbs];
    always_ff @(posedge clk_i) begin
      if (write_i) memory[address_q[PlaceBits-1:0]] <= data_i;
      limb_o <= memory[address_q[PlaceBits-1:0]];
    end
  end

  logic unused_address;
  assign unused_address = &{1'b0, address_q};

endmodule
`default_nettype wire
