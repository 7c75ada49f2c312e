#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Durations that `curvecore plan` gives, over those of the oracle.

    time_over_optimum.py --program curvecore -o FILE.json    all paths, printed as a table
    time_over_optimum.py --program curvecore --check         some of them: fails where a plan of the
                                                             effort optimum is slower than it should
    time_over_optimum.py --program curvecore --axes 500,5000,1e5/50,5000,1e5/500,5000,1e5 PATH ..
                          some of them, where X, Y and Z have limits of velocity, acceleration, jerk

The program's machine has the limits of time_oracle.Limits; its plans take shares of them, the rest
is for holds.
"""

import argparse
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import ruckig
from paths import PATHS, Line, code
from time_oracle import Limits, oracle

ROOT = Path(__file__).resolve().parents[2]
FEEDS = (500.0, 100.0)  # mm/s
GRID = 1200
CHECKED = ("circle25", "wave")
SLOWER = 1.015  # than the oracle under the same shares

FULL = (500.0, 5000.0, 1e5)  # of an axis
SLOW = (50.0, 5000.0, 1e5)
MIXED = ((1000.0, 1e4, 2e5), (300.0, 3000.0, 5e4), SLOW[:1] + (500.0, 1e4))
# Limits of X, Y and Z: those of the path bind along with theirs.
UNEQUAL = (("circle25", (FULL, SLOW, FULL)), ("helix", (FULL, SLOW, FULL)),
           ("wave", (FULL, SLOW, FULL)), ("chain3d", (FULL, FULL, SLOW)),
           ("circle25", MIXED), ("wave", MIXED), ("chain3d", MIXED))
CHECKED_UNEQUAL = (UNEQUAL[0], UNEQUAL[2])
UNEQUAL_SLOWER = 1.03  # than the oracle under the whole limits


def shares():
    """Shares of the limits as in the planner."""
    text = (ROOT / "ref/limits/limits.hpp").read_text()
    return [float(re.search(rf"{name} = ([\d.]+);", text)[1])
            for name in ("kAccelerationShare", "kJerkShare")]


def machine(limits):
    """LinuxCNC's .ini."""
    path = (f"[TRAJ]\nMAX_LINEAR_VELOCITY = {limits.velocity}\n"
            f"MAX_LINEAR_ACCELERATION = {limits.acceleration}\n"
            f"MAX_LINEAR_JERK = {limits.jerk}\nJOINT_TIME = {limits.joint_time}\n")
    axes = zip("XYZ", limits.axes)
    return path + "".join(f"[AXIS_{letter}]\nMAX_VELOCITY = {v}\nMAX_ACCELERATION = {a}\n"
                          f"MAX_JERK = {j}\n" for letter, (v, a, j) in axes)


def plan(program, text, effort, folder, holds="branches", limits=Limits(), path="program"):
    """Returns the report of a program's text; all other files are in folder / "out"."""
    file = folder / "path.ngc"
    file.write_text(text)
    own = []
    if limits != Limits():  # which the built-in machine has
        (folder / "machine.ini").write_text(machine(limits))
        own = ["--machine", folder / "machine.ini"]
    subprocess.run([program, "plan", file, "--effort", effort, "--holds", holds, "--path", path,
                    "-q", "-o", folder / "out", *own], check=True)
    return json.loads((folder / "out/report.json").read_text())


def planned(program, curves, feed, effort, folder, limits):
    return plan(program, code(curves, feed * 60), effort, folder, limits=limits)["duration_s"]


def best(curves, limits, feed, grid):
    """The better of two starts: a slow motion, and that of a stronger machine slowed."""
    found = [oracle(curves, limits, feed, grid)]
    strong = oracle(curves, limits.shares(1.3, 1.5), feed, grid)
    if strong:
        found.append(oracle(curves, limits, feed, grid, strong.slowed(1.5**(1 / 3))))
    times = [motion.duration for motion in found if motion]
    if not times:
        sys.exit("time_over_optimum: the oracle found no motion")
    return min(times)


def seven_phases(length, limits, feed):
    """A line from rest to rest by Ruckig, which is exact there."""
    generator = ruckig.Ruckig(1)
    wanted = ruckig.InputParameter(1)
    wanted.target_position = [length]
    wanted.max_velocity = [min(feed, limits.velocity)]
    wanted.max_acceleration = [limits.acceleration]
    wanted.max_jerk = [limits.jerk]
    trajectory = ruckig.Trajectory(1)
    generator.calculate(wanted, trajectory)
    return trajectory.duration


def off_on_lines(limits, grid):
    """Returns the oracle's worst error against Ruckig's time, as a share."""
    worst = 0
    for length in (1.0, 10.0, 100.0, 300.0):
        for feed in FEEDS:
            exact = seven_phases(length, limits, feed)
            motion = oracle([Line((0, 0, 0), (length, 0, 0))], limits, feed, grid)
            worst = max(worst, abs(motion.duration / exact - 1))
    return worst


def row(program, name, feed, grid, folder, limits=Limits()):
    curves = PATHS[name]
    return {
        "path": name,
        "feed_mm_s": feed,
        "rules_s": planned(program, curves, feed, "rules", folder, limits),
        "optimum_s": planned(program, curves, feed, "optimum", folder, limits),
        "oracle_shares_s": best(curves, limits.shares(*shares()), feed, grid),
        "oracle_s": best(curves, limits, feed, grid),
    }


def axes_row(program, name, axes, grid, folder):
    """Rows of a machine with these limits of X, Y and Z."""
    found = row(program, name, FEEDS[0], grid, folder, Limits(axes=axes))
    return {"axes": axes, **found, "ratio": found["optimum_s"] / found["oracle_s"]}


def check(program, folder):
    """Returns the exit status."""
    status = 0
    off = off_on_lines(Limits(), 400)
    print(f"oracle against Ruckig on lines: off by {off:.1e} at worst")
    status |= off > 2e-4
    for name in CHECKED:
        found = row(program, name, FEEDS[0], 600, folder)
        ratio = found["optimum_s"] / found["oracle_shares_s"]
        print(f"{name}: {found['optimum_s']:.4f} s, {ratio:.4f} of the oracle's time")
        status |= ratio > SLOWER
        # Control: the rules differ from the optimum, except on lines.
        status |= name != "line100" and found["rules_s"] / found["oracle_shares_s"] < 1.1
    for name, axes in CHECKED_UNEQUAL:
        found = axes_row(program, name, axes, 600, folder)
        print(f"{name}, axes {axes}: {found['optimum_s']:.4f} s, {found['ratio']:.4f} of the "
              "oracle's time under the whole limits")
        status |= found["ratio"] > UNEQUAL_SLOWER
    return int(status)


def arguments(text):
    """Command line that both programs share; one of them adds options."""
    parser = argparse.ArgumentParser(description=text,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, metavar="CURVECORE")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("-o", dest="output", metavar="FILE.json")
    return parser


def printed(rows):
    """Yields the rows and prints them."""
    found = []
    for row in rows:
        print(", ".join(f"{name} {value}" for name, value in row.items()), flush=True)
        found.append(row)
    return found


def axes_of(text):
    """Reads V,A,J/V,A,J/V,A,J."""
    axes = tuple(tuple(float(value) for value in axis.split(",")) for axis in text.split("/"))
    if [len(axis) for axis in axes] != [3, 3, 3]:
        raise argparse.ArgumentTypeError("three times V,A,J, with / between them")
    return axes


def main():
    parser = arguments(__doc__)
    parser.add_argument("--axes", type=axes_of, metavar="V,A,J/V,A,J/V,A,J")
    parser.add_argument("paths", nargs="*", metavar="PATH")
    given = parser.parse_args()
    unknown = set(given.paths) - set(PATHS)
    if unknown or bool(given.paths) != bool(given.axes):
        parser.error(f"--axes goes with some of {' '.join(PATHS)}")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if given.check:
            return check(given.program, folder)
        if given.axes:
            result = {"rows": printed(axes_row(given.program, path, given.axes, GRID, folder)
                                      for path in given.paths)}
        else:
            rows = printed(row(given.program, path, feed, GRID, folder)
                           for feed in FEEDS for path in PATHS)
            unequal = printed(axes_row(given.program, path, axes, GRID, folder)
                              for path, axes in UNEQUAL)
            result = {"rows": rows, "unequal": unequal,
                      "off_on_lines": off_on_lines(Limits(), GRID)}
    if given.output:
        Path(given.output).write_text(json.dumps(result, indent=2) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
