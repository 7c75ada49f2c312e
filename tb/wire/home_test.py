#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`curvecore home` and `curvecore board` with home switches, by the pins of the board.

    home_test.py CURVECORE [unittest's options]
"""

import json
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import unittest

from wire_parts import (AXES, CURVECORE, ENABLED, STATE, STEPS_PER_MM, SWITCHES, Board, counts,
                        flaw, read, report_of, until)

FAR = 10**6
# X latches where its switch closes, Y where it opens, below the travel; Z is above it.
SEARCH, LATCH = (-20, -20, 20), (-2, 2, 2)
OFFSET, HOME = (-0.5, -0.25, 0.5), (0, 0.25, -0.25)
LIMITS = ((0, 4), (0, 4), (-4, 0))
REACH = 5  # mm


def machine(**changes):
    """Returns a machine's file; programs are shaped, homing is not."""
    text = "[TRAJ]\nCOORDINATES = X Y Z\nMAX_LINEAR_VELOCITY = 50\nSHAPER = zv\n"
    for axis in range(3):
        values = {"MAX_VELOCITY": 50, "MAX_ACCELERATION": 1000, "MIN_LIMIT": LIMITS[axis][0],
                  "MAX_LIMIT": LIMITS[axis][1], "HOME_SEARCH_VEL": SEARCH[axis],
                  "HOME_LATCH_VEL": LATCH[axis], "HOME_OFFSET": OFFSET[axis], "HOME": HOME[axis],
                  "SHAPER_FREQUENCY": 50}
        values.update(changes)
        text += f"[JOINT_{axis}]\n" + "".join(f"{n} = {v}\n" for n, v in values.items())
    return text


def switches(places):
    """Options of a board whose switches close at these steps, up to far beyond."""
    ranges = [f"{-FAR}..{place}" if SEARCH[axis] < 0 else f"{place}..{FAR}"
              for axis, place in enumerate(places)]
    return ["--home", ",".join(f"{'xyz'[axis]}={text}" for axis, text in enumerate(ranges))]


def edges(places):
    """Returns the latch: an axis that latches as a switch opens is one step off it."""
    return [place + (1 if axis == 1 else 0) for axis, place in enumerate(places)]


class HomeTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.machine = self.folder / "mill.ini"
        self.machine.write_text(machine(), encoding="ascii")

    def board(self, places, *options):
        board = Board(str(self.folder / "board"), "--fast", *switches(places), *options)
        self.addCleanup(board.kill)
        return board

    def start(self, command, board, *options):
        return subprocess.Popen(
            [CURVECORE, *command, "--machine", str(self.machine), "--to",
             f"udp:127.0.0.1:{board.port}", *options],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def finish(self, host, status=0, text=""):
        said, message = host.communicate()
        self.assertEqual(host.returncode, status, message)
        self.assertIn(text, message)
        return [int(step) for step in re.findall(r"at step (-?\d+),", said)]

    def home(self, board, *options, status=0, text=""):
        return self.finish(self.start(["home"], board, *options), status, text)

    def stream(self, board, program, status=0, text=""):
        part = self.folder / "part.ngc"
        part.write_text(f"G21 G90 G61 F600\n{program}\nM2\n", encoding="ascii")
        folder = str(self.folder / "stream")
        host = self.start(["stream", str(part)], board, "-q", "-o", folder)
        self.finish(host, status, text)

    def check_overrun(self, steps, places):
        """Checks that each axis is within 2.5 mm of its edge: samples ahead, the stop."""
        stands = [0, 0, 0]
        for _, axis, way in steps:
            stands[axis] += way
            beyond = abs(stands[axis] - edges(places)[axis])
            # At 20 mm/s a hold acts 15 samples of 1.6 ms later: 0.5 mm of it.
            self.assertLessEqual(beyond, 2.5 * STEPS_PER_MM, f"axis {axis}")

    def check_homed(self, steps, places):
        """Checks that all axes stand at HOME, which is OFFSET from their switches."""
        for axis, edge in enumerate(edges(places)):
            stands = edge + round((HOME[axis] - OFFSET[axis]) * STEPS_PER_MM)
            self.assertLessEqual(abs(counts(steps)[axis] - stands), 1, f"axis {axis}")

    def test_from_anywhere_and_programs_know_where_it_stands(self):
        chance = random.Random(8)
        for _ in range(int(os.environ.get("CURVECORE_LONG", "0")) + 1):
            places = [chance.randrange(100, 1000) * (-1 if SEARCH[axis] < 0 else 1)
                      for axis in range(3)]
            board = self.board(places)
            self.stream(board, "G1 X1", 2, "Z is not homed: curvecore home --machine")
            found = self.home(board)
            self.assertEqual(found, [edges(places)[axis] for axis in (2, 0, 1)])
            self.stream(board, "G1 X1", 2, "Y stands at 0.25 mm, and the program begins at 0 mm")
            steps = board.end()
            self.check_homed(steps, places)
            order = [axis for n, (_, axis, _) in enumerate(steps)
                     if n == 0 or steps[n - 1][1] != axis]
            self.assertEqual(order, [2, 0, 1])

    def test_again_and_again_within_a_step(self):
        places = (-300, -200, 400)
        board = self.board(places)
        first = self.home(board)
        for axes, of_all in (("xyz", (0, 1, 2)), ("Y", (2,))):
            found = self.home(board, "--axes", axes)
            for step, n in zip(found, of_all):
                self.assertLessEqual(abs(step - first[n]), 1)
        self.check_homed(board.end(), places)

    def test_a_switch_that_is_closed_is_left_first(self):
        places = (250, 350, -150)
        board = self.board(places)
        found = self.home(board)
        self.assertEqual(found, [edges(places)[axis] for axis in (2, 0, 1)])
        steps = board.end()
        self.check_homed(steps, places)
        self.check_overrun(steps, places)
        for axis in range(3):
            first = next(way for _, one, way in steps if one == axis)
            self.assertEqual(first, -1 if SEARCH[axis] > 0 else 1)

    def test_a_missing_switch_is_told(self):
        board = self.board((-FAR + 1, -200, 400))
        self.home(board, "--axes", "X", status=1,
                  text=f"X: the home switch did not close within {REACH} mm down")
        self.assertEqual(read(board.port, SWITCHES) >> 10, 0)
        self.stream(board, "G1 X1", 2, "Z is not homed")
        self.assertEqual(counts(board.end()), [-REACH * STEPS_PER_MM, 0, 0])

    def test_a_switch_that_never_opens_is_told(self):
        board = self.board((FAR, -200, 400))
        self.home(board, "--axes", "X", status=1,
                  text=f"X: the home switch did not open within {REACH} mm up")

    def test_what_ends_it_leaves_the_axis_unknown(self):
        board = self.board((-1900, -200, 400))
        self.home(board, "--axes", "Z")
        for wish, status, text in (("estop", 1, "X: the board stopped: e-stop"), ("stop", 130, ""),
                                   (signal.SIGINT, 130, "")):
            control = self.folder / "control"
            control.write_text("", encoding="ascii")
            stands = read(board.port, AXES + 8)
            host = self.start(["home"], board, "--axes", "X", "--control", str(control))
            until(lambda: read(board.port, AXES + 8) != stands)
            if wish is signal.SIGINT:
                host.send_signal(wish)
            else:
                with control.open("a", encoding="ascii") as file:
                    file.write(f"{wish}\n")
            self.finish(host, status, text)
            self.assertEqual(read(board.port, SWITCHES) >> 10, 1 << 2)
            self.assertFalse(read(board.port, STATE) & ENABLED)
        x, _, z = counts(board.end())
        self.assertGreater(x, -1900)
        self.assertLessEqual(abs(z - 400 + 0.75 * STEPS_PER_MM), 1)

    def test_programs_stay_in_the_travel_and_go_on_where_the_last_one_ended(self):
        self.machine.write_text(machine(HOME=0, HOME_OFFSET=-0.1, HOME_SEARCH_VEL=-10,
                                        HOME_LATCH_VEL=-1, MIN_LIMIT=0, MAX_LIMIT=4),
                                encoding="ascii")
        board = self.board((-100, -100, FAR))
        self.machine.write_text(self.machine.read_text(encoding="ascii").replace(
            "[JOINT_2]", "[NO_JOINT]"), encoding="ascii")
        self.home(board)
        self.stream(board, "G1 X3 Y2")
        self.stream(board, "G1 X1", 2, "X stands at 3 mm, and the program begins at 0 mm")
        self.stream(board, "G1 X5", 2, "beyond the machine's travel")
        self.home(board, "--axes", "X")
        self.stream(board, "G1 X1", 2, "Y stands at 2 mm, and the program begins at 0 mm")
        # Another scale: the place is unknown.
        part = self.folder / "part.ngc"
        self.finish(self.start(["stream", str(part)], board, "--steps-per-mm", "200"), 2,
                    "X is not homed")
        origin = -100 + round(0.1 * STEPS_PER_MM)
        self.assertEqual(counts(board.end())[:2], [origin, origin + 2 * STEPS_PER_MM])

    def test_limit_switches_are_home_switches_where_the_machine_says_so(self):
        places = (150, -300, 300)  # X stands on its own
        board = self.board(places, "--limits")
        self.home(board, "--axes", "Z", status=2, text="does not come on: a limit switch")
        self.machine.write_text(machine(HOME_IGNORE_LIMITS="YES", HOME=0, MIN_LIMIT=-3,
                                        MAX_LIMIT=3), encoding="ascii")
        found = self.home(board)
        self.assertEqual(found, [edges(places)[axis] for axis in (2, 0, 1)])
        # From then on they stop the machine again.
        self.stream(board, "G1 X-2", 1, "the board stopped: a limit switch")
        steps = board.end()
        self.assertEqual(steps[-1][1:], (0, -1))
        self.assertLessEqual(abs(counts(steps)[0] - places[0]), 1)

    def test_results_are_json(self):
        board = subprocess.Popen(
            [CURVECORE, "board", "--listen", "127.0.0.1:0", "--fast", "--json",
             *switches((-FAR, -200, 400))],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(board.communicate)
        self.addCleanup(board.kill)
        port = next(filter(None, (re.match(r"listening on .*:(\d+):", line)
                                  for line in board.stderr)))[1]
        part = self.folder / "part.ngc"
        part.write_text("G21 G90 G61 F600\nG1 X0.1\nM2\n", encoding="ascii")

        def result(name, *words, status=0):
            done = subprocess.run([CURVECORE, *words, "--to", f"udp:127.0.0.1:{port}", "--json"],
                                  stdin=subprocess.DEVNULL, capture_output=True, text=True)
            self.assertEqual(done.returncode, status, done.stderr)
            found = json.loads(done.stdout)
            self.assertEqual(flaw(name, found), "")
            return found

        drawn = result("stream", "stream", part, "-o", self.folder / "drawn")
        self.assertEqual(drawn, report_of(self.folder / "drawn"))
        found = result("home", "home", "--machine", self.machine, "--axes", "Z")
        self.assertEqual(found["end"], "homed")
        self.assertEqual([axis["axis"] for axis in found["axes"]], ["Z"])
        self.assertEqual(found["axes"][0]["switch_step"], 400)
        failed = result("home", "home", "--machine", self.machine, "--axes", "X", status=1)
        self.assertEqual(failed, {"end": "failed", "axes": []})
        board.send_signal(signal.SIGINT)
        ended = json.loads(board.communicate()[0])
        self.assertEqual(flaw("board", ended), "")
        self.assertEqual(ended["address"].split(":")[1], port)
        self.assertGreater(ended["steps"], 40)

    def test_machines_that_cannot_be_homed(self):
        board = self.board((-100, -100, 100))
        for changes, text in (({"HOME_SEARCH_VEL": 0}, "has no axis with HOME_SEARCH_VEL"),
                              ({"HOME_LATCH_VEL": 0}, "HOME_LATCH_VEL is missing"),
                              ({"HOME": 9}, "HOME is beyond the travel"),
                              ({"HOME_USE_INDEX": "YES"}, "there is no index input"),
                              ({"MAX_LIMIT": 1e99}, "MIN_LIMIT and MAX_LIMIT are needed")):
            self.machine.write_text(machine(**changes), encoding="ascii")
            self.home(board, status=2, text=text)
        self.machine.write_text(machine(), encoding="ascii")
        self.home(board, "--axes", "XA", status=2, text="--axes XA: home switches are of ZXY")
        self.assertEqual(board.end(), [])


if __name__ == "__main__":
    del sys.argv[1]
    unittest.main()
