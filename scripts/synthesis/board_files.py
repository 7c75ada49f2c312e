# SPDX-License-Identifier: Apache-2.0
"""Files made of a board's table: constraints and the top.

Switches have pull-ups and close to ground: a wire that is off is an open switch, which stops.
Without pins of their own limit switches are the home switches too; there is no probe, no encoder.
"""


def lpf(board):
    lines = [f'FREQUENCY PORT "clk" {board.oscillator_hz / 1e6:g} MHZ;']
    for port, pin, pulled_up in board.ports():
        pull = "UP" if pulled_up else "NONE"
        lines += [f'LOCATE COMP "{port}" SITE "{pin}";',
                  f'IOBUF PORT "{port}" IO_TYPE=LVCMOS33 PULLMODE={pull};']
    return "\n".join(lines) + "\n"


def pcf(board):
    lines = [f"set_frequency clk {board.oscillator_hz / 1e6:g}"]
    lines += [f"set_io {'-pullup yes ' if pulled_up else ''}{port} {pin}"
              for port, pin, pulled_up in board.ports()]
    return "\n".join(lines) + "\n"


def cst(board):
    lines = []
    for port, pin, pulled_up in board.ports():
        pull = "UP" if pulled_up else "NONE"
        lines += [f'IO_LOC "{port}" {pin};',
                  f'IO_PORT "{port}" IO_TYPE=LVCMOS33 PULL_MODE={pull};']
    return "\n".join(lines) + "\n"


CLOCK = "  wire clock = clk;\n  wire locked = 1'b1;\n"
PLL = ("  wire clock;\n  wire locked;\n  pll u_pll (.clock_in(clk), .clock_out(clock),"
       " .locked(locked));\n")

# Block memories of iCE40 read as 0 until some microseconds after the start.
MOTION = """  reg [7:0] start = 8'd0;
  reg [1:0] locked_q = 2'd0;
  always @(posedge clock) begin
    locked_q <= {{locked_q[0], locked}};
    if (!locked_q[1]) start <= 8'd0;
    else if (!start[7]) start <= start + 8'd1;
  end
  wire [7:0] in, out;
  wire in_valid, out_valid, out_ready;
  uart_line #(.BitClocks({bit_clocks})) u_line (
    .clk_i(clock), .rst_ni(start[7]), .rx_i(uart_rx), .tx_o(uart_tx),
    .byte_valid_o(in_valid), .byte_o(in),
    .byte_valid_i(out_valid), .byte_ready_o(out_ready), .byte_i(out)
  );
  motion_board #({values}) u_board (
    .clk_i(clock), .rst_ni(start[7]),
    .byte_valid_i(in_valid), .byte_ready_o(), .byte_i(in),
    .byte_valid_o(out_valid), .byte_ready_i(out_ready), .byte_o(out),
    .estop_i(estop), .limit_i(limit), .probe_i({probe}), .home_i({home}),
    .encoder_a_i({encoder_a}), .encoder_b_i({encoder_b}),
    .step_o(step), .direction_o(direction), .enable_o(enable),
    .output_o({outputs}), .pwm_o({pwm})
  );
"""

PINS = """  reg [7:0] count = 8'd0;
  always @(posedge clock) count <= count + 8'd1;
  assign uart_tx = uart_rx;
  assign step = limit & {home};
  assign direction = limit ^ {encoder_a} ^ {encoder_b};
  assign enable = estop ^ count[7] ^ {probe};
"""
OUTPUTS = "  wire [7:0] switched;\n  assign outputs = switched[{last}:0];\n"


def top(board, settings, pins_alone=False):
    """Verilog of module top, with these parameters of motion_board; with `pins_alone` a design that
    uses every pin, and no motion."""
    axes = f"[{board.axes - 1}:0]"
    none = f"{board.axes}'d0"
    inputs = {"probe": "1'b0", "home": "limit", "encoder_a": none, "encoder_b": none}
    inputs |= {name: name for name in inputs if name in board.pins}
    more = "".join(f", input {'' if name == 'probe' else axes + ' '}{name}" for name in inputs
                   if name in board.pins)
    last = len(board.pins.get("outputs", "")) - 1
    switched = f", output [{last}:0] outputs" if "outputs" in board.pins else ""
    switched += ", output pwm" if "pwm" in board.pins else ""
    wires = {"outputs": "switched" if "outputs" in board.pins else "",
             "pwm": "pwm" if "pwm" in board.pins else ""}
    body = OUTPUTS.format(last=last) if "outputs" in board.pins else ""
    if pins_alone:
        body += "  assign switched = count;\n" if "outputs" in board.pins else ""
        body += "  assign pwm = count[0];\n" if "pwm" in board.pins else ""
    values = ", ".join(f".{name}({value})" for name, value in settings.items())
    return (f"module top (\n  input clk, input uart_rx, input estop, input {axes} limit{more},\n"
            f"  output uart_tx, output {axes} step, output {axes} direction, output enable"
            f"{switched}\n);\n"
            + (CLOCK if board.clock_hz == board.oscillator_hz else PLL)
            + (PINS.format(**inputs) + body if pins_alone else body +
               MOTION.format(values=values, bit_clocks=board.bit_clocks, **inputs, **wires))
            + "endmodule\n")
