#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Programs on LinuxCNC's own motion in simulation and by curvecore's plan, with the same limits.

    motion_over_linuxcnc.py --program curvecore -o FILE.json [NAME ...]

500 mm/s and 5000 mm/s^2 on every axis; curvecore at 1e5 mm/s^3, and as good as without a limit of
jerk, which LinuxCNC 2.9 has not. Of both: the time in which an axis moves, the worst acceleration
of an axis over windows of 1, 5 and 20 ms, how far path and programmed path are off each other.
Exit status 77: the package is not installed.
"""

import argparse
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from shipped_programs import CALLBACKS, HERE, PROGRAMS, read_samples

sys.path.insert(0, str(HERE.parent / "oracle"))
from programs import corners, program, sine, stadium, surface  # noqa: E402

INTERPRET = CALLBACKS.with_name("interpret.py")
SIMULATE = CALLBACKS.with_name("simulate.py")
VELOCITY, ACCELERATION = 500, 5000
JERKS = {"1e5": 1e5, "1e9": 1e9}
WINDOWS = (1, 5, 20)  # ms
PERIOD = 1e-3  # s: LinuxCNC's
FEED = 500.0  # mm/s
AHEAD = 2.0  # mm: how far a place may be ahead of where the path was followed to
SAME = 1e-4  # mm: distances that nothing tells apart

# Programs of mills, without probing, each less than 50 s
SHIPPED = ("b-index", "skeleton", "toplevel", "hole-circle", "polar",
           "gmoccapy_2_tools_with_cutter_radius_compensation", "useful-subroutines", "systems",
           "comp", "daisy", "comp-g1", "3dtest")


def exact(text):
    return re.sub(r"G64 P[0-9.]+", "G61", text)


OWN = {
    "sine, chords of 0.02 mm, P 0.005": program(sine(0.02), 0.005, FEED),
    "sine, chords of 0.1 mm, P 0.005": program(sine(0.1), 0.005, FEED),
    "sine, chords of 0.1 mm, G61": exact(program(sine(0.1), 0.005, FEED)),
    "stadium, R 10, P 0.01": stadium(0.01, FEED),
    "stadium, R 10, G61": exact(stadium(0.01, FEED)),
    "40 corners, P 0.1": program(corners(40, 10), 0.1, FEED),
    "surface, chords of 0.2 mm, P 0.01": program(surface(0.2), 0.01, FEED),
}


def machine(jerk):
    """The same limits for curvecore, as an .ini."""
    text = (HERE / "machine.ini").read_text().split("[AXIS_X]")[0]
    text = re.sub(r"MAX_LINEAR_JERK = .*", f"MAX_LINEAR_JERK = {jerk}", text)
    text = re.sub(r"= (\w+\.(?:tbl|var))", rf"= {HERE}/\1", text)
    for axis in "XYZABCUVW":
        text += (f"\n[AXIS_{axis}]\nMAX_VELOCITY = {VELOCITY}\n"
                 f"MAX_ACCELERATION = {ACCELERATION}\nMAX_JERK = {jerk}\n")
    return text


def moving(places):
    """Leaves out the places at rest."""
    moves = np.abs(np.diff(places, axis=0)).max(axis=1) > 0
    return places[np.concatenate(([True], moves))]


def accelerations(places):
    """Worst acceleration of an axis over windows, relative to the limit."""
    worst = []
    for window in WINDOWS:
        before, at, after = places[:-2 * window], places[window:-window], places[2 * window:]
        change = (np.abs(after - 2 * at + before) / (window * PERIOD) ** 2).max() if len(at) else 0
        worst.append(float(change / ACCELERATION))
    return worst


def distances(point, a, way):
    """Distances of a point from stretches, and its place along each."""
    along = np.clip(np.einsum("ij,ij->i", point - a, way)
                    / np.maximum(np.einsum("ij,ij->i", way, way), 1e-30), 0, 1)
    gap = np.linalg.norm(a + along[:, None] * way - point, axis=1)
    return gap, along


def finer(places):
    """Inserts a point of a cubic through four neighbours between every two."""
    if len(places) < 4:
        return places
    ends = np.vstack((places[:1], places, places[-1:]))
    middle = (9 * (ends[1:-2] + ends[2:-1]) - ends[:-3] - ends[3:]) / 16
    found = np.empty((2 * len(places) - 1, places.shape[1]))
    found[::2], found[1::2] = places, middle
    return found


def off(places, path):
    """Distance of places and path, both ways, on nine axes, a degree as a mm."""
    length = np.linalg.norm(np.diff(path, axis=0), axis=1)
    path = path[np.concatenate(([True], length > 1e-9))]
    way = np.diff(path, axis=0)
    length = np.linalg.norm(way, axis=1)
    reached = np.concatenate(([0], np.cumsum(length)))
    if len(path) < 2:
        return 0.0
    matched = np.zeros(len(places))
    worst, s, last = 0.0, 0.0, places[0]
    for k, place in enumerate(places):
        ahead = s + 5 * np.linalg.norm(place - last) + AHEAD
        low = max(0, np.searchsorted(reached, s - 0.5) - 1)
        high = max(low + 1, min(len(way), np.searchsorted(reached, ahead) + 1))
        gap, along = distances(place, path[low:high], way[low:high])
        # A path may return over itself: of equal distances, the one where the motion continues.
        found = reached[low:high] + along * length[low:high]
        expected = s + np.linalg.norm(place - last)
        found = np.where(gap <= gap.min() + SAME, found, np.inf)
        s = max(s, found[np.abs(found - expected).argmin()])
        worst, matched[k], last = max(worst, gap.min()), s, place
    places, matched = finer(places), np.interp(np.arange(2 * len(places) - 1) / 2,
                                               np.arange(len(places)), matched)
    for k in np.linspace(0, len(path) - 1, min(len(path), 20000)).astype(int):
        middle = np.searchsorted(matched, reached[k])
        low, high = max(0, middle - 120), min(len(places), middle + 120)
        step = np.diff(places[low:high], axis=0)
        if len(step):
            worst = max(worst, distances(path[k], places[low:high - 1], step)[0].min())
    return float(worst)


def figures(places, path, step):
    """Figures of positions every millisecond; `step`: the time between the given ones."""
    sampled = places[::round(PERIOD / step)]
    return {"s": (len(moving(places)) - 1) * step, "a": accelerations(sampled),
            "off_mm": off(moving(sampled), path)}


def tolerance(file, folder):
    """Returns the largest P of G64 in force, mm; 0: G61; None: some moves have no P."""
    done = subprocess.run([INTERPRET, file, "--scratch", folder / "scratch", "--ini",
                           HERE / "machine.ini"], check=True, capture_output=True, text=True)
    largest, allowed = 0.0, None
    for line in map(json.loads, done.stdout.splitlines()):
        if line["kind"] == "path":
            free = line["mode"] == "continuous" and line["tolerance"] == 0
            allowed = None if free else line["tolerance"]
        elif "to" in line:
            if allowed is None:
                return None
            largest = max(largest, allowed)
    return largest


def ours(curvecore, file, jerk, path, folder):
    (folder / "machine.ini").write_text(machine(jerk))
    out = folder / f"out-{jerk:g}"
    subprocess.run([curvecore, "run", file, "--on", "kernel", "--interpreter", "linuxcnc",
                    "--machine", folder / "machine.ini", "-q", "-o", out],
                   check=True, capture_output=True)
    _, places = read_samples(out / "samples.csv")
    return figures(places, path, 1e-4)


def theirs(file, path, folder):
    subprocess.run([SIMULATE, file, "--folder", folder / "simulation", "--velocity", str(VELOCITY),
                    "--acceleration", str(ACCELERATION), "--tools", HERE / "tools.tbl"], check=True)
    return figures(np.loadtxt(folder / "simulation/samples"), path, PERIOD)


def row(curvecore, name):
    with tempfile.TemporaryDirectory() as text:
        folder = Path(text)
        folder.chmod(0o755)  # LinuxCNC's real-time part is another user
        file = PROGRAMS / f"{name}.ngc"
        if name in OWN:
            file = folder / "part.ngc"
            file.write_text(OWN[name])
        (folder / "scratch").mkdir()
        subprocess.run([CALLBACKS, file, "--scratch", folder / "scratch", "--ini",
                        HERE / "machine.ini", "--path", folder / "path"], check=True)
        path = np.fromfile(folder / "path").reshape(-1, 10)[:, :9]
        found = {"program": name, "tolerance_mm": tolerance(file, folder)}
        found["linuxcnc"] = theirs(file, path, folder)
        for label, jerk in JERKS.items():
            found[label] = ours(curvecore, file, jerk, path, folder)
        return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("names", nargs="*")
    given = parser.parse_args()
    if not PROGRAMS.exists():
        print("skipped: linuxcnc-uspace is not installed")
        return 77
    rows = []
    for name in given.names or [*OWN, *SHIPPED]:
        rows.append(row(Path(given.program).resolve(), name))
        print(rows[-1], flush=True)
        Path(given.output).write_text(json.dumps({"rows": rows}, indent=2) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
