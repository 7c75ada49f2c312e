#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""play.py CURVECORE IVERILOG VVP: part_player draws a part from the files of `curvecore words` as
`curvecore run` does, position by position."""

import json
import pathlib
import subprocess
import sys
import tempfile

PART = "G21 G90 F600\nG2 X0.04 Y0 I0.02 J0\nG5 X0.08 Y0.02 I0.02 J0.02 P-0.02 Q0.01\nG1 Z0.01\nM2\n"
RTL = pathlib.Path(__file__).resolve().parent.parent.parent / "rtl"


def motion(positions):
    """Without what is drawn at rest, at the origin before and at the end after."""
    while positions[:1] == ["0,0,0"]:
        positions = positions[1:]
    while positions[-2:-1] == positions[-1:]:
        positions = positions[:-1]
    return positions


def main():
    curvecore = pathlib.Path(sys.argv[1]).resolve()
    iverilog, vvp = sys.argv[2:]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "part.ngc").write_text(PART)
        for command in ("run", "words"):
            subprocess.run([curvecore, command, "part.ngc", "-o", command, "--build", "serial",
                            "--set", "Splines=1", "--sample-period", "500us", "-q"], cwd=folder,
                           check=True)
        rows = [line.strip().split(",") for line in open(folder / "run/samples.csv")
                if line[0].isdigit()]
        expected = motion([",".join(row[3:6]) for row in rows])

        settings = json.loads((folder / "words/words.json").read_text())
        parameters = {
            "Samples": len(rows) + 100,
            "SamplesPerTickLog2": settings["samples_per_tick_log2"],
            "HoldAcceleration": settings["hold_acceleration"],
            "HoldSlope": settings["hold_slope"],
            "StopTicks": settings["stop_ticks"],
        }
        for stream, file in (("Segment", "segments.hex"), ("Profile", "profile.hex")):
            lines = (folder / "words" / file).read_text().split("\n")
            words = [line for line in lines if line and not line.startswith("//")]
            parameters[f"{stream}Words"] = len(words)
        generics = [f"-Ppart_player_bench.{name}={value}" for name, value in parameters.items()]
        files = [RTL / line for line in (RTL / "curvecore.f").read_text().split()]
        subprocess.run([iverilog, "-g2012", "-o", folder / "player", "-s", "part_player_bench",
                        *generics, *files, *sorted((RTL / "examples").glob("*.sv"))],
                       check=True)
        found = subprocess.run([vvp, "-n", folder / "player"], cwd=folder / "words", check=True,
                               text=True, stdout=subprocess.PIPE).stdout.split()
        found = motion([line for line in found if line.count(",") == 2])
    print(f"{len(expected)} positions, {sum(a != b for a, b in zip(expected, found))} differ")
    if found != expected:
        sys.exit(f"expected {expected[:3]} .. {expected[-1]}, drawn {found[:3]} .. {found[-1:]}")


if __name__ == "__main__":
    main()
