#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""python_test.py CURVECORE DATA [TESTS ..]: the package curvecore, found by PYTHONPATH or
installed, beside the program."""

import csv
import pathlib
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import curvecore
import numpy

CURVECORE, DATA = sys.argv[1], pathlib.Path(sys.argv[2])
PART = DATA / "demo.ngc"
SMALL = {"Order": 4, "CoefBits": 24, "PositionBits": 29}
OPTIONS = ["--set", "Order=4", "--set", "CoefBits=24", "--set", "PositionBits=29", "--unit", "10nm"]


def planned():
    return curvecore.plan(PART, set=SMALL, unit="10nm")


def is_seen_halfway(call):
    """Returns whether another thread runs while a call has a quarter to three quarters of its work
    behind it, by the processor time of its own thread: the load of the machine does not count."""
    done, seen_all = threading.Event(), threading.Event()

    def work():
        try:
            call()
        finally:
            done.set()
        seen_all.wait()

    thread = threading.Thread(target=work)
    thread.start()
    clock = time.pthread_getcpuclockid(thread.ident)
    seen = []
    while not done.is_set():
        seen.append(time.clock_gettime(clock))
        time.sleep(1e-3)
    whole = time.clock_gettime(clock)
    seen_all.set()
    thread.join()
    return any(whole / 4 < one < whole * 3 / 4 for one in seen)


class PythonTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def program(self, *arguments):
        subprocess.run([CURVECORE, *arguments, "-q", "-o", self.folder / "out"], check=True,
                       capture_output=True)
        return self.folder / "out"

    def test_draws_what_the_program_draws(self):
        drawn = planned().draw()
        out = self.program("run", PART, "--on", "kernel", *OPTIONS)
        with open(out / "samples.csv", encoding="ascii") as file:
            rows = [row for row in csv.reader(file) if row[0].isdigit()]
        self.assertGreater(len(rows), 10000)
        positions = numpy.array([[int(n) for n in row[3:6]] for row in rows])
        numpy.testing.assert_array_equal(drawn.position, positions)
        self.assertEqual(drawn.position.dtype, numpy.int64)
        rounded = (drawn.fine + 512) >> 10
        numpy.testing.assert_array_equal(rounded, drawn.position)
        self.assertAlmostEqual(drawn.position_mm[-1, 0], positions[-1, 0] * 1e-5)
        self.assertAlmostEqual(drawn.time_s[1], 1e-4)

    def test_words_are_those_of_the_program(self):
        part = planned()
        out = self.program("words", PART, *OPTIONS)
        for name, words in (("segments", part.segment_words), ("profile", part.profile_words)):
            lines = (out / f"{name}.hex").read_text().split("\n")
            hexes = [line.split("//")[0].strip() for line in lines]
            expected = [int(one, 16) for text in hexes for one in text.split()]
            self.assertEqual(words.tolist(), expected, name)
            self.assertGreater(len(expected), 1000)

    def test_a_plan_has_figures(self):
        part = planned()
        self.assertEqual(part.axes, 3)
        self.assertEqual(part.parameters["Order"], 4)
        self.assertEqual(part.unit_mm, 1e-5)
        segments = part.segments
        self.assertAlmostEqual(segments.length_mm.sum(), part.path_mm, places=6)
        self.assertEqual(segments.bound_units.max(), part.bound_units)
        self.assertEqual(set(segments.kind), {"line", "arc", "helix", "spline"})
        self.assertEqual(len(segments), len(segments.line))
        self.assertRegex(repr(part), r"<curvecore.Plan: \d+\.\d+ mm in \d")
        self.assertTrue(any("M3" in warning for warning in part.warnings))

    def test_refusals_have_their_place(self):
        bad = self.folder / "bad.ngc"
        bad.write_text("G21 G90 F600\nG1 X10\nG1 X#\n", encoding="ascii")
        with self.assertRaises(curvecore.InputError) as caught:
            curvecore.plan(bad)
        self.assertEqual(caught.exception.file, str(bad))
        self.assertEqual(caught.exception.line, 3)
        self.assertNotIn("error:", caught.exception.reason)
        for options, reason in (({"unit": "10"}, "--unit"), ({"set": {"Order": 13}}, "Order"),
                                ({"speed": 3}, "plan has no option '--speed'"),
                                ({"set": "Order=4"}, "set='Order=4': a dict is expected"),
                                ({"set": {"Order": (4, 6)}}, "--set Order=4,6: "),
                                ({"help": True}, "--help: curvecore COMMAND --help prints it"),
                                ({"output": "out"}, "--output: the answer is returned")):
            with self.subTest(options=options):
                with self.assertRaises(ValueError) as caught:
                    curvecore.plan(PART, **options)
                self.assertIn(reason, str(caught.exception))
        with self.assertRaises(curvecore.InputError):
            curvecore.compare(bad)
        with self.assertRaisesRegex(curvecore.InputError, "--output: the answer is returned"):
            curvecore.compare(PART, output="out")

    def test_widths_are_compared_and_chosen(self):
        found = curvecore.compare(DATA / "lines.ngc", device="up5k",
                                  set={"CoefBits": (24, 36), "Order": [6], "Mode": 0})
        self.assertEqual(len(found["rows"]), 2)
        self.assertEqual(found["answers"][0]["core"]["device"], "up5k")
        answer = curvecore.choose(error="1um", radius="300mm", feed="10m/min", device="up5k")
        self.assertTrue(answer["possible"])
        answer = curvecore.choose(error="1um", radius="300mm", feed="10m/min", device="up5k",
                                  sample_rate="1MHz")
        self.assertFalse(answer["possible"])

    def test_sources_are_there(self):
        files = curvecore.rtl_files()
        self.assertGreater(len(files), 80)
        for file in files:
            self.assertTrue(file.exists(), file)

    def test_flags_are_given_or_not(self):
        for flag, given in ((True, ["--laser"]), (numpy.bool_(True), ["--laser"]),
                            (False, []), (numpy.bool_(False), []), (None, [])):
            self.assertEqual(curvecore._arguments({"laser": flag}), given, repr(flag))

    def test_other_threads_run_meanwhile(self):
        part = curvecore.plan(PART, set=SMALL, unit="10nm", sample_period="10us")
        self.assertTrue(is_seen_halfway(part.draw))
        self.assertFalse(is_seen_halfway(lambda: sum(range(20_000_000))), "it keeps the others")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
