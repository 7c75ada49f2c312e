# SPDX-License-Identifier: Apache-2.0
"""Projects of the vendors' own tools, Vivado and Quartus, by Edalize: a table like a board's, in
scripts/vendor_boards.  They are set up and not run here, where these tools are not: whether a clock
is kept and a pin is there, the tools say."""

import dataclasses
import logging
import shutil

from synthesis import microcode
from synthesis.board_files import top
from synthesis.boards import TOP, board_of
from synthesis.cores import ROOT
from synthesis.refused import Refused
from synthesis.tools import alone, work_folder, write_whole

FOLDER = ROOT / "scripts" / "vendor_boards"
PROGRAMS = {"Program": "program.mem", "Data": "data.mem"}  # names that Vivado takes for memories

# Artix-7's PLL runs at 800 MHz to 1.6 GHz; its outputs are that over a whole number.
PLL_HZ = 800_000_000
XC7_PLL = """module pll (
  input clock_in,
  output clock_out,
  output locked
);
  wire feedback, made;
  PLLE2_BASE #(
    .CLKIN1_PERIOD({period:.3f}), .CLKFBOUT_MULT({times}), .CLKOUT0_DIVIDE({divide})
  ) u_pll (
    .CLKIN1(clock_in), .CLKFBIN(feedback), .CLKFBOUT(feedback), .CLKOUT0(made), .LOCKED(locked),
    .RST(1'b0), .PWRDWN(1'b0)
  );
  BUFG u_buffer (.I(made), .O(clock_out));
endmodule
"""


def xdc(board):
    lines = [f"create_clock -name clk -period {1e9 / board.oscillator_hz:.3f} [get_ports clk]",
             "set_property CFGBVS VCCO [current_design]",
             "set_property CONFIG_VOLTAGE 3.3 [current_design]"]
    for port, pin, pulled_up in board.ports():
        pull = " PULLUP TRUE" if pulled_up else ""
        lines.append(f"set_property -dict {{PACKAGE_PIN {pin} IOSTANDARD LVCMOS33{pull}}}"
                     f" [get_ports {{{port}}}]")
    return {"board.xdc": ("\n".join(lines) + "\n", "xdc")}


def qsf(board):
    lines = []
    for port, pin, pulled_up in board.ports():
        lines += [f'set_location_assignment PIN_{pin} -to "{port}"',
                  f'set_instance_assignment -name IO_STANDARD "3.3-V LVTTL" -to "{port}"']
        if pulled_up:
            lines.append(f'set_instance_assignment -name WEAK_PULL_UP_RESISTOR ON -to "{port}"')
    clock = f"create_clock -name clk -period {1e9 / board.oscillator_hz:.3f} [get_ports clk]\n"
    return {"board.tcl": ("\n".join(lines) + "\n", "tclSource"), "board.sdc": (clock, "SDC")}


def xc7_pll(board):
    times, over = divmod(PLL_HZ, board.oscillator_hz)
    divide, rest = divmod(PLL_HZ, board.clock_hz)
    if over or rest or not 2 <= times <= 64 or not 1 <= divide <= 128:
        raise Refused(f"the PLL does not make {board.clock_hz} Hz of {board.oscillator_hz}: both"
                      f" must divide {PLL_HZ} Hz")
    return XC7_PLL.format(period=1e9 / board.oscillator_hz, times=times, divide=divide)


def vivado(edam, folder, part):
    from edalize.flows.vivado import Vivado  # by .venv alone
    Vivado(edam | {"flow_options": {"part": part}}, str(folder)).configure()


def quartus(edam, folder, part):
    from edalize.quartus import Quartus
    options = {"quartus": {"family": "Cyclone V", "device": part}}
    Quartus(edam | {"tool_options": options}, str(folder)).configure()


@dataclasses.dataclass(frozen=True)
class Vendor:
    tool: str
    constraints: callable  # of a board: texts and Edalize's types of files
    set_up: callable
    pll: callable = None  # text of a board; none: the clock is the oscillator


VENDORS = {"xc7": Vendor("Vivado", xdc, vivado, xc7_pll),
           "cyclonev": Vendor("Quartus", qsf, quartus)}


def names():
    return sorted(path.stem for path in FOLDER.glob("*.json"))


def vendor_of(board):
    """Raises Refused if no vendor's tool makes this board."""
    if board.family not in VENDORS:
        raise Refused(f"unknown family '{board.family}': one of {', '.join(VENDORS)}")
    vendor = VENDORS[board.family]
    if board.clock_hz != board.oscillator_hz:
        if not vendor.pll:
            raise Refused(f"clock_hz must be {board.oscillator_hz}, the oscillator's: there is no"
                          f" PLL for {board.family} here")
        vendor.pll(board)
    return vendor


def board_named(name, given):
    """Returns the board of this name, or of a file, with the parameters `given` instead of its own.
    Raises Refused."""
    return board_of(name, FOLDER, given, vendor_of)


def make(board, folder):
    """Writes the project with copies of all of its files into `folder`; returns the tool's name."""
    vendor = vendor_of(board)
    folder.mkdir(parents=True, exist_ok=True)
    with alone(folder / ".lock"), work_folder(folder / ".work") as work:
        files = write_files(board, vendor, work, folder)
        logging.getLogger("edalize").setLevel(logging.ERROR)  # that the tool is not here
        vendor.set_up({"name": board.name, "toplevel": "top", "version": "0.2.1", "files": files},
                      work, board.part)
        for old in folder.iterdir():
            if old.name not in (".lock", ".work", "microcode.log"):
                shutil.rmtree(old) if old.is_dir() else old.unlink()
        for new in sorted(work.iterdir()):
            new.rename(folder / new.name)
    return vendor.tool


def write_files(board, vendor, work, folder):
    """Writes sources, programs and constraints; returns them as Edalize has them."""
    settings = microcode.make(TOP, board.settings, work, folder / "microcode.log")
    files = []
    for name, file in microcode.FILES.items():
        if (work / file).exists():
            (work / file).rename(work / PROGRAMS[name])
            settings[name] = f'"{PROGRAMS[name]}"'
            files.append((PROGRAMS[name], "mem" if vendor.tool == "Vivado" else "user"))
    for name in (ROOT / "rtl/curvecore.f").read_text().split():
        (work / "rtl" / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / "rtl" / name, work / "rtl" / name)
        files.append((f"rtl/{name}", "systemVerilogSource"))
    made = {"top.v": (top(board, settings), "verilogSource"), **vendor.constraints(board)}
    if board.clock_hz != board.oscillator_hz:
        made["pll.v"] = (vendor.pll(board), "verilogSource")
    for name, (text, kind) in made.items():
        write_whole(work / name, text)
        files.append((name, kind))
    return [{"name": name, "file_type": kind} for name, kind in files]
