# SPDX-License-Identifier: Apache-2.0
"""The rest of a program, after a host that is gone: from where the axes stand, on the same path."""

import csv
import math
import pathlib
import re
import subprocess
import tempfile
import unittest

from wire_parts import CURVECORE, STEPS_PER_MM, Board, Wire, counts, report_of

# 20 mm along X, a quarter turn around (20, 20), 20 mm along Y, with corners that are rounded.
PART = "G21 G90 G64 P0.01\nM3 S500\nG1 X20 F{}\nG3 X40 Y20 I0 J20\nG1 Y40\nX30\nM2\n"
# mm/min. At the slow one a fast board, for which 64 frames under way are 0.32 s, goes some 6 mm on
# when its wire is closed, however busy the computer is, and 5 mm until the watchdog has stopped it.
FEED, SLOW_FEED = 2400, 1200
END = (30, 40, 0)
LENGTH = 20 + 10 * math.pi + 20 + 10


def off_path(x, y):
    """Distance from PART's path, mm."""
    line = math.hypot(x - min(max(x, 0), 20), y)
    arc = abs(math.hypot(x - 20, y - 20) - 20) if x >= 20 and y <= 20 else math.inf
    up = math.hypot(x - 40, y - min(max(y, 20), 40))
    back = math.hypot(x - min(max(x, 30), 40), y - 40)
    return min(line, arc, up, back)


class RestTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.part = self.folder / "part.ngc"
        self.write(FEED)

    def write(self, feed):
        self.part.write_text(PART.format(feed), encoding="ascii")

    def stream(self, port, *options):
        return subprocess.Popen(
            [CURVECORE, "stream", self.part, "--to", f"udp:127.0.0.1:{port}", "-o",
             self.folder / "stream", "--watchdog", "200ms", *options],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def leave(self, board, mm, *options):
        """Streams until so much of it is drawn, more than of the one before, and is gone then:
        what it said."""
        wire = Wire(board.port, gate_mm=mm)
        host = self.stream(wire.port, *options)
        wire.wait_for_gate()
        host.kill()
        return host.communicate()[1]

    def end(self, host, status):
        message = host.communicate()[1]
        self.assertEqual(host.returncode, status, message)
        return message

    def check_path(self, steps):
        place = [0, 0, 0]
        for _, axis, way in steps:
            place[axis] += way
            off = off_path(*(n / STEPS_PER_MM for n in place[:2]))
            self.assertLess(off, 0.01 + 1 / STEPS_PER_MM, place)
        self.assertEqual(counts(steps), [STEPS_PER_MM * mm for mm in END])

    def test_is_drawn_from_where_the_axes_stand(self):
        self.write(SLOW_FEED)
        board = Board(str(self.folder / "board"), "--fast", "--build", "parallel")
        self.addCleanup(board.kill)
        self.leave(board, 10)
        said = self.leave(board, 25, "--rest", "--override", "99")
        begin = re.search(r"rest --from (\d+\.\d+)mm", said)[1]
        self.assertGreaterEqual(float(begin), 10)
        self.assertIn("which has to be of the same options, the --from of a rest included",
                      self.end(self.stream(board.port, "--rest"), 2))
        self.end(self.stream(board.port, "--rest", "--from", f"{begin}mm", "--override", "80"), 0)
        left = report_of(self.folder / "stream")["drawn"]["path_quanta"] / 65536e6
        self.assertLess(left, LENGTH - float(begin) - 25)
        self.check_path(board.end())
        with open(self.folder / "board" / "outputs.csv", encoding="ascii") as file:
            spindle = [row[2] for row in csv.reader(file) if row[1] == "0"]
        self.assertEqual(spindle, 3 * ["1", "0"], "on in each part, off behind it")

    def test_is_drawn_by_the_engine(self):
        board = Board(str(self.folder / "board"), "--fast")
        self.addCleanup(board.kill)
        self.leave(board, 30)
        self.end(self.stream(board.port, "--rest"), 0)
        self.check_path(board.end())

    def test_of_nothing_is_refused(self):
        board = Board(str(self.folder / "board"), "--fast")
        self.addCleanup(board.kill)
        self.assertIn("no program under way", self.end(self.stream(board.port, "--rest"), 2))
        self.end(self.stream(board.port), 0)
        self.assertIn("no program under way", self.end(self.stream(board.port, "--rest"), 2))
        self.check_path(board.end())

    def test_host_says_where_the_machine_was(self):
        self.write(SLOW_FEED)
        board = Board(str(self.folder / "board"), "--fast", "--build", "parallel")
        wire = Wire(board.port, gate_mm=30)
        host = self.stream(wire.port)
        wire.wait_for_gate()
        board.kill()
        wire.open_gate()
        self.assertRegex(self.end(host, 1),
                         r"it was 3\d\.\d{3} mm along the path, line 4; .*--rest")

    def run_part(self, *options):
        return subprocess.run(
            [CURVECORE, "run", self.part, "--on", "kernel", "-q", "-o", self.folder / "run",
             *options], stderr=subprocess.PIPE, text=True, check=False)

    def test_of_a_path_begins_on_it(self):
        for from_mm in (0, 5, 20, 33.3, 60, LENGTH - 0.5):
            with self.subTest(from_mm=from_mm):
                ran = self.run_part("--from", f"{from_mm}mm")
                self.assertEqual(ran.returncode, 0, ran.stderr)
                with open(self.folder / "run" / "samples.csv", encoding="ascii") as file:
                    rows = [[int(n) * 1e-6 for n in row[3:5]] for row in csv.reader(
                        line for line in file if line[0].isdigit())]
                self.assertEqual(rows[-1], [30, 40])
                self.assertLess(max(off_path(*row) for row in rows), 0.01 + 1e-6)
                # Corners are rounded: the path is a little shorter than the program.
                way = sum(map(math.dist, rows, rows[1:]))
                self.assertAlmostEqual(way, LENGTH - from_mm, delta=0.05)

    def test_behind_the_end_is_refused(self):
        ran = self.run_part("--from", "90mm")
        self.assertEqual(ran.returncode, 2)
        self.assertIn("nothing is left from 90.000000 mm on", ran.stderr)


if __name__ == "__main__":
    import sys
    del sys.argv[1]
    unittest.main()
