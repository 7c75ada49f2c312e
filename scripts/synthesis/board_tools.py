# SPDX-License-Identifier: Apache-2.0
"""Commands by which the tools of a family make a bitstream of a board."""

import dataclasses

from synthesis.board_files import cst, lpf, pcf
from synthesis.devices import ECP5, GOWIN, HERE, UP5K, Family
from synthesis.refused import Refused


@dataclasses.dataclass(frozen=True)
class BoardTools:
    """Commands have {part}, and {..} for values in the board's `device`.

    Boards are slow and full: without multiplexers behind LUTs a design needs fewer of these."""

    family: Family
    synthesis: str  # of Yosys
    constraints: callable  # text of a board
    constraints_file: str
    flags: tuple  # of nextpnr
    pack: tuple
    bitstream: str
    pll: tuple  # writes pll.v, with {clkin} and {clkout} in MHz


# nextpnr puts a flip-flop beside the LUT that it registers, but not beside an adder's cell, and
# every adder has two cells more at its ends: sums of few bits are smaller in LUTs.
NARROW = 16  # bits
GOWIN_BOARD = dataclasses.replace(GOWIN, files=(HERE / "gowin_carries.v",))

TOOLS = {
    "ecp5": BoardTools(
        ECP5, "synth_ecp5 -nowidelut -top top", lpf, "board.lpf",
        ("--{size}", "--package", "{package}", "--speed", "{speed}", "--lpf", "board.lpf",
         "--textcfg", "board.config"),
        ("ecppack", "board.config", "board.bit"), "board.bit",
        ("ecppll", "-n", "pll", "-i", "{clkin}", "-o", "{clkout}", "--clkin_name", "clock_in",
         "--clkout0_name", "clock_out", "-f", "pll.v")),
    "ice40": BoardTools(
        UP5K, "synth_ice40 -top top", pcf, "board.pcf",
        ("--{size}", "--package", "{package}", "--pcf", "board.pcf", "--asc", "board.asc"),
        ("icepack", "board.asc", "board.bin"), "board.bin",
        ("icepll", "-p", "-i", "{clkin}", "-o", "{clkout}", "-m", "-n", "pll", "-f", "pll.v")),
    "gowin": BoardTools(
        GOWIN_BOARD, "synth_gowin -family {yosys} -nowidelut -top top -run begin:map_gates;"
        f" select -set narrow t:$alu r:Y_WIDTH<={NARROW} %i;"
        " techmap -map gowin_carries.v -map +/techmap.v @narrow; opt -fast;"
        " synth_gowin -family {yosys} -nowidelut -top top -run map_gates:", cst, "board.cst",
        ("--device", "{part}", "--vopt", "family={die}", "--vopt", "cst=board.cst",
         "--write", "placed.json"),
        ("gowin_pack", "-d", "{die}", "-o", "board.fs", "placed.json"), "board.fs",
        ("gowin_pll", "-d", "{part}", "-i", "{clkin}", "-o", "{clkout}", "-f", "pll.v")),
}


def tools_of(board):
    """Raises Refused if the tools cannot make this board."""
    if board.family not in TOOLS:
        raise Refused(f"unknown family '{board.family}': one of {', '.join(TOOLS)}")
    tools = TOOLS[board.family]
    try:
        command((tools.synthesis, *tools.flags, *tools.pack), board)
    except KeyError as error:
        raise Refused(f"device: there is no {error}") from None
    return tools


def command(words, board):
    mhz = {"clkin": f"{board.oscillator_hz / 1e6:g}", "clkout": f"{board.clock_hz / 1e6:g}"}
    return [word.format(part=board.part, **board.device, **mhz) for word in words]
