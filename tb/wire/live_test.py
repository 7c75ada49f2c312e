# SPDX-License-Identifier: Apache-2.0
"""An override above 100 % while a program is drawn: another plan from the first open move on."""

import time
import unittest

from wire_parts import QUANTA_PER_MM, STEPS_PER_MM, WishTest, counts, read, report_of

PATH_LO, PATH_HI = 0x60, 0x64
FEED = 20  # mm/s
LENGTH = 110  # mm


class LiveTest(WishTest):
    part_text = f"G21 G90\nG1 X{LENGTH} F{60 * FEED}\nM2\n"

    def drawn_mm(self, board):
        low = read(board.port, PATH_LO)
        return (low | read(board.port, PATH_HI) << 32) / QUANTA_PER_MM

    def draw(self, build, wishes, *options):
        """Draws the part; each wish comes when so many mm are drawn.  Returns the clock in which
        each step came, and the clocks of a second."""
        board = self.board(build)
        host = self.stream(board, "--control", self.wishes, *options)
        for drawn_mm, wish in wishes:
            while self.drawn_mm(board) < drawn_mm:
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


if __name__ == "__main__":
    import sys
    del sys.argv[1]
    unittest.main()
