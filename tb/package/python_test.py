#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""python_test.py CURVECORE DATA [TESTS ..]: the package curvecore, found by PYTHONPATH or
installed, beside the program."""

import csv
import os
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

    def test_curves_are_checked(self):
        start = {"T": (1, 0, 0), "N": (0, 1, 0), "kappa": (0.05, 0.05, 0.05), "sigma": 0.001}
        checked = curvecore.curve.check("clothoid", set={"CoefBits": 30})
        self.assertEqual((checked.name, checked.bound_units, checked.beyond),
                         ("clothoid", None, []))
        x = next(row for row in checked.rows if row.name == "x[k]")
        self.assertEqual((x.fraction_bits, x.range, x.orders, x.largest), (28, 2, 6, None))
        self.assertGreater(checked.engine.step_clocks, 100)
        steps = {"step_exponent": 22, "steps": 4}
        bounds = [curvecore.curve.check("clothoid", start, set={"CoefBits": bits}, **steps)
                  for bits in (24, 30)]
        self.assertGreater(bounds[0].bound_units, 4 * bounds[1].bound_units)
        self.assertGreater(bounds[1].bound_units, 0)
        said = subprocess.run([CURVECORE, "curve", "check", "clothoid", "--row", "T=1,0,0", "--row",
                               "N=0,1,0", "--row", "kappa=0.05,0.05,0.05", "--row", "sigma=0.001",
                               "--set", "CoefBits=30", "--step-exponent", "22", "--steps", "4"],
                              check=True, capture_output=True, text=True).stdout
        self.assertIn(f"\nerror: {bounds[1].bound_units:.4g} length units at most", said)
        self.assertIn(f"; parameter Table={checked.table}\n", said)
        beyond = curvecore.curve.check("clothoid", {**start, "kappa": (5, 5, 5)}, **steps)
        self.assertIsNone(beyond.bound_units)
        self.assertTrue(beyond.beyond)
        with self.assertRaisesRegex(curvecore.InputError, "kappa=..: clothoid needs its value"):
            curvecore.curve.check("clothoid", row={"T": (1, 0, 0)})
        with self.assertRaisesRegex(curvecore.InputError, "FILE 'no_such': it is FILE.net, or one"):
            curvecore.curve.check("no_such")

    def test_curves_are_drawn_and_derived(self):
        wave = {"x": "20*t", "y": "8*sin(w*t)", "let": {"w": 2}, "t": (0, 3)}
        options = {"set": {"Order": 4}, "unit": "10um", "sample_period": "1ms", "feed": "2m/min"}
        drawn = curvecore.curve.run("wave", **wave, **options)
        self.assertTrue(drawn.held)
        self.assertEqual(len(drawn.position), drawn.report["samples"] + 1)
        x, y, z = drawn.position_mm.T
        numpy.testing.assert_allclose(y, 8 * numpy.sin(x / 10), atol=0.02)
        self.assertEqual((x[0], abs(z).max()), (0, 0))
        self.assertAlmostEqual(x[-1], 60, delta=0.02)

        table = self.folder / "wave.net"
        lines = curvecore.curve.derive(table, **wave)
        self.assertIn("curve wave", table.read_text())
        part = self.folder / "part.ngc"
        part.write_text(f"G21 G90 F2000\n{lines}M2\n", encoding="ascii")
        again = curvecore.plan(part, curve=table, build="engine", **{**options, "feed": None})
        self.assertIn("wave", again.segments.kind)
        numpy.testing.assert_allclose(again.draw().position_mm[-1], drawn.position_mm[-1],
                                      atol=0.02)
        with self.assertRaisesRegex(curvecore.InputError, "--x --y: the formulas say the rows"):
            curvecore.curve.run("wave", row={"T": (1, 0, 0)}, **wave)
        with self.assertRaisesRegex(curvecore.InputError, "it is there, and not of these formulas"):
            curvecore.curve.derive(table, **{**wave, "y": "7*sin(w*t)"})

    def test_defaults_of_a_folder_are_for_the_program_alone(self):
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        pathlib.Path("curvecore.toml").write_text("unti = 1\n", encoding="ascii")
        self.assertEqual(curvecore.curve.check("clothoid").name, "clothoid")
        self.assertIn("lean", curvecore.curve.derive("lean.net", x="t", y="t*t", t=(0, 1)))

    def test_sources_are_there(self):
        files = curvecore.rtl_files()
        self.assertGreater(len(files), 80)
        for file in files:
            self.assertTrue(file.exists(), file)

    def test_flags_are_given_or_not(self):
        for flag, given in ((True, ["--laser"]), (numpy.bool_(True), ["--laser"]),
                            (False, []), (numpy.bool_(False), []), (None, [])):
            self.assertEqual(curvecore._program.arguments({"laser": flag}), given, repr(flag))

    def test_other_threads_run_meanwhile(self):
        part = curvecore.plan(PART, set=SMALL, unit="10nm", sample_period="10us")
        self.assertTrue(is_seen_halfway(part.draw))
        self.assertFalse(is_seen_halfway(lambda: sum(range(20_000_000))), "it keeps the others")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
