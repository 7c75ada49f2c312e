#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""part_player draws rtl/examples/part.ngc, from the words that stand beside it, as `curvecore run`
does, position by position; and those words are what `curvecore words` makes.

    play.py CURVECORE IVERILOG VVP
    play.py CURVECORE --write       makes the words anew, and says the bench's parameters
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

RTL = pathlib.Path(__file__).resolve().parent.parent.parent / "rtl"
EXAMPLES = RTL / "examples"
STREAMS = ("segments", "profile")


def motion(positions):
    """Leaves out positions at rest, at the origin before the motion and at the end after it."""
    while positions[:1] == ["0,0,0"]:
        positions = positions[1:]
    while positions[-2:-1] == positions[-1:]:
        positions = positions[:-1]
    return positions


def curvecore(program, command, folder, *options):
    subprocess.run([program, command, "part.ngc", "-o", folder, "--set", "Splines=1", "--set",
                    "SampleInterval=8", "--sample-period", "500us", "-q", *options], cwd=EXAMPLES,
                   check=True)


def parameters(folder, samples):
    """Parameters of part_player_bench for the words of `folder`."""
    settings = json.loads((folder / "words.json").read_text())
    return {"Samples": samples + 100, "SegmentWords": settings["segments"]["words"],
            "ProfileWords": settings["profile"]["words"],
            "SamplesPerTickLog2": settings["samples_per_tick_log2"],
            "HoldAcceleration": settings["hold_acceleration"],
            "HoldSlope": settings["hold_slope"], "StopTicks": settings["stop_ticks"],
            "Digest": settings["digest"]}


def bench_defaults():
    text = (EXAMPLES / "part_player_bench.sv").read_text()
    return {name: int(value) for name, value in
            re.findall(r"parameter int (\w+) *= (\d+)", text)}


def played(iverilog, vvp, folder):
    files = [RTL / line for line in (RTL / "curvecore.f").read_text().split()]
    subprocess.run([iverilog, "-g2012", "-o", folder / "player", "-s", "part_player_bench", *files,
                    *sorted(EXAMPLES.glob("*.sv"))], check=True)
    lines = subprocess.run([vvp, "-n", folder / "player"], cwd=EXAMPLES, check=True, text=True,
                           stdout=subprocess.PIPE).stdout.split()
    return [line for line in lines if line.count(",") == 2]


def main(program, *tools):
    program = pathlib.Path(program).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        curvecore(program, "run", folder / "run")
        curvecore(program, "words", folder / "words", "--holds", "bounds")
        rows = [line.strip().split(",") for line in open(folder / "run/samples.csv")
                if line[0].isdigit()]
        wanted = parameters(folder / "words", len(rows))
        made = {stream: (folder / "words" / f"{stream}.hex").read_text() for stream in STREAMS}
        if tools == ("--write",):
            for stream, text in made.items():
                (EXAMPLES / f"{stream}.hex").write_text(text)
            print("part_player_bench:", wanted)
            return
        for stream, text in made.items():
            if text != (EXAMPLES / f"{stream}.hex").read_text():
                sys.exit(f"rtl/examples/{stream}.hex is not what is made: play.py .. --write")
        if wanted != bench_defaults():
            sys.exit(f"part_player_bench: {bench_defaults()}, and not {wanted}")
        expected = motion([",".join(row[3:6]) for row in rows])
        found = motion(played(*tools, folder))
    print(f"{len(expected)} positions, {sum(a != b for a, b in zip(expected, found))} differ")
    if found != expected:
        sys.exit(f"expected {expected[:3]} .. {expected[-1]}, drawn {found[:3]} .. {found[-1:]}")


if __name__ == "__main__":
    main(*sys.argv[1:])
