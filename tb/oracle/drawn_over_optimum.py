#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Programs in G64 P: what is drawn, and how long over the oracle's time along that path.

    drawn_over_optimum.py --program curvecore -o FILE.json    all programs, printed
    drawn_over_optimum.py --program curvecore --check         some of them: fails where a plan is
                                                              slower than it should be, or off
"""

import json
import sys
import tempfile
from pathlib import Path

from drawn_path import stretches
from programs import FEED, PROGRAMS
from time_oracle import Limits
from time_over_optimum import arguments, best, plan, printed, shares

CHECKED = ("circle, chords of 0.1 mm", "turn, chords of 0.1 mm", "stadium, R 10")
SLOWER = 1.02  # than the oracle along the same path under the same shares


def row(program, name, folder):
    text = PROGRAMS[name]
    exact = plan(program, text, "optimum", folder, path="exact")
    exact_bounds = plan(program, text, "optimum", folder, "bounds", path="exact")
    bounds = plan(program, text, "optimum", folder, "bounds")
    report = plan(program, text, "optimum", folder)  # the last: its segments are read below
    limits = Limits()
    sums = {"oracle_shares_s": 0, "oracle_s": 0}
    for curves in stretches(folder / "out/segments.json"):
        grid = max(1200, 10 * len(curves))
        sums["oracle_shares_s"] += best(curves, limits.shares(*shares()), FEED, grid)
        sums["oracle_s"] += best(curves, limits, FEED, grid)
    return {
        "program": name,
        "tolerance_mm": report["deviation"]["P_mm"],
        "share": report["deviation"]["share_of_P"],
        "moves": exact["moves"],
        "drawn_moves": report["moves"],
        "words": exact["words"],
        "drawn_words": report["words"],
        "words_without_branches": exact_bounds["words"],
        "drawn_words_without_branches": bounds["words"],
        "exact_s": exact["duration_s"],
        "drawn_s": report["duration_s"],
        **sums,
    }


def check(program, folder):
    """Returns the exit status."""
    status = 0
    for name in CHECKED:
        found = row(program, name, folder)
        ratio = found["drawn_s"] / found["oracle_shares_s"]
        print(f"{name}: {found['drawn_s']:.4f} s, {ratio:.4f} of the oracle's time; "
              f"{found['share']:.4f} of the tolerance")
        status |= ratio > SLOWER or not 0.5 < found["share"] <= 1 + 1e-9
    return int(status)


def main():
    given = arguments(__doc__).parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if given.check:
            return check(given.program, folder)
        rows = printed(row(given.program, program, folder) for program in PROGRAMS)
    if given.output:
        Path(given.output).write_text(json.dumps({"rows": rows}, indent=2) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
