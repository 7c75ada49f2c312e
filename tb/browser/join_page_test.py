#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The page of `curvecore join` in a real browser: its mathematics is the program's, and what a user
does in it changes numbers, files and programs.

    join_page_test.py --program build/curvecore [--picture FILE.png]
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from chromium import Chromium

DATA = pathlib.Path(__file__).resolve().parents[1] / "data"
FITS = ("cubic", "moments", "c2", "quintic")
FORMS = {"exact": ["--exact"], "tolerance": ["--tolerance", "10um"], "step": ["--step", "0.3mm"]}
SIZES = {"tolerance": "0.01", "step": "0.3"}
OPTIONS = argparse.Namespace()


def numbers(value):
    """All numbers of a JSON value, or of words of G-code, in order."""
    if isinstance(value, str):
        return [float(n) for n in re.findall(r"-?\d+\.?\d*", value)]
    if isinstance(value, dict):
        return [n for item in value.values() for n in numbers(item)]
    return [n for item in value for n in numbers(item)] if isinstance(value, list) else [value]


def gap(a, b):
    """The largest difference, beside 1 where numbers are larger."""
    a, b = numbers(a), numbers(b)
    if len(a) != len(b):
        return float("inf")
    return max(abs(x - y) / max(1, abs(x)) for x, y in zip(a, b))


class JoinPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.join("out")
        cls.browser = Chromium()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.temporary.cleanup()

    @classmethod
    def curvecore(cls, *arguments):
        return subprocess.run([OPTIONS.program, *arguments], cwd=cls.folder, text=True,
                              capture_output=True)

    @classmethod
    def join(cls, out, *options, programs=("pass_1.ngc", "pass_2.ngc")):
        done = cls.curvecore("join", *[str(DATA / name) for name in programs], "-o", out, "--on",
                             "kernel", "-q", *options)
        if done.returncode:
            raise AssertionError(done.stderr)
        return json.loads((cls.folder / out / "join.json").read_text())

    def setUp(self):
        self.open(self.folder / "out/join.html")

    def tearDown(self):
        self.assertEqual(self.browser.errors(), [])
        self.assertEqual(self.browser.addresses(), [], "the page wants the network")

    def open(self, page):
        self.browser.open(page)
        plane = self.browser.get("""(() => {
            const b = document.querySelector("#plane").getBoundingClientRect();
            return [b.x, b.y];
        })()""")
        self.on_screen = lambda at: [plane[0] + at[0], plane[1] + at[1]]

    def result(self):
        return json.loads(self.browser.get("jsonText()"))["result"]

    def points(self):
        return self.browser.get("move.points")

    def test_numbers_and_g_code_are_the_programs(self):
        cases = [(fit, "exact") for fit in FITS]
        cases += [("c2", "tolerance"), ("quintic", "tolerance"), ("quintic", "step")]
        for programs in (("pass_1.ngc", "pass_2.ngc"), ("pass_1.ngc", "pass_3.ngc")):
            for fit, form in cases:
                file = self.join("each", "--fit", fit, *FORMS[form], programs=programs)
                if (fit, form) == cases[0]:
                    self.open(self.folder / "each/join.html")
                self.browser.choose("#fit", fit)
                self.browser.choose("#form", form)
                if form in SIZES:
                    self.browser.type("#size", SIZES[form])
                self.assertLessEqual(gap(file["result"], self.result()), 1e-9, (fit, form))
                program = (self.folder / "each/join.ngc").read_text()
                self.assertLessEqual(gap(program, self.browser.get("gcodeText()")), 2e-9)

    def test_a_wrong_formula_is_told_from_the_right_one(self):
        page = (self.folder / "out/join.html").read_text()
        for right, wrong in (("h * h / 20, second0", "h * h / 21, second0"),
                             ("minus(y1, times(1 / 3, into))", "minus(y1, times(1 / 4, into))"),
                             ("36, 9 * h, 24, -3 * h", "36, 9 * h, 25, -3 * h"),
                             ("GRAVITY = 9806.65", "GRAVITY = 9810")):
            self.assertIn(right, page)
            (self.folder / "wrong.html").write_text(page.replace(right, wrong))
            self.open(self.folder / "wrong.html")
            file = json.loads((self.folder / "out/join.json").read_text())
            self.assertGreater(gap(file["result"], self.result()), 1e-6, right)

    def test_a_dragged_point_moves_and_everything_with_it(self):
        before, charts = self.result(), self.browser.get(
            '["slope", "second", "curvature", "acceleration"].map((c) => byId(c).toDataURL())')
        point = self.points()[1]
        at = self.browser.get("toScreen(move.points[1])")
        scale = self.browser.get("view.scale")
        self.browser.drag(self.on_screen(at), self.on_screen([at[0] + 40, at[1] - 25]))
        moved = self.points()[1]
        self.assertAlmostEqual(moved[0] - point[0], 40 / scale, delta=0.01)
        self.assertAlmostEqual(moved[1] - point[1], 25 / scale, delta=0.01)
        self.assertEqual(moved[2], point[2])
        self.assertGreater(gap(before, self.result()), 1e-3)
        shown = float(self.browser.get('byId("point2x").value'))
        self.assertAlmostEqual(shown, moved[0], delta=1e-6)
        for chart, old in zip(("slope", "second", "curvature", "acceleration"), charts):
            self.assertNotEqual(self.browser.get(f'byId("{chart}").toDataURL()'), old, chart)

    def test_an_arrow_keeps_to_its_axis(self):
        for axis in (0, 1):
            point = self.points()[0]
            tip = self.browser.get(f"arrowTips()[{axis}]")
            self.browser.drag(self.on_screen(tip), self.on_screen([tip[0] + 30, tip[1] + 30]))
            moved = self.points()[0]
            self.assertGreater(abs(moved[axis] - point[axis]), 0.05)
            self.assertEqual(moved[1 - axis], point[1 - axis])

    def test_a_typed_point_is_exported_and_runs(self):
        self.browser.type("#point1y", "7.25")
        self.browser.type("#point3x", "nonsense")
        self.assertEqual(self.points()[0][1], 7.25)
        own = self.result()
        for form in FORMS:
            self.browser.choose("#form", form)
            program = self.browser.download("#export", "join.ngc")
            if form != "step":
                self.assertIn("Y7.25", program.read_text())
            done = self.curvecore("run", str(program), "-o", "ran")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        # The program finds the same numbers in the saved file.
        saved = self.browser.download("#save", "join.json")
        loaded = self.join("again", "--load", str(saved))
        self.assertLessEqual(gap(loaded["result"], own), 1e-9)
        self.assertEqual(loaded["points"], self.points())

    def test_least_points_are_the_programs(self):
        for fit, least in (("c2", "curvature"), ("c2", "jerk"), ("quintic", "jerk")):
            file = self.join("least", "--fit", fit, "--least", least)
            self.browser.click("#reset")
            self.browser.choose("#fit", fit)
            self.assertGreater(gap(file["points"], self.points()), 1e-3)
            self.browser.click(f"#least_{least}")
            self.assertLessEqual(gap(file["points"], self.points()), 1e-7, (fit, least))

    def test_saved_is_loaded_and_another_version_is_not(self):
        self.browser.click("#add")
        self.browser.type("#point2z", "1.5")
        self.browser.choose("#fit", "c2")
        points, own = self.points(), self.result()
        self.assertEqual(len(points), 4)
        saved = self.browser.download("#save", "join.json")
        self.browser.click("#reset")
        self.assertEqual(len(self.points()), 3)
        self.browser.upload("#file", saved)
        self.browser.get("new Promise((done) => setTimeout(done, 200))")
        self.assertEqual(self.points(), points)
        self.assertEqual(self.result(), own)
        other = json.loads(saved.read_text())
        other["curvecore_join"] = 2
        other["points"] = []
        (self.folder / "other.json").write_text(json.dumps(other))
        self.browser.upload("#file", self.folder / "other.json")
        self.browser.get("new Promise((done) => setTimeout(done, 200))")
        self.assertIn("version 2", self.browser.get('byId("message").textContent'))
        self.assertEqual(self.points(), points)

    def test_a_picture(self):
        if OPTIONS.picture:
            self.browser.picture(OPTIONS.picture)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", type=pathlib.Path, required=True)
    parser.add_argument("--picture", type=pathlib.Path)
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.program = OPTIONS.program.resolve()
    unittest.main(argv=[sys.argv[0], *rest], verbosity=2)
