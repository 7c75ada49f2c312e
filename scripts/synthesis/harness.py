# SPDX-License-Identifier: Apache-2.0
"""The serialised inputs and outputs of a core under place and route."""


def harness(core, ports):
    """Verilog of module `harness` around `core` (a module and its parameters), whose ports Yosys
    described.

    Every input but the clock is a bit of one shift register, every output is loaded into another:
    all paths of the core begin and end in registers, as in a system that uses it.
    """
    clock = next(name for name in ports if name.startswith("clk"))
    inputs = [(name, len(port["bits"])) for name, port in ports.items()
              if port["direction"] == "input" and name != clock]
    outputs = [(name, len(port["bits"])) for name, port in ports.items()
               if port["direction"] == "output"]
    input_bits = sum(bits for _, bits in inputs)
    output_bits = sum(bits for _, bits in outputs)

    connections = [f".{clock}(clk)"]
    for vector, names in (("in_q", inputs), ("out", outputs)):
        low = 0
        for name, bits in names:
            connections.append(f".{name}({vector}[{low + bits - 1}:{low}])")
            low += bits
    return f"""module harness(input clk, input serial_in, input load, output reg serial_out);
  reg [{input_bits - 1}:0] in_q;
  reg [{output_bits - 1}:0] out_q;
  wire [{output_bits - 1}:0] out;
  reg load_q;
  always @(posedge clk) begin
    in_q <= {{in_q, serial_in}};
    load_q <= load;
    out_q <= load_q ? out : out_q >> 1;
    serial_out <= out_q[0];
  end
  (* keep_hierarchy *)
  {core} dut ({", ".join(connections)});
endmodule
"""
