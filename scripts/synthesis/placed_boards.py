# SPDX-License-Identifier: Apache-2.0
"""Figures of the boards of scripts/boards as placed: the one file of them.

    board, part, family, device    as in the board's table
    parameters                     all of rtl/motion_board.sv
    clock_mhz, fmax_mhz            asked, reached
    lut4, ff, dsp, bram            used
    axes, samples_s, steps_s       figures for drives and hosts
    tree                           the last commit that changed rtl before it was placed, if known
"""

import json
import shutil
import subprocess

from synthesis.boards import TOP
from synthesis.cores import ROOT, parameters
from synthesis.tools import write_whole

FILE = ROOT / "sysc" / "cost" / "placed_boards.json"
FIGURES = ("clock_mhz", "fmax_mhz", "lut4", "ff", "dsp", "bram", "axes", "samples_s", "steps_s")


def tree():
    if not (shutil.which("git") and (ROOT / ".git").exists()):
        return "unknown"
    sources = ["rtl", ":(exclude)*.md"]
    return subprocess.run(["git", "-C", ROOT, "log", "-1", "--format=%h", "--", *sources],
                          check=True, text=True, capture_output=True).stdout.strip()


def record(board, facts, file):
    """Replaces its row, and keeps the others."""
    row = {"board": board.name, "part": board.part, "family": board.family,
           "device": board.device,
           "parameters": {name: int(value) for name, value in
                          (parameters(TOP) | board.settings).items()},
           **{name: facts[name] for name in FIGURES}, "tree": tree()}
    others = json.loads(file.read_text()) if file.exists() else []
    rows = [other for other in others if other["board"] != board.name] + [row]
    rows.sort(key=lambda row: row["board"])
    write_whole(file, json.dumps(rows, indent=2) + "\n")
