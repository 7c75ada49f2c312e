# SPDX-License-Identifier: Apache-2.0
"""A bitstream of a board: netlist, placement that keeps the clock, packed."""

import json
import re
import shutil

from synthesis import microcode, placement
from synthesis.board_files import top
from synthesis.board_tools import command, tools_of
from synthesis.boards import TOP
from synthesis.cores import sources
from synthesis.devices import counts
from synthesis.netlist import Yosys
from synthesis.refused import Refused, TooLarge
from synthesis.tools import alone, error_of, run, tool, version, work_folder, write_whole

# nextpnr's count after packing: used and available.
USED = re.compile(r"^Info:\s+(\w+):\s+(\d+)/\s*(\d+)\s+\d+%", re.M)

# What icepll and gowin_pll say in their modules; of ecppll's nextpnr tells it.
ACHIEVED = re.compile(r"Achieved output frequency: *([\d.]+) MHz")

# Another seed may find one: a matter of chance where a device is nearly full.
NO_LEGAL_PLACE = "Unable to find legal placement"
NEARLY = 0.9  # share above which placement or routing may fail
FEW = 8  # such as the one of GND


def explain_fit(board, log, error):
    """Raises the cause of nextpnr's error, or of its silence."""
    used = [(f"{used} {cell} of {there}", int(used) / int(there))
            for cell, used, there in USED.findall(log) if int(there) > FEW]
    over = [text for text, share in used if share > 1]
    nearly = [text for text, share in used if share > NEARLY]
    if over:
        raise TooLarge(f"does not fit {board.part}: {', '.join(over)}") from None
    if nearly:
        raise Refused(f"{error}; nearly full: {', '.join(nearly)}") from None
    raise error


def make(board, folder, seeds, minutes, pins_alone=False):
    """Writes the bitstream and its sources into `folder`; returns its description."""
    tools = tools_of(board)
    folder.mkdir(parents=True, exist_ok=True)
    with alone(folder / ".lock"), work_folder(folder / ".work") as work:
        for file in ("board.json", tools.bitstream):
            (folder / file).unlink(missing_ok=True)
        settings = board.settings
        if not pins_alone:
            settings = microcode.make(TOP, settings, work, folder / "microcode.log")
        (work / "top.v").write_text(top(board, settings, pins_alone))
        (work / tools.constraints_file).write_text(tools.constraints(board))
        cells = synthesise(board, tools, work, folder, pins_alone)
        placed = place(board, tools, work, folder, seeds, minutes)
        pack = command(tools.pack, board)
        run([tool(pack[0]), *pack[1:]], folder / "pack.log", error_of, cwd=work)
        programs = microcode.FILES.values() if settings != board.settings else ()
        for file in ("top.v", tools.constraints_file, tools.bitstream, *programs):
            shutil.copy(work / file, folder)
    facts = {"board": board.name, "title": board.board, "part": board.part, **board.figures(),
             **placed, **counts(tools.family, cells),
             "bitstream": tools.bitstream, "parameters": board.settings,
             "tools": [version(tool("yosys")), version(tool(tools.family.nextpnr))]}
    write_whole(folder / "board.json", json.dumps(facts, indent=2) + "\n")
    return facts


def synthesise(board, tools, work, folder, pins_alone):
    """Writes netlist.json; returns the number of cells by type."""
    read = ["read_verilog top.v"]
    if board.clock_hz != board.oscillator_hz:
        pll = command(tools.pll, board)
        run([tool(pll[0]), *pll[1:]], folder / "pll.log", error_of, cwd=work)
        check_clock(board, map(float, ACHIEVED.findall((work / "pll.v").read_text())))
        read.append("read_verilog pll.v")
    yosys = Yosys([] if pins_alone else sources("uart_line", TOP), tools.family, work)
    commands = command([f"{tools.synthesis} -json netlist.json"], board)
    yosys(folder / "synthesise.log", *read, *commands, "tee -o stat.json stat -json")
    return json.loads((work / "stat.json").read_text())["design"]["num_cells_by_type"]


def place(board, tools, work, folder, seeds, minutes):
    """Places with the first seed that succeeds and keeps the board's clock."""
    nextpnr = tool(tools.family.nextpnr)
    wanted = board.clock_hz / 1e6
    reached = {}
    for seed in range(1, seeds + 1):
        log = folder / "place.log"
        try:
            run([nextpnr, "--json", "netlist.json", *command(tools.flags, board), "--freq",
                 f"{wanted:g}", "--timing-allow-fail", "--seed", str(seed), "--report",
                 "report.json"], log, placement.explain, minutes=minutes, cwd=work)
        except Refused as error:
            text = log.read_text(errors="replace")
            if NO_LEGAL_PLACE in text and seed < seeds:
                continue
            explain_fit(board, text, error)
        report = json.loads((work / "report.json").read_text())
        check_clock(board, {clock["constraint"] for clock in report["fmax"].values()})
        reached[seed] = placement.frequency(tools.family, report, log)
        if reached[seed] >= wanted:
            return {"fmax_mhz": round(reached[seed], 1), "seed": seed}
    raise Refused(f"{max(reached.values()):g} MHz is less than its clock of"
                  f" {wanted:g} MHz (best of {seeds})")


def check_clock(board, clocks):
    """Checks the clock: a PLL that cannot make it makes another one. No clock tells nothing."""
    told = list(clocks)
    if board.clock_hz != board.oscillator_hz and told and not any(
            abs(mhz * 1e6 / board.clock_hz - 1) < 1e-3 for mhz in told):
        raise Refused(f"the PLL gives {', '.join(f'{mhz:g}' for mhz in told)} MHz"
                      f" instead of {board.clock_hz / 1e6:g}")
