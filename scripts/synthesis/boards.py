# SPDX-License-Identifier: Apache-2.0
"""Boards: a file each, scripts/boards/NAME.json:

    part, family, device    as the family's tools want them (synthesis/board_tools.py)
    oscillator_hz           at the pin clk; clock_hz: of the design, by a PLL where it is another
    baud                    of the UART
    parameters              of rtl/motion_board.sv; the other ones follow or have their defaults
    pins                    names of balls or pins; of step, direction and limit one for each axis;
                            and where there are any probe, home, encoder_a, encoder_b; outputs (one
                            to eight) and pwm, which the parameter Outputs uses, or nothing does
    loader                  where openFPGALoader knows the board, its name there
    board, where            for people
"""

import dataclasses
from pathlib import Path

from synthesis.board_tools import tools_of
from synthesis.cores import ROOT, check_parameters, parameters
from synthesis.json_file import check_keys, read_json
from synthesis.refused import Refused

FOLDER = ROOT / "scripts" / "boards"
TOP = "motion_board"
PINS = ("clk", "uart_rx", "uart_tx", "step", "direction", "enable", "estop", "limit")
INPUTS = ("probe", "home", "encoder_a", "encoder_b")
OUTPUTS = ("outputs", "pwm")
OPTIONAL = (*INPUTS, *OUTPUTS)
PULLED_UP = ("uart_rx", "estop", "limit", *INPUTS)
OF_AXES = ("step", "direction", "limit", "home", "encoder_a", "encoder_b")
BAUD_ERROR = 0.02  # a byte of ten bits is sampled in their middle: half a bit off in 9.5 is 5 %
LEAST_BIT_CLOCKS = 8


@dataclasses.dataclass(frozen=True)
class Board:
    name: str
    board: str
    part: str
    family: str
    device: dict
    oscillator_hz: int
    clock_hz: int
    baud: int
    parameters: dict
    pins: dict
    where: str
    loader: str = ""

    @property
    def axes(self):
        return 3 + int(self.parameters.get("AuxAxes", "0"))

    @property
    def bit_clocks(self):
        return round(self.clock_hz / self.baud)

    @property
    def settings(self):
        """Returns all parameters that the top gives to motion_board."""
        return self.parameters | {"ClockHertz": str(self.clock_hz)}

    def ports(self):
        """Returns (port, pin, has a pull-up) of every bit."""
        for name in PINS + OPTIONAL:
            if name not in self.pins:
                continue
            if name in OF_AXES or name == "outputs":
                yield from ((f"{name}[{axis}]", pin, name in PULLED_UP)
                            for axis, pin in enumerate(self.pins[name]))
            else:
                yield name, self.pins[name], name in PULLED_UP

    def figures(self):
        """Returns the board's figures for drives and hosts."""
        period_log2 = int((parameters(TOP) | self.settings)["PeriodLog2"])
        return {"clock_mhz": self.clock_hz / 1e6, "axes": self.axes,
                "samples_s": round(self.clock_hz / 2**period_log2),
                "steps_s": self.clock_hz // 2}  # rtl/pulse/step_phase.sv: up to half a step a clock


def names():
    return sorted(path.stem for path in FOLDER.glob("*.json"))


def board_named(name, given=()):
    """Returns the board of this name, or of a file, with the parameters `given` instead of its own.
    Raises Refused."""
    return board_of(name, FOLDER, given, tools_of)


def board_of(name, folder, given, check_tools):
    """Returns the board of a name in a folder of tables, or of a file, if its tools make it.
    Raises Refused."""
    known = sorted(path.stem for path in folder.glob("*.json"))
    if name not in known and not name.endswith(".json"):
        raise Refused(f"unknown board '{name}': one of {', '.join(known)}, or a file (.json)")
    file = Path(name) if name.endswith(".json") else folder / f"{name}.json"
    table = read_json(file)
    try:
        check_keys(table, [field.name for field in dataclasses.fields(Board)
                           if field.name not in ("name", "loader")], ["loader"], "a board")
        values = {name: str(value) for name, value in table["parameters"].items()} | dict(given)
        used = {name: pin for name, pin in table["pins"].items()
                if name not in OUTPUTS or values.get("Outputs", "0") != "0"}
        board = Board(**table | {"name": file.stem, "parameters": values, "pins": used})
        check_tools(board)
        check(board)
        return board
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise Refused(f"{file}: is no board: {error!r}") from None
    except Refused as error:
        raise Refused(f"{file}: {error}") from None


def check(board):
    check_parameters(TOP, board.settings)
    check_pins(board)
    values = parameters(TOP) | board.settings
    fine_bits = int(values["PositionBits"]) + int(values["GuardBits"])
    check_parameters("step_generator", {
        "Axes": str(board.axes), "FineBits": str(fine_bits),
        **{name: values[name] for name in ("ScaleBits", "PeriodLog2", "TimeBits")}})
    if board.bit_clocks < LEAST_BIT_CLOCKS:
        raise Refused(f"{board.baud} baud: a bit has {board.bit_clocks} clocks, and not"
                      f" {LEAST_BIT_CLOCKS}")
    off = board.clock_hz / board.bit_clocks / board.baud - 1
    if abs(off) > BAUD_ERROR:
        raise Refused(f"{board.baud} baud: {board.bit_clocks} clocks a bit are {off:+.1%} off")


def check_pins(board):
    if not set(PINS) <= set(board.pins) <= set(PINS + OPTIONAL):
        raise Refused(f"pins must be {', '.join(PINS)}; and may be {', '.join(OPTIONAL)}")
    given = {"encoder_a" in board.pins, "encoder_b" in board.pins,
             board.parameters.get("Encoders", "0") != "0"}
    if len(given) > 1:
        raise Refused("encoders have pins encoder_a and encoder_b, and the parameter Encoders")
    given = {"outputs" in board.pins or "pwm" in board.pins,
             board.parameters.get("Outputs", "0") != "0"}
    if len(given) > 1 or not 1 <= len(board.pins.get("outputs", "1")) <= 8:
        raise Refused("outputs have pins outputs, eight at most, or pwm, and the parameter Outputs")
    for name in OF_AXES:
        if name not in board.pins:
            continue
        if len(board.pins[name]) != board.axes:
            raise Refused(f"{name} has {len(board.pins[name])} pins for {board.axes} axes")
    used = {}
    for port, pin, _ in board.ports():
        if pin in used:
            raise Refused(f"pin {pin} is {used[pin]} and {port}")
        used[pin] = port
