#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The program interpret.py: its lines, its limits, its messages.

Exit status 77: LinuxCNC is not installed, and nothing but the message of that was tested.
"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

INTERPRET = Path(__file__).resolve().parent.parent.parent / "sysc/linuxcnc/interpret.py"
INSTALLED = Path("/usr/share/linuxcnc/ncfiles").exists()


def interpret(text, *options, python=()):
    """Returns the lines of a program and the interpreter's exit status."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "part.ngc"
        file.write_text(text)
        done = subprocess.run([*python, INTERPRET, file, "--scratch", folder, *options],
                              capture_output=True, text=True)
        return [json.loads(line) for line in done.stdout.splitlines()], done.returncode


class Missing(unittest.TestCase):
    def test_package_that_is_missing_is_named(self):
        lines, _ = interpret("M2\n", python=("/usr/bin/python3", "-S"))  # without Debian's modules
        self.assertEqual([line["kind"] for line in lines], ["error"])
        self.assertIn("apt-get install --no-install-recommends linuxcnc-uspace ", lines[0]["text"])


@unittest.skipUnless(INSTALLED, "linuxcnc-uspace is not installed")
class Lines(unittest.TestCase):
    def of_kind(self, text, *kinds):
        lines, _ = interpret(text)
        self.assertEqual(lines[-1], {"kind": "end"})
        return [line for line in lines if line["kind"] in kinds]

    def feeds(self, text):
        return [line["feed"] for line in self.of_kind(text, "line", "arc", "nurbs")]

    def test_feeds(self):
        for text, feed in [("G1 X1 F60", 1), ("G20 G1 X1 F60", 25.4), ("G1 A5 F60", 1),
                           ("G20 G1 A5 F60", 1), ("G20 G1 A5 X1 F60", 25.4), ("G1 U5 F60", 1),
                           ("G93 G1 X3 F2", 0.1), ("S120 M3 G95 F2 G1 X1", 4),
                           ("S120 M3 G33 Z-3 K1.5", 3), ("G2 I5 F60", 1), ("G20 G2 I5 F60", 25.4)]:
            with self.subTest(text):
                self.assertAlmostEqual(self.feeds(f"{text}\nM2\n")[0], feed, places=12)

    def test_path_control(self):
        found = self.of_kind("G64 P0.1\nG61\nG61.1\nG20 G64 P0.1\nG64\nM2\n", "path")
        self.assertEqual([(line["mode"], round(line["tolerance"], 12)) for line in found[-5:]],
                         [("continuous", 0.1), ("exact path", 0), ("exact stop", 0),
                          ("continuous", 2.54), ("continuous", 0)])

    def test_stops_and_dwells(self):
        text = "G1 X1 F60\nM0\nG1 X2\nG4 P1.5\nM3 S100\nG1 X3\nM5\n"
        kinds = [line["kind"] for line in self.of_kind(text + "M2\n", "line", "stop", "dwell")]
        self.assertEqual(kinds[:7], ["line", "stop", "line", "dwell", "stop", "line", "stop"])

    def test_splines_are_native(self):
        found = self.of_kind("G20 G1 Z1 F60\nG5 I1 J2 P-1 Q2 X4 Y0\nM2\n", "nurbs")
        self.assertEqual(len(found), 1)
        self.assertEqual(found[0]["order"], 4)
        flat = [value / 25.4 for point in found[0]["points"] for value in point]
        for value, expected in zip(flat, [0, 0, 1, 1, 2, 1, 3, 2, 1, 4, 0, 1], strict=True):
            self.assertAlmostEqual(value, expected, places=12)

    def test_messages_keep_line_and_text(self):
        lines, _ = interpret("G1 X1 F60\nG1 X[1/0]\nM2\n")
        self.assertEqual(lines[-1]["kind"], "error")
        self.assertEqual(lines[-1]["line"], 2)
        self.assertIn("divide by zero", lines[-1]["text"])

    def test_programs_need_no_end(self):
        for text in ("G1 X1 F60", "%\nG1 X1 F60\n", "%\nG1 X1 F60\n%\nG1 X2\n",
                     "G1 X1 F60\nM2\nG1 X2\n"):
            with self.subTest(text):
                self.assertEqual(len(self.of_kind(text, "line")), 1)

    def test_tools_are_there_without_a_machine(self):
        found = self.of_kind("T12345 M6 G43\nT7 M6\nG43 H8\nF60 G1 Z1\n", "line", "warning")
        self.assertEqual([line["kind"] for line in found], ["line", "warning"])
        self.assertEqual(found[0]["to"][2], 1)
        self.assertIn("tools have a length of 0", found[1]["text"])

    def test_tool_table(self):
        with tempfile.NamedTemporaryFile("w", suffix=".tbl") as table:
            table.write("T3 P1 Z5\n")
            table.flush()
            lines, _ = interpret("T3 M6 G43\nF60 G1 Z1\nT4 M6\n", "--tools", table.name)
        self.assertEqual([line["to"][2] for line in lines if line["kind"] == "line"], [6])
        self.assertEqual(lines[-1]["kind"], "error")
        self.assertIn("tool 4 not found", lines[-1]["text"])

    def test_tolerance_behind_a_canned_cycle_is_that_before_it(self):
        found = self.of_kind("F60 G64 P0.05\nG81 X1 Z-1 R1\nG20\nX2\n", "path")
        self.assertEqual([round(line["tolerance"], 9) for line in found[-5:]],
                         [0.05, 0, 0.05, 0, 0.05])

    def test_endless_loop_is_stopped(self):
        loop = "O1 while [1]\n#1 = 2\nO1 endwhile\nM2\n"
        lines, status = interpret(loop, "--seconds", "1")
        self.assertNotIn("end", [line["kind"] for line in lines])
        self.assertEqual(status, -24)  # SIGXCPU

    def test_endless_motion_is_stopped(self):
        loop = "F60\nO1 while [1]\nG91 G1 X1\nO1 endwhile\nM2\n"
        lines, status = interpret(loop, "--moves", "100")
        self.assertEqual(lines[-1]["kind"], "error")
        self.assertIn("endless loop", lines[-1]["text"])
        self.assertEqual((len(lines), status), (101, 1))


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    sys.exit(77 if result.wasSuccessful() and not INSTALLED else not result.wasSuccessful())
