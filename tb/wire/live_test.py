# SPDX-License-Identifier: Apache-2.0
"""Plans made while a program is drawn: for an override above 100 % from the first open move on, and
for a resume from where the axes stand."""

import csv
import math
import re
import time
import unittest

from wire_parts import (QUANTA_PER_MM, STATE, STEPS_PER_MM, WishTest, counts, drawn_mm, read,
                        report_of)

FEED = 20  # mm/s
LENGTH = 110  # mm
# A move at the machine's greatest speed, whose bounds of holds are slow ones, and a whole turn.
RADIUS, DEPTH = 30, 40
HELD_PART = f"G21 G90\nM3 S500\nG0 Z{DEPTH}\nG3 X0 Y0 I0 J{RADIUS} F{60 * FEED}\nM2\n"
HELD = 1 << 17 | 1 << 19  # of STATE: holding, standing
# A dwell of 3 s at 20 mm.
DWELL = 3
DWELLING_PART = f"G21 G90\nG1 X20 F{60 * FEED}\nG4 P{DWELL}\nG1 X40\nM2\n"


class LiveTest(WishTest):
    part_text = f"G21 G90\nG1 X{LENGTH} F{60 * FEED}\nM2\n"

    def draw(self, build, wishes, *options):
        """Draws the part; each wish comes when so many mm are drawn.  Returns the clock in which
        each step came, and the clocks of a second."""
        board = self.board(build)
        host = self.stream(board, "--control", self.wishes, *options)
        for at_mm, wish in wishes:
            while drawn_mm(board.port) < at_mm:
                time.sleep(0.2)  # the questions advance the board's clock, whoever is not ready
            self.wish(wish)
        self.assertEqual(self.end(host, 0), "")
        steps = board.end()
        self.assertEqual(counts(steps), [LENGTH * STEPS_PER_MM, 0, 0])
        return ([clock for clock, _, _ in steps],
                report_of(self.folder / "stream")["board"]["clock_hz"])

    def check_speed(self, drawn, begin, end, speed):
        steps, clock_hz = drawn
        clocks = steps[end * STEPS_PER_MM] - steps[begin * STEPS_PER_MM]
        self.assertAlmostEqual((end - begin) * clock_hz / clocks / speed, 1, delta=0.01)

    def test_is_raised_and_lowered(self):
        drawn = self.draw("engine", [(5, "override 150"), (72, "override 100")])
        self.check_speed(drawn, 1, 4, FEED)
        # What was given out is some 2.5 s of motion, and then it is faster.
        self.check_speed(drawn, 58, 70, 1.5 * FEED)
        self.check_speed(drawn, 94, 106, FEED)

    def test_begins_raised(self):
        drawn = self.draw("parallel", [(30, "override 60")], "--override", "150")
        self.check_speed(drawn, 5, 25, 1.5 * FEED)
        self.check_speed(drawn, 50, 100, 0.6 * FEED)

    def hold_and_resume(self, board, host, way_mm):
        """Holds when this is drawn since the last resume."""
        while drawn_mm(board.port) < way_mm:
            time.sleep(0.05)
        self.wish("hold")
        self.wait_for_stand(board)
        self.wish("resume")
        return float(re.search(r"goes on --from (\d+\.\d+)mm", host.stderr.readline())[1])

    def wait_for_stand(self, board):
        """The host has seen it, too, some frames later."""
        while read(board.port, STATE) & HELD != HELD:
            time.sleep(0.05)
        time.sleep(0.5)

    def check_starts(self, steps, clock_hz):
        """The axes are at the whole feed 0.35 s behind each hold, and never off the path."""
        place, places, starts = [0, 0, 0], [], []
        for n, (clock, axis, way) in enumerate(steps):
            place[axis] += way
            x, y, _ = (count / STEPS_PER_MM for count in place)
            off = abs(math.hypot(x, y - RADIUS) - RADIUS)
            self.assertLess(off, 0.01 + 1 / STEPS_PER_MM, place)
            places.append((clock, x, y))
            if n > 0 and clock - steps[n - 1][0] > 0.05 * clock_hz:
                starts.append(n)
        for start in starts:
            begin = places[start][0] + 0.35 * clock_hz
            run = [row for row in places if begin <= row[0] < begin + 0.1 * clock_hz]
            way = sum(math.dist(a[1:], b[1:]) for a, b in zip(run[::40], run[40::40]))
            clocks = run[40 * ((len(run) - 1) // 40)][0] - run[0][0]
            self.assertGreater(way * clock_hz / clocks, 0.97 * FEED)
        return len(starts)

    def check_holds(self, build):
        self.part.write_text(HELD_PART, encoding="ascii")
        board = self.board(build)
        host = self.stream(board, "--control", self.wishes)
        begins = [self.hold_and_resume(board, host, way_mm) for way_mm in (DEPTH + 5, 10, 15)]
        self.assertEqual(self.end(host, 0), "")
        report = report_of(self.folder / "stream")
        length = report["planned"]["path_quanta"] / QUANTA_PER_MM
        self.assertAlmostEqual(length, DEPTH + 2 * math.pi * RADIUS, delta=0.001)
        steps = board.end()
        self.assertEqual(counts(steps), [0, 0, STEPS_PER_MM * DEPTH])
        self.assertEqual(self.check_starts(steps, report["board"]["clock_hz"]), len(begins))
        with open(self.folder / "board" / "outputs.csv", encoding="ascii") as file:
            spindle = [row[2] for row in csv.reader(file) if row[1] == "0"]
        self.assertEqual(spindle, ["1", "0"], "on through all holds")

    def test_does_not_lose_a_dwell_that_is_held(self):
        self.part.write_text(DWELLING_PART, encoding="ascii")
        board = self.board("engine")
        host = self.stream(board, "--control", self.wishes)
        while drawn_mm(board.port) < 20:
            time.sleep(0.05)
        self.wish("hold")
        self.wait_for_stand(board)
        self.wish("resume")
        self.assertEqual(self.end(host, 0), "", "by time alone")
        steps = [clock for clock, _, _ in board.end()]
        rest = steps[20 * STEPS_PER_MM] - steps[20 * STEPS_PER_MM - 1]
        clock_hz = report_of(self.folder / "stream")["board"]["clock_hz"]
        self.assertGreater(rest / clock_hz, DWELL)

    def test_goes_on_at_once_on_the_parallel_board(self):
        self.check_holds("parallel")

    def test_goes_on_at_once_on_the_engine(self):
        self.check_holds("engine")


if __name__ == "__main__":
    import sys
    del sys.argv[1]
    unittest.main()
