#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Our own reader against LinuxCNC's interpreter: the programs that its package ships, and ours.

    own_reader.py --program curvecore [-o FILE.json] [FILE.ngc ...]    all, or some

A program that LinuxCNC reads is drawn by ours on the path of LinuxCNC's own Python modules, or
refused where it asks for cutter compensation. What LinuxCNC refuses ours may read: it takes other
dialects.
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
COMPENSATION = "cutter compensation"


def machine(folder):
    """machine.ini with every tool, those of its table as they are there."""
    table = shipped.HERE / "tools.tbl"
    lines = table.read_text().splitlines()
    known = {int(number) for line in lines for number in re.findall(r"^T(\d+)", line)}
    lines += [f"T{n} P{n} Z0 D0" for n in range(1, TOOLS) if n not in known]
    (folder / "tools.tbl").write_text("\n".join(lines) + "\n")
    text = shipped.MACHINE.read_text()
    text = text.replace("parameters.var", str(shipped.HERE / "parameters.var"))
    file = folder / "machine.ini"
    file.write_text(text)
    return file


def run(program, file):
    """A row of the result."""
    with tempfile.TemporaryDirectory() as text:
        folder = Path(text)
        ini = machine(folder)
        message = shipped.expected(file, folder, ini)
        done = subprocess.run(
            [program, "run", file, "--machine", ini, "--path", "exact", "--on", "kernel",
             "--sample-period", shipped.PERIOD, "--rows", str(shipped.ROWS), "-q", "-o",
             folder / "out"], capture_output=True, text=True)
        row = {"name": file.name, "linuxcnc": message,
               "ours": done.stderr.strip().split("\n")[-1] if done.returncode else ""}
        if done.returncode not in (0, 2):
            return {**row, "ends": "broken", "held": False}
        if message:
            return {**row, "ends": "read by ours alone" if done.returncode == 0 else "refused",
                    "held": True}
        moves = np.fromfile(folder / "path").size > 10
        if done.returncode == 2:
            if shipped.NO_MOVES in row["ours"]:
                return {**row, "ends": "no moves", "held": not moves}
            return {**row, "ends": "left to LinuxCNC", "held": COMPENSATION in row["ours"]}
        worst, samples = shipped.compare(folder / "path", folder / "out/samples.csv")
        return {**row, "ends": "drawn", "samples": samples, "off_mm": worst,
                "held": worst <= shipped.ERROR}


def programs():
    """Those of the package, of the posts and of the bug reports."""
    files = list(shipped.PROGRAMS.glob("*.ngc"))
    for folder in ("posts", "cases"):
        files += [file for file in (DATA / folder).iterdir()
                  if file.suffix not in (".csv", ".md", ".ini")]
    return sorted(files)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("-o", "--output")
    parser.add_argument("files", nargs="*")
    given = parser.parse_args()
    if not shipped.PROGRAMS.exists():
        print("skipped: linuxcnc-uspace is not installed")
        return 77
    rows = []
    for file in [Path(name) for name in given.files] or programs():
        rows.append(run(os.path.abspath(given.program), file.resolve()))
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
