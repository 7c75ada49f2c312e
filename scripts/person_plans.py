#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Words and feeds of programs as a person has them, and the planner's time against an older tree's.
Writes build/figures/person_plans.json.

    scripts/person_plans.py [--before PLAN_COST]     plan_cost of the older tree
"""

import argparse
import json
import math
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build/curvecore"
PLAN_COST = ROOT / "build/release/tb/bench/plan_cost"
ROW, APART = 500, 0.5  # chords of a row of the surface, mm between rows
WIDE = {"SegmentQueueWords": 65536, "ProfileQueueWords": 4096}  # queues that slow nothing
CHORDS = {"0.2": "20000", "0.02": "100000"}  # mm, how many
RUNS = 3  # of each tree, in turn: the least counts


def surface(chords, chord=0.2):
    """A 3D surface in chords, rows to and fro."""
    for n in range(1, chords + 1):
        row, place = divmod(n, ROW + 1)
        x = chord * (place if row % 2 == 0 else ROW - place)
        y = APART * row
        z = 3 * math.sin(x / 7) * math.cos(y / 9) + 1.5 * math.sin(x / 2.5 + y / 4)
        yield f"G1 X{x:.3f} Y{y:.3f} Z{z:.3f}"


PROGRAMS = {"surface": surface(2000), "circles": ["G2 X0 Y0 I15 J0"] * 10, "line": ["G1 X100"]}


def report(folder, name, *options):
    subprocess.run([PROGRAM, "plan", folder / f"{name}.ngc", "-q", "--no-segments", "-o",
                    folder / "plan", *options], check=True, stderr=subprocess.DEVNULL)
    found = json.loads((folder / "plan/report.json").read_text())
    return {name: found[name] for name in ("build", "words", "path_mm", "duration_s")}


def boards(folder):
    """Yields each board's surface with its queues and with wide ones."""
    for file in sorted((ROOT / "scripts/boards").glob("*.json")):
        board = json.loads(file.read_text())
        board["parameters"] |= WIDE
        (folder / "wide.json").write_text(json.dumps(board))
        yield file.stem, {"own": report(folder, "surface", "--board", file.stem),
                          "wide": report(folder, "surface", "--board", folder / "wide.json")}


def words_of_a_line(folder):
    subprocess.run([PROGRAM, "words", folder / "line.ngc", "-q", "-o", folder / "words"],
                   check=True)
    segments = json.loads((folder / "words/words.json").read_text())["segments"]
    return segments["words"] / segments["count"]


def costs(before):
    """Times of both trees, us a chord, by the chords' length."""
    programs = {"now": PLAN_COST} | ({"before": before} if before else {})
    found = {}
    for chord, count in CHORDS.items():
        runs = [{name: json.loads(subprocess.run(
            [program, "--chord", chord, "--chords", count], check=True, capture_output=True,
            text=True).stdout)["us_a_chord"] for name, program in programs.items()}
            for _ in range(RUNS)]
        found[chord] = {name: min(run[name] for run in runs) for name in programs}
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--before", type=pathlib.Path, metavar="PLAN_COST")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for program, blocks in PROGRAMS.items():
            (folder / f"{program}.ngc").write_text(
                "\n".join(["G21 G90 G64 P0.01 F6000", *blocks, "M2", ""]))
        found = {"words": {name: report(folder, name) for name in PROGRAMS},
                 "words_of_a_line": words_of_a_line(folder), "boards": dict(boards(folder)),
                 "us_a_chord": costs(given.before)}
    print(json.dumps(found, indent=1))
    (ROOT / "build/figures").mkdir(parents=True, exist_ok=True)
    (ROOT / "build/figures/person_plans.json").write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
