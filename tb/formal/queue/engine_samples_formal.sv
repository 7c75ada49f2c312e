// SPDX-License-Identifier: Apache-2.0
// rtl/engine/engine_samples.sv: samples come out whole and as they went in, each is offered until
// it is taken; nothing gets stuck. Samples are numbered, modulo more than the ring holds, and each
// limb has its sample's number.
// control: OVERWRITES s/ \&\& !full_q;/;/
// control: EARLY s/valid_o <= full_q/valid_o <= (full_q || (reads \&\& last))/
// control: LOSES_SAMPLE s/if (whole_i) put_q/if (whole_i \&\& data_i != 16'd5) put_q/
// control: GOES_ON s/if (whole_i) write_q <= '0;/if (whole_i) write_q <= write_q;/
// control: DOUBLES_SAMPLE s/if (reads \&\& last) take_q/if (reads \&\& last \&\& ready_i) take_q/
// control: NO_RESET s/put_q   <= '0;/put_q <= put_q;/
`default_nettype none
module engine_samples_formal (
    input wire logic clk_i,
    input wire logic rst_ni,
    input wire logic limb_i,
    input wire logic whole_i,
    input wire logic ready_i
);

  localparam int Places = 2;  // fewer than the engine has
  localparam int Low = 15;  // bits of a limb
  localparam int FineBits = 33;

  logic [1:0] limbs_q;  // of the sample at hand
  logic [2:0] written_q;
  logic [2:0] received_q;
  logic valid;
  logic [FineBits-1:0] data;

  engine_samples #(
      .Axes    (1),
      .FineBits(FineBits),
      .Places  (Places)
  ) u_dut (
      .clk_i,
      .rst_ni,
      .limb_i,
      .whole_i,
      .data_i ({13'd0, written_q}),
      .valid_o(valid),
      .ready_i,
      .data_o (data)
  );

  logic [2:0] held;
  assign held = written_q - received_q;

  logic started_q = 1'b0;
  logic kept_q;  // an offer that was not taken in the cycle before
  logic [4:0] hidden_q;  // a sample is inside, but not offered
  always_ff @(posedge clk_i) begin
    started_q <= 1'b1;
    kept_q    <= rst_ni && valid && !ready_i;
    hidden_q  <= {hidden_q[3:0], rst_ni && held != '0 && !valid};
    if (!rst_ni) begin
      limbs_q    <= '0;
      written_q  <= '0;
      received_q <= '0;
    end else begin
      if (whole_i) limbs_q <= '0;
      else if (limb_i) limbs_q <= limbs_q + 1'b1;
      if (whole_i) written_q <= written_q + 1'b1;
      if (valid && ready_i) received_q <= received_q + 1'b1;
    end
  end

  always_comb begin
    if (!started_q) begin
      assume (!rst_ni);
    end else if (rst_ni) begin
      if (limb_i) assume (limbs_q != 2'd3 && held != 3'(Places));
      if (whole_i) assume (limbs_q == 2'd3 && !limb_i);

      if (valid) InOrder0 : assert (data[2:0] == received_q);
      if (valid) InOrder1 : assert (data[Low+:3] == received_q);
      if (valid) InOrder2 : assert (data[2*Low+:3] == received_q);
      if (valid) NothingInvented : assert (held != '0);
      if (kept_q) KeepsOffer : assert (valid);
      if (hidden_q == '1) NeverStuck : assert (valid);

      Fills : cover (held == 3'(Places) && valid);
      Streams : cover (received_q == 3'd7 && valid && ready_i && limb_i);
    end
  end

endmodule
`default_nettype wire
