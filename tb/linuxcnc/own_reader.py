#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Our own reader against LinuxCNC's interpreter: the programs that its package ships, and ours.

    own_reader.py --moves-of moves_of [-o FILE.json] [FILE.ngc ...]    all, or some

A program that LinuxCNC reads is the path of LinuxCNC's own Python modules by ours, or refused where
it asks for cutter compensation, cycles of turning, or polar places that repeat. What LinuxCNC
refuses ours may read: it takes other dialects.
Exit status 77: the package is not installed.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import shipped_programs as shipped

DATA = shipped.HERE.parent / "data"
TOOLS = 1000
LEFT = ("cutter compensation", "turning cycles", "do not repeat")  # messages of what may stay
TOLERANCE = {"LE": "-0.0000001 LE", "GE": "+0.0000001 GE"}  # within the 1e-6 of LinuxCNC's source
COMPENSATES = re.compile(r"(?i)(?<![a-z])G0*4[12](?!\d)")
SPLINE = 2e-3  # mm: LinuxCNC's module draws splines by 60 chords


def machine(folder):
    """machine.ini with every tool, each of length 0, as ours has them without a table."""
    tools = "".join(f"T{n} P{n} Z0 D0\n" for n in range(1, TOOLS))
    (folder / "tools.tbl").write_text(tools)
    (folder / "parameters.var").write_text("5161 0\n5181 0\n")
    file = folder / "machine.ini"
    file.write_text(shipped.MACHINE.read_text())
    return file


def for_package(file, folder):
    """The program as the package's module reads it rightly. It is older than the tolerance of LE
    and GE, which decides where a sum of steps misses its end by rounding; and M6 behind an arc
    brings it back to where the arc began. The tools have no length, so M6 changes nothing."""
    text = file.read_text(errors="surrogateescape")
    right = re.sub(r"(?i)(?<![a-z])[LG]E(?![a-z])", lambda m: TOLERANCE[m[0].upper()], text)
    if COMPENSATES.search(text):
        right = re.sub(r"(?i)(?<![a-z])M0*6(?!\d)", "", right)
    if right == text:
        return file
    copy = folder / file.name
    copy.write_text(right, errors="surrogateescape")
    return copy


def path_of(file):
    """Returns the moving vertices, the path length at each, and the tolerance of each."""
    table = np.fromfile(file).reshape(-1, 10)
    length = shipped.travel(np.diff(table[:, :9], axis=0))
    table = table[np.concatenate(([True], length > 1e-9))]
    reached = np.concatenate(([0], np.cumsum(length[length > 1e-9])))
    return table[:, :9], reached, table[1:, 9]


def distance(a, b):
    """Distance of two paths, mm, at their vertices and ends."""
    if len(a[0]) < 2 or len(b[0]) < 2:
        return 0.0 if len(a[0]) == len(b[0]) else float("inf")
    room = max(a[2].max(), b[2].max())
    if abs(a[1][-1] - b[1][-1]) > 1e-3 * b[1][-1] + 1e-4:
        return float("inf")
    worst = 0.0
    for one, other in ((a, b), (b, a)):
        s = one[1] * (other[1][-1] / one[1][-1])
        worst = max(worst, shipped.off(s, one[0], other[0], other[1],
                                       np.maximum(other[2], room)).max())
    return float(max(worst, np.linalg.norm(a[0][-1] - b[0][-1])))


def run(moves_of, file):
    """A row of the result."""
    with tempfile.TemporaryDirectory() as text:
        folder = Path(text)
        message = shipped.expected(for_package(file, folder), folder, machine(folder))
        done = subprocess.run([moves_of, file, folder / "ours"], capture_output=True, text=True)
        row = {"name": file.name, "linuxcnc": message, "ours": done.stderr.strip()}
        if done.returncode not in (0, 2):
            return {**row, "ends": "broken", "held": False}
        if message:
            return {**row, "ends": "refused" if done.returncode else "read by ours alone",
                    "held": True}
        if done.returncode and shipped.NO_MOVES in row["ours"]:
            return {**row, "ends": "no moves", "held": np.fromfile(folder / "path").size == 10}
        if done.returncode:
            return {**row, "ends": "left to LinuxCNC",
                    "held": any(part in row["ours"] for part in LEFT)}
        off = distance(path_of(folder / "ours"), path_of(folder / "path"))
        spline = re.search(r"(?i)G\s*0*5(\.[123])?\b", file.read_text(errors="replace"))
        return {**row, "ends": "the same path", "off_mm": off,
                "held": off <= (SPLINE if spline else shipped.ERROR)}


def programs():
    """Programs of the package, of the posts and of the bug reports."""
    files = list(shipped.PROGRAMS.glob("*.ngc"))
    for folder in ("posts", "cases"):
        files += [file for file in (DATA / folder).iterdir() if file.suffix not in (".csv", ".md")]
    return sorted(files)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--moves-of", required=True)
    parser.add_argument("-o", "--output")
    parser.add_argument("files", nargs="*")
    given = parser.parse_args()
    if not shipped.PROGRAMS.exists():
        print("skipped: linuxcnc-uspace is not installed")
        return 77
    rows = []
    for file in [Path(name) for name in given.files] or programs():
        rows.append(run(os.path.abspath(given.moves_of), file.resolve()))
        print(rows[-1], flush=True)
    kinds = [row["ends"] for row in rows]
    print(f"{len(rows)} programs:", ", ".join(f"{kinds.count(kind)} {kind}"
                                              for kind in sorted(set(kinds))))
    print(f"{sum(not row['held'] for row in rows)} differ from LinuxCNC's own reading")
    if given.output:
        Path(given.output).write_text(json.dumps({"rows": rows}, indent=2) + "\n")
    return int(not all(row["held"] for row in rows))


if __name__ == "__main__":
    sys.exit(main())
