# SPDX-License-Identifier: Apache-2.0
"""Times of what a person asks `stream` for, at the pins of the virtual board of each build: an
override that is raised and lowered, a hold, a resume.

    person_runs.py CURVECORE FILE.json

A wish is made where the board's path stands when it is asked; the host and the wire are in each
time, which on a fast board is counted by its own clock: 5 ms a frame.
"""

import json
import pathlib
import sys
import tempfile
import time

from wire_parts import CURVECORE, STATE, STEPS_PER_MM, Board, drawn_mm, read, report_of, subprocess

FEED = 20  # mm/s
LIFT = 5  # mm, a rapid before the line: its bounds of holds are those of the fastest move
LENGTH = 200  # mm
PART = f"G21 G90\nG0 Z{LIFT}\nG1 X{LENGTH} F{60 * FEED}\nM2\n"
WISHES = {"override 150": 20, "override 40": 110, "override 100": 140, "hold": 175}  # mm
STOOD = 1 << 17 | 1 << 19  # of STATE: holding, standing
WINDOW = 40  # steps over which a speed is measured
NEAR = 0.02  # share of a speed within which it counts as another
STOOD_S = 0.05  # s without a step: a rest


def drive(build, folder):
    """Returns the clocks of X's steps, each wish with the steps before it, and the clock rate."""
    part, wishes = folder / "part.ngc", folder / "wishes"
    part.write_text(PART, encoding="ascii")
    wishes.touch()
    board = Board(str(folder / "board"), "--fast", "--build", build)

    def wish(text):
        with open(wishes, "a", encoding="ascii") as file:
            file.write(text + "\n")

    try:
        host = subprocess.Popen([CURVECORE, "stream", part, "--to", f"udp:127.0.0.1:{board.port}",
                                 "--control", wishes, "-o", folder / "stream"],
                                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                stderr=subprocess.DEVNULL)
        asked = {}
        for text, at_mm in WISHES.items():
            while (drawn := drawn_mm(board.port)) < LIFT + at_mm:
                time.sleep(0.01)
            wish(text)
            asked[text] = round((drawn - LIFT) * STEPS_PER_MM)
        while read(board.port, STATE) & STOOD != STOOD:
            time.sleep(0.05)
        time.sleep(0.5)
        wish("resume")
        if host.wait() != 0:
            sys.exit(f"person_runs: stream ended with {host.returncode}")
        clocks = [clock for clock, axis, _ in board.end() if axis == 0]
        return clocks, asked, report_of(folder / "stream")["board"]["clock_hz"]
    finally:
        board.kill()


def times(clocks, asked, clock_hz):
    """Seconds from each wish on, by its name."""
    def speed(n):
        return WINDOW / STEPS_PER_MM * clock_hz / (clocks[n + WINDOW] - clocks[n])

    def since(step, wish):
        return (clocks[step] - clocks[asked[wish]]) / clock_hz

    def first(step, reached):
        return next(n for n in range(step, len(clocks) - WINDOW) if reached(speed(n)))

    rest = next(n for n in range(asked["hold"], len(clocks) - 1)
                if clocks[n + 1] - clocks[n] > STOOD_S * clock_hz)
    full = first(rest + 1, lambda v: v > (1 - NEAR) * FEED)
    return {"raised_s": since(first(asked["override 150"], lambda v: v > (1 + NEAR) * FEED),
                              "override 150"),
            "raised_whole_s": since(first(asked["override 150"],
                                          lambda v: v > 1.5 * (1 - NEAR) * FEED), "override 150"),
            "lowered_s": since(first(asked["override 40"], lambda v: v < 1.5 * (1 - NEAR) * FEED),
                               "override 40"),
            "lowered_whole_s": since(first(asked["override 40"],
                                           lambda v: v < 0.4 * (1 + NEAR) * FEED), "override 40"),
            "hold_s": since(rest, "hold"),
            "resume_s": (clocks[full] - clocks[rest + 1]) / clock_hz}


def main():
    found = {}
    for build in ("parallel", "engine"):
        with tempfile.TemporaryDirectory() as folder:
            found[build] = times(*drive(build, pathlib.Path(folder)))
        print(build, ", ".join(f"{name} {value:.3f}" for name, value in found[build].items()))
    pathlib.Path(sys.argv[2]).write_text(json.dumps({"feed_mm_s": FEED, "builds": found}, indent=2)
                                         + "\n", encoding="ascii")


if __name__ == "__main__":
    main()
