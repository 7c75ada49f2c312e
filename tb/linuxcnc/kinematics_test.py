#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Joints that the kernel draws, judged by LinuxCNC's own kinematics: each sample of a part of
straight moves is put through the module's forward kinematics, and must be on its line.

    kinematics_test.py --program CURVECORE --judge KINEMATICS_JUDGE [--modules DIR]

Exit status 77: Debian's linuxcnc-uspace, which has the modules, cannot be fetched here.
"""

import argparse
import csv
import pathlib
import random
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
UNIT = 1e-6  # mm
# What each machine of tb/data/machines is to LinuxCNC, where its tool may go, and what its pins
# are called; then a pin that is wrong on purpose.
MACHINES = {
    "corexy": ("corexykins", (20, 120, 20, 120), {}, None),
    "delta": ("lineardeltakins", (-60, 60, -60, 60), {"R": "R", "L": "L"}, "R=131"),
    "polar": ("rosekins", (20, 60, -60, 60), {}, None),
    "scara": ("scarakins", (150, 300, -150, 150),
              {**{f"D{n}": f"D{n}" for n in range(1, 6)}, None: "D6=0"}, "D4=-220"),
    "trunnion": ("xyzac-trt-kins", (-60, 60, -60, 60),
                 {"Y_OFFSET": "y-offset", "Z_OFFSET": "z-offset"}, "y-offset=-5"),
}
LINES = 8


def modules_of_package():
    folder = ROOT / "build/real_parts"
    folder.mkdir(parents=True, exist_ok=True)
    if not (folder / "usr").exists():
        if subprocess.run(["apt-get", "download", "-qq", "linuxcnc-uspace"], cwd=folder,
                          stderr=subprocess.DEVNULL).returncode != 0:
            sys.exit(77)
        package = next(folder.glob("linuxcnc-uspace_*.deb"))
        subprocess.run(["dpkg-deb", "--extract", package, folder], check=True)
        package.unlink()
    return folder / "usr/lib/linuxcnc/modules"


def ini_values(file):
    pairs = (line.split("=") for line in file.read_text().splitlines() if "=" in line)
    return {name.strip(): value.strip() for name, value in pairs}


def points_of(name, span):
    """Random places of the tool, with angles of a table that has some."""
    of = random.Random(name)
    turns = name == "trunnion"
    return [[of.uniform(*span[:2]), of.uniform(*span[2:]), of.uniform(0, 20)] +
            [of.uniform(-30, 30) * turns, 0, of.uniform(-90, 90) * turns] for _ in range(LINES)]


def program_of(points):
    words = "".join
    return "G21 G90 G61\n" + words(
        f"{'G0' if n == 0 else 'G1'} X{p[0]!r} Y{p[1]!r} Z{p[2]!r}" +
        (f" A{p[3]!r} C{p[5]!r}" if any(p[3:]) else "") + " F3000\n"
        for n, p in enumerate(points)) + "M2\n"


def drawn_joints(program, machine, points, folder):
    part = folder / "part.ngc"
    part.write_text(program_of(points))
    subprocess.run([program, "run", part, "--machine", machine, "--on", "kernel", "--path",
                    "exact", "--sample-period", "500us", "-q", "-o", folder / "out"], check=True)
    lines = (line for line in open(folder / "out/samples.csv") if not line.startswith("#"))
    for row in csv.DictReader(lines):
        yield [float(row[axis]) * UNIT if axis in row else 0.0 for axis in "xyzabc"]


def judged(judge, module, pins, rows):
    text = "".join(" ".join(map(repr, row)) + "\n" for row in rows)
    done = subprocess.run([judge, module, *pins], input=text, capture_output=True, text=True,
                          check=True)
    return [list(map(float, line.split())) for line in done.stdout.splitlines()]


def off_line(place, start, end):
    way = [b - a for a, b in zip(start, end)]
    square = sum(w * w for w in way)
    part = sum((p - a) * w for p, a, w in zip(place, start, way)) / square if square else 0
    part = min(1.0, max(0.0, part))
    return sum((a + part * w - p) ** 2 for p, a, w in zip(place, start, way)) ** 0.5


def worst_off(places, points):
    """Largest distance from the polyline, whose lines come in order."""
    worst, line = 0, 0
    for place in places:
        off = off_line(place, points[line], points[line + 1])
        while line + 2 < len(points):
            ahead = off_line(place, points[line + 1], points[line + 2])
            if ahead > off:
                break
            line, off = line + 1, ahead
        worst = off if not off <= worst else worst  # also what is not a number
    # All lines are drawn, to the end.
    return worst if line + 2 == len(points) else float("inf")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--judge", required=True)
    parser.add_argument("--modules", type=pathlib.Path)
    asked = parser.parse_args()
    modules = asked.modules or modules_of_package()
    faults = 0
    for name, (kins, span, pin_names, wrong) in MACHINES.items():
        machine = ROOT / f"tb/data/machines/{name}.ini"
        values = ini_values(machine)
        pins = [f"{kins}.{pin}={values[of]}" if of else f"{kins}.{pin}"
                for of, pin in pin_names.items()]
        points = points_of(name, span)
        with tempfile.TemporaryDirectory() as folder:
            joints = list(drawn_joints(asked.program, machine, points, pathlib.Path(folder)))
        module = modules / f"{kins}.so"
        rows = judged(asked.judge, module, pins, joints)
        lines = [rows[0][:3]] + [point[:3] for point in points]
        off = worst_off((row[:3] for row in rows), lines)
        # A tool is off by what its joints' last digit is worth to it.
        held = off < 10 * UNIT
        # A joint of the other sign, or a pin that is wrong, is seen.
        turned = [[row[0], -row[1], *row[2:]] for row in joints]
        controls = [judged(asked.judge, module, pins, turned)]
        if wrong:
            controls.append(judged(asked.judge, module, pins + [f"{kins}.{wrong}"], joints))
        red = all(not worst_off((row[:3] for row in others), lines) < 0.1 for others in controls)
        print(f"{name}: {len(rows)} samples, tool off by {off / UNIT:.2f} nm at most"
              f"{'' if held else ': TOO FAR'}{'' if red else '; a control was not seen'}")
        faults += not (held and red)
    print(f"{len(MACHINES)} machines, {faults} faults")
    return faults > 0


if __name__ == "__main__":
    sys.exit(main())
