#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The programs that LinuxCNC's package ships, through the kernel: every sample against the path of
LinuxCNC's own Python modules.

    shipped_programs.py --program curvecore [-o FILE.json] [NAME | FILE.ngc ...]    all, or some

Exit status 77: the package is not installed.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

PROGRAMS = Path("/usr/share/linuxcnc/ncfiles")
HERE = Path(__file__).resolve().parent
CALLBACKS = HERE.parent.parent / "sysc/linuxcnc/callbacks.py"
MACHINE = HERE / "machine.ini"
PERIOD = "1ms"
ROWS = 2000000  # of samples; of more every n-th is looked at
AT_LEAST = 40  # of all programs run to their end
ERROR = 2e-5  # mm: rounding to 1 nm, and callbacks.py's chords
LONGER = 2e-5  # than the path of chords, at most
AXES = "xyzabcuvw"
NO_MOVES = "the program has no moves"


def travel(step):
    """Path length of steps of nine axes: of X Y Z, else of U V W, else of A B C; longer where an
    auxiliary axis goes more than 1.9 times as far."""
    xyz, abc, uvw = (np.linalg.norm(step[:, i:i + 3], axis=1) for i in (0, 3, 6))
    length = np.where(xyz > 1e-9, xyz, np.where(uvw > 1e-9, uvw, abc))
    return np.maximum(length, np.abs(step[:, 3:]).max(axis=1) / 1.9)


def read_samples(file):
    """Path length in mm, and positions on nine axes."""
    with open(file) as lines:
        for text in lines:
            if not text.startswith("#"):
                names = text.strip().split(",")
                break
        table = np.loadtxt(lines, delimiter=",", ndmin=2, comments=None)
    places = np.zeros((len(table), 9))
    for i, name in enumerate(AXES):
        if name in names:
            places[:, i] = table[:, names.index(name)] * 1e-6
    return table[:, names.index("s")] / 65536 * 1e-6, places


def off(s, places, vertices, reached, room):
    """Distance of every place from the chords near its path length, beyond their tolerance."""
    worst = np.full(len(s), np.inf)
    near = np.searchsorted(reached, s)
    for shift in range(-8, 9):
        i = np.clip(near + shift, 1, len(vertices) - 1)
        a, b = vertices[i - 1], vertices[i]
        way = b - a
        along = np.einsum("ij,ij->i", places - a, way) / np.maximum(
            np.einsum("ij,ij->i", way, way), 1e-30)
        gap = places - a - np.clip(along, 0, 1)[:, None] * way
        gap[:, 3:6] = (gap[:, 3:6] + 180) % 360 - 180  # words leave whole turns out
        worst = np.minimum(worst, np.linalg.norm(gap, axis=1) - room[i - 1])
    return worst


def compare(path, samples):
    """Returns the distance of the samples from the path, mm, and their number."""
    table = np.fromfile(path).reshape(-1, 10)
    length = travel(np.diff(table[:, :9], axis=0))
    stay = np.concatenate(([True], length > 1e-9))
    table = table[stay]
    vertices = table[:, :9]
    length = length[length > 1e-9]
    reached = np.concatenate(([0], np.cumsum(length)))
    s, places = read_samples(samples)
    found = off(s, places, vertices, reached, table[1:, 9])
    end = np.linalg.norm(places[-1, :3] - vertices[-1, :3])
    if abs(s[-1] / reached[-1] - 1) > LONGER:
        return float("inf"), len(s)
    return float(max(found.max(), end)), len(s)


def expected(file, folder, ini=MACHINE):
    """LinuxCNC's own reading: empty, or "LINE: its message"."""
    (folder / "scratch").mkdir()
    done = subprocess.run([CALLBACKS, file, "--scratch", folder / "scratch", "--ini", ini,
                           "--path", folder / "path"], capture_output=True, text=True)
    return done.stderr.strip().split("\n")[-1] if done.returncode else ""


def run(program, file):
    """A row of the result."""
    with tempfile.TemporaryDirectory() as text:
        folder = Path(text)
        message = expected(file, folder)
        done = subprocess.run(
            [program, "run", file, "--interpreter", "linuxcnc", "--machine", MACHINE, "--path",
             "exact", "--on", "kernel", "--sample-period", PERIOD, "--rows", str(ROWS), "-q", "-o",
             folder / "out"], capture_output=True, text=True)
        row = {"name": file.stem, "message": done.stderr.strip().split("\n")[-1]}
        if message:
            line, reason = message.split(": ", 1)
            held = done.returncode == 2 and row["message"] == f"{file}:{line}: error: {reason}"
            return {**row, "ends": "refused", "held": held}
        if done.returncode == 2:
            moves = np.fromfile(folder / "path").size > 10
            return {**row, "ends": "no moves", "held": not moves and NO_MOVES in row["message"]}
        worst, samples = compare(folder / "path", folder / "out/samples.csv")
        return {**row, "ends": "drawn", "samples": samples, "off_mm": worst,
                "held": done.returncode == 0 and worst <= ERROR}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("-o", "--output")
    parser.add_argument("names", nargs="*")
    given = parser.parse_args()
    if not PROGRAMS.exists():
        print("skipped: linuxcnc-uspace is not installed")
        return 77
    rows = []
    for name in given.names or sorted(file.stem for file in PROGRAMS.glob("*.ngc")):
        file = Path(name) if name.endswith(".ngc") else PROGRAMS / f"{name}.ngc"
        rows.append(run(os.path.abspath(given.program), file))
        print(rows[-1], flush=True)
    ended = sum(row["ends"] != "refused" for row in rows)
    drawn = sum(row["ends"] == "drawn" for row in rows)
    print(f"{len(rows)} programs: {ended} run to the end, {drawn} of them move; "
          f"{sum(not row['held'] for row in rows)} differ from LinuxCNC's own reading")
    if given.output:
        Path(given.output).write_text(json.dumps({"rows": rows}, indent=2) + "\n")
    return int(not all(row["held"] for row in rows) or (not given.names and ended < AT_LEAST))


if __name__ == "__main__":
    sys.exit(main())
