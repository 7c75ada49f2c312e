# SPDX-License-Identifier: Apache-2.0
"""Plans beside LinuxCNC's own motion: scripts/results/linuxcnc.md."""

import math

from result_table import load, table

USUAL_P = 0.01  # mm: what curvecore takes where a program names none
MEASURED_TO = 0.001  # mm: LinuxCNC's points on a circle are 0.6 um inside it, positions 1 nm
FOLLOWED = 3.0  # mm: what is farther off may not have been followed
ROUNDING = 1.001  # positions of 1 nm every ms
JERKS = ("1e5", "1e9")
HEAD = ["program", "P, um", "LinuxCNC, s", "a/A", "off, um", "J 1e5, s", "a/A", "off, um",
        "J 1e9, s", "a/A", "off, um", "J 1e5 / LinuxCNC", "J 1e9 / LinuxCNC"]


def keeps(row):
    """Returns whether LinuxCNC's own samples keep P and A."""
    tolerance = USUAL_P if row["tolerance_mm"] is None else row["tolerance_mm"]
    theirs = row["linuxcnc"]
    return max(theirs["a"]) <= ROUNDING and theirs["off_mm"] <= tolerance + MEASURED_TO


def cells(run):
    loads = " ".join(f"{load:.2f}" for load in run["a"])
    off = f"{1000 * run['off_mm']:.1f}" if run["off_mm"] < FOLLOWED else f"> {1000 * FOLLOWED:g}"
    return [f"{run['s']:.3f}", loads, off]


def ratio(row, jerk):
    return row[jerk]["s"] / row["linuxcnc"]["s"]


def part(title, rows):
    if not rows:
        return f"{title}: none."
    lines = []
    for row in rows:
        named = {None: "-", 0: "G61"}.get(row["tolerance_mm"])
        lines.append([row["program"].replace("_", " "),
                      named or f"{1000 * row['tolerance_mm']:g}",
                      *cells(row["linuxcnc"]), *cells(row["1e5"]), *cells(row["1e9"]),
                      *(f"{ratio(row, jerk):.3f}" for jerk in JERKS)])
    means = [math.exp(sum(math.log(ratio(row, jerk)) for row in rows) / len(rows))
             for jerk in JERKS]
    above = sum(ratio(row, "1e9") > 1 for row in rows)
    return (f"{title}; geometric mean {means[0]:.3f} at 1e5 mm/s^3, {means[1]:.3f} at 1e9, where "
            f"{above} of {len(rows)} are above 1:\n\n{table(HEAD, lines)}")


def linuxcnc():
    """Moving times of both, those where LinuxCNC keeps the limits apart from the others."""
    data = load("figures/linuxcnc.json")
    if data is None:
        return None
    rows = data["rows"]
    kept = part("LinuxCNC's samples keep P and A", [row for row in rows if keeps(row)])
    others = part("They do not", [row for row in rows if not keeps(row)])
    return f"{kept}\n\n{others}"
