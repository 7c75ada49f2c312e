#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Speed of the system in SystemC and of the virtual board, relative to real time: a part of some
seconds with each choice of blocks.  Prints rows and writes build/figures/system_rates.json."""

import json
import pathlib
import re
import signal
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build/curvecore"
PART = ROOT / "tb/data/splines.ngc"
CORE = ["--set", "Splines=1", "--set", "Mode=1", "--clock", "2.56MHz", "-q"]
BLOCKS = {
    "kernel, steps by kernel": "interpolator=kernel,steps=kernel",
    "kernel, Verilated step generator": "interpolator=kernel,steps=rtl",
    "kernel, step generator by its pins": "interpolator=kernel,steps=pins",
    "Verilated core, steps by kernel": "interpolator=rtl,steps=kernel",
    "both Verilated": "interpolator=rtl,steps=rtl",
}


def seconds(*arguments):
    start = time.monotonic()
    subprocess.run([PROGRAM, *arguments], check=True)
    return time.monotonic() - start


def system(folder):
    """Yields the speed of each choice of blocks, without the planning that each run does too."""
    planning = seconds("plan", PART, "-o", folder, *CORE)
    for name, blocks in BLOCKS.items():
        taken = seconds("run", PART, "--on", "systemc", "--system", blocks, "-o", folder, *CORE)
        report = json.loads((pathlib.Path(folder) / "report.json").read_text())
        yield f"SystemC: {name}", report["duration_s"] / (taken - planning)


def virtual_board(folder):
    """Share of its nominal clock that it keeps."""
    board = subprocess.Popen([PROGRAM, "board", "--listen", "127.0.0.1:0"],
                             stdout=subprocess.PIPE, text=True)
    try:
        said = board.stdout.readline()
        port, clock = re.search(r":(\d+):.* clock (\S+ MHz)", said).groups()
        subprocess.run([PROGRAM, "stream", PART, "--to", f"udp:127.0.0.1:{port}", "-q", "-o",
                        folder], check=True)
        board.send_signal(signal.SIGINT)
        held = re.search(r"held ([\d.]+) %", board.communicate(timeout=20)[0])[1]
    finally:
        board.kill()
    yield f"`curvecore board`, every pin of every clock of {clock}, at most 1", float(held) / 100


def main():
    with tempfile.TemporaryDirectory() as folder:
        rows = [*system(folder), *virtual_board(folder)]
    for what, rate in rows:
        print(f"{what}: {rate:.3g}")
    figures = ROOT / "build/figures"
    figures.mkdir(parents=True, exist_ok=True)
    (figures / "system_rates.json").write_text(json.dumps(
        {"rows": [{"what": what, "measured": f"{rate:.3g}"} for what, rate in rows]}, indent=1))


if __name__ == "__main__":
    main()
