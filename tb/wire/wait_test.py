# SPDX-License-Identifier: Apache-2.0
"""Programs that wait for a person: the axes stand, and what is asked for behind comes behind."""

import csv
import re
import unittest

from wire_parts import STEPS_PER_MM, WishTest, counts, report_of

# A wait at 0, at 20 mm behind a dwell with another one behind it, two at 30 mm, none at the end.
PART = """G21 G90 G64 P0.01
M8
T1 M6
M3 S500
G4 P0.1
G1 X20 F2400
M5
G4 P0.2
T2 M6
M3
G4 P0.3
G1 Y10
M0
M9
M60
X10
M0
M2
"""
WAITS = [(3, "0.000", "M6 T1"), (9, "20.000", "M6 T2"), (13, "30.000", "M0"),
         (15, "30.000", "M60")]
END = (10, 10, 0)
SPINDLE, FLOOD = "0", "3"  # in outputs.csv
MESSAGE = re.compile(r"part\.ngc:(\d+): waits at (\d+\.\d+) mm: (.*); resume goes on\n")


class WaitTest(WishTest):
    part_text = PART

    def see_waits(self, host, waits):
        """Resumes at each wait, once it is said."""
        for wait in waits:
            said = MESSAGE.search(host.stderr.readline())
            self.assertEqual((int(said[1]), said[2], said[3]), wait)
            self.wish("resume")

    def switched(self, output):
        """Changes of an output: the clock, and the level from there on."""
        with open(self.folder / "board" / "outputs.csv", encoding="ascii") as file:
            return [(int(clock), level) for clock, number, level in list(csv.reader(file))[1:]
                    if number == output]

    def check(self, build):
        board = self.board(build)
        host = self.stream(board, "--control", self.wishes)
        self.see_waits(host, WAITS)
        self.assertEqual(self.end(host, 0), "")
        report = report_of(self.folder / "stream")
        clock_hz = report["board"]["clock_hz"]
        self.assertEqual((report["end"], report["drawn"]["waits_mm"]), ("drawn", []))
        steps = board.end()
        self.assertEqual(counts(steps), [STEPS_PER_MM * mm for mm in END])
        first_y = next(clock for clock, axis, _ in steps if axis == 1)
        last_x = max(clock for clock, axis, _ in steps if axis == 0 and clock < first_y)
        back_x = next(clock for clock, axis, way in steps if axis == 0 and way < 0)
        spindle = self.switched(SPINDLE)
        self.assertEqual([level for _, level in spindle], ["1", "0", "1", "0"])
        (on, _), (off, _), (again, _), _ = spindle
        self.assertGreater(steps[0][0] - on, 0.1 * clock_hz, "the dwell is behind M3")
        self.assertGreater(again - off, 0.2 * clock_hz, "the dwell is before the wait")
        self.assertLess(abs(off - last_x), 0.01 * clock_hz)
        self.assertGreater(first_y - again, 0.3 * clock_hz, "the dwell is behind the wait")
        flood = self.switched(FLOOD)
        self.assertEqual([level for _, level in flood], ["1", "0"])
        self.assertLess(flood[0][0], on, "M8 is before the first wait")
        self.assertLess(flood[1][0], back_x, "M9 is between the waits")

    def test_waits_and_goes_on_in_the_parallel_build(self):
        self.check("parallel")

    def test_waits_and_goes_on_with_the_engine(self):
        self.check("engine")

    def test_stands_until_it_is_resumed(self):
        board = self.board("parallel")
        host = self.stream(board, "--control", self.wishes)
        self.see_waits(host, WAITS[:1])
        host.stderr.readline()
        self.wish("hold")
        self.wish("override 50")
        self.wish("stop")
        self.end(host, 130)
        self.assertEqual(report_of(self.folder / "stream")["end"], "stopped")
        self.assertEqual(counts(board.end()), [20 * STEPS_PER_MM, 0, 0])

    def test_waits_again_for_the_next_host(self):
        board = self.board("engine")
        host = self.stream(board, "--control", self.wishes)
        self.see_waits(host, WAITS[:1])
        host.stderr.readline()
        host.kill()
        host.communicate()
        self.wishes.write_text("", encoding="ascii")
        host = self.stream(board, "--control", self.wishes, "--rest", "-q")
        self.see_waits(host, [(9, "0.000", "M6 T2"), (13, "10.000", "M0"), (15, "10.000", "M60")])
        self.assertEqual(self.end(host, 0), "")
        self.assertEqual(counts(board.end()), [STEPS_PER_MM * mm for mm in END])

    def test_is_refused_where_nobody_is_heard(self):
        board = self.board("parallel")
        self.assertIn("part.ngc:3: error: the program waits for a person here",
                      self.end(self.stream(board), 2))
        self.assertIn("nobody can say resume, so it stops",
                      self.end(self.stream(board, "--from", "10mm"), 130))
        self.part.write_text("G1 X1 F600\nM0\nM2\n", encoding="ascii")
        self.end(self.stream(board), 0)
        board.end()


if __name__ == "__main__":
    import sys
    del sys.argv[1]
    unittest.main()
