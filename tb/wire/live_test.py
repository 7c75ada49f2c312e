# SPDX-License-Identifier: Apache-2.0
"""An override above 100 % while a program is drawn: another plan from the first open move on."""

import pathlib
import subprocess
import tempfile
import unittest

from wire_parts import CURVECORE, QUANTA_PER_MM, STEPS_PER_MM, Board, counts, read, report_of, until

PATH_LO, PATH_HI = 0x60, 0x64
FEED = 20  # mm/s
LENGTH = 110  # mm


class LiveTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.part = self.folder / "part.ngc"
        self.part.write_text(f"G21 G90\nG1 X{LENGTH} F{60 * FEED}\nM2\n", encoding="ascii")
        self.wishes = self.folder / "wishes"
        self.wishes.touch()

    def wish(self, text):
        with open(self.wishes, "a", encoding="ascii") as file:
            file.write(text + "\n")

    def draw(self, build, wishes, *options):
        """Draws the part; each wish comes when so many mm are drawn.  Returns the clock in which
        each step came, and the clocks of a second."""
        board = Board(str(self.folder / "board"), "--fast", "--build", build)
        self.addCleanup(board.kill)
        host = subprocess.Popen(
            [CURVECORE, "stream", self.part, "--to", f"udp:127.0.0.1:{board.port}", "-o",
             self.folder / "stream", "--control", self.wishes, *options],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        for drawn_mm, wish in wishes:
            def drawn(at=drawn_mm):
                low = read(board.port, PATH_LO)
                return (low | read(board.port, PATH_HI) << 32) / QUANTA_PER_MM >= at
            until(drawn)
            self.wish(wish)
        message = host.communicate()[1]
        self.assertEqual(host.returncode, 0, message)
        self.assertEqual(message, "")
        steps = board.end()
        self.assertEqual(counts(steps), [LENGTH * STEPS_PER_MM, 0, 0])
        return ([clock for clock, _, _ in steps],
                report_of(self.folder / "stream")["board"]["clock_hz"])

    def check_speed(self, drawn, begin, end, speed):
        steps, clock_hz = drawn
        clocks = steps[end * STEPS_PER_MM] - steps[begin * STEPS_PER_MM]
        self.assertAlmostEqual((end - begin) * clock_hz / clocks / speed, 1, delta=0.01)

    def test_is_raised_and_lowered(self):
        for build in ("parallel", "engine"):
            with self.subTest(build=build):
                self.wishes.write_text("", encoding="ascii")
                drawn = self.draw(build, [(5, "override 150"), (72, "override 100")])
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
