#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The pages of all commands in a real browser, on a desk and on a phone: nothing is wider than the
screen, no script fails, nothing comes from the network, and one cursor goes through a report.

    pages_test.py --program build/curvecore [--pictures FOLDER]
"""

import json
import pathlib
import re
import shlex
import subprocess
import tempfile
import unittest

from chromium import OPTIONS, Chromium, run_tests

DATA = pathlib.Path(__file__).resolve().parents[1] / "data"
WIDTHS = (1280, 390)
QUICK = ["--on", "kernel", "--sample-period", "1ms", "-q"]
PAGES = {
    "report": (["run", DATA / "splines.ngc", *QUICK], "report.html"),
    "plan": (["plan", DATA / "helix.ngc", "--sample-period", "1ms", "-q"], "report.html"),
    "compare": (["compare", DATA / "arcs.ngc", "--set", "Order=4,6", "--set", "CoefBits=24,36",
                 "--build", "serial", "--samples", "2000", "-q"], "report.html"),
    "cam": (["cam", DATA / "cam.csv", "--kappa", "1", "--feed", "6m/min", *QUICK], "cam.html"),
    "explore": (["explore", DATA / "pulses.ngc", "--host", "1ms,5ms", "--word", "2us", "-q"],
                "explore.html"),
    "join": (["join", DATA / "pass_1.ngc", DATA / "pass_2.ngc", *QUICK], "join.html"),
}


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        part = cls.folder / "outputs.ngc"
        part.write_text("G61 F3000\nG1 X10\nM3 S500\nG1 X20\nM8 S1000\nG1 X30\nM5\nG1 X40\nM2\n",
                        encoding="ascii")
        PAGES["outputs"] = (["run", part, *QUICK], "report.html")
        for name, (arguments, _) in PAGES.items():
            subprocess.run([OPTIONS.program, *arguments, "-o", cls.folder / name], check=True)
        cls.browser = Chromium()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.temporary.cleanup()

    def open(self, name, width):
        self.browser.send("Emulation.setDeviceMetricsOverride", width=width, height=900,
                          deviceScaleFactor=1, mobile=width < 600)
        self.browser.open(self.folder / name / PAGES[name][1])

    def tearDown(self):
        self.assertEqual(self.browser.errors(), [])
        self.assertEqual(self.browser.addresses(), [], "a page wants the network")

    def test_nothing_is_wider_than_the_screen(self):
        for name in PAGES:
            for width in WIDTHS:
                with self.subTest(page=name, width=width):
                    self.open(name, width)
                    self.assertEqual(self.browser.get("innerWidth"), width)
                    self.assertEqual(self.browser.wider_than(width), [])
                    self.picture(name, width)

    def test_the_figure_of_width_sees_what_is_wider(self):
        self.open("report", 390)
        self.browser.get('byId("title").style.minWidth = "500px"')
        self.assertIn("H1#title.", self.browser.wider_than(390))

    def test_a_cursor_in_a_chart_is_a_line_of_the_program(self):
        self.open("report", 1280)
        self.assertEqual(self.browser.get('byId("place").textContent'), "")
        x, y = self.browser.middle("#speed")
        self.browser.mouse("mouseMoved", x, y)
        point = self.browser.get("marked")
        self.assertGreater(point, 0)
        shown = self.browser.get('byId("place").textContent')
        self.assertTrue(shown.startswith(f"line {self.browser.get('D.line[marked]')}:"), shown)
        time = self.browser.get("D.t[marked] / D.duration_s")
        self.assertAlmostEqual(time, 0.5, delta=0.1)

    def test_a_strip_shows_outputs_along_the_path(self):
        # Off, on from 10 mm of 40 to 30, S half and whole.
        self.open("outputs", 1280)
        rows = self.browser.get("charts.outputs.rows.map((row) => [row.name, row.values])")
        self.assertEqual([name for name, _ in rows], ["power", "spindle, laser", "flood"])
        on = {name: [n / len(values) for n, v in enumerate(values) if v] for name, values in rows}
        for name, low, high in (("power", 0.25, 0.75), ("spindle, laser", 0.25, 0.75),
                                ("flood", 0.5, 1)):
            with self.subTest(name=name):
                self.assertAlmostEqual(on[name][0], low, delta=0.002)
                self.assertAlmostEqual(on[name][-1], high, delta=0.002)
        values = rows[0][1]
        self.assertEqual([values[int(f * len(values))] for f in (0.1, 0.4, 0.6, 0.9)],
                         [0, 0.5, 1, 0])
        self.open("report", 1280)
        self.assertIsNone(self.browser.get('byId("outputsCard")'))

    def test_the_error_to_keep_is_a_line_of_the_figure_that_it_is_of(self):
        self.open("compare", 1280)
        lines = """["width", "cost"].map((id) => [...byId(id).querySelectorAll("text")]
                     .filter((t) => t.textContent === "the error to keep: 0.6").length)"""
        self.assertEqual(self.browser.get(lines), [1, 1])
        self.browser.choose("#figure", "2")
        self.assertEqual(self.browser.get(lines), [0, 0])

    def test_an_answer_is_copied_as_it_is_used(self):
        self.open("compare", 1280)
        forms = dict(self.browser.get("forms(D.answers[0].core)"))
        self.assertEqual(list(forms), ["Command", "core.json", "SystemVerilog"])
        for n, (what, text) in enumerate(forms.items()):
            self.browser.click(f"#answerCard button:nth-of-type({n + 1})")
            self.assertEqual(self.browser.get('document.querySelector("pre").textContent'), text)
            self.assertIn(what, self.browser.get(
                f"document.querySelectorAll('#answerCard button')[{n}].textContent"))
        (self.folder / "core.json").write_text(forms["core.json"], encoding="ascii")
        program, *words = shlex.split(forms["Command"])
        self.assertEqual(program, "curvecore")
        written = [json.loads(subprocess.run(
            [OPTIONS.program, *command, "--json", "-o", self.folder / "again"], cwd=DATA,
            check=True, capture_output=True).stdout)["parameters"]
            for command in (words, ["plan", "arcs.ngc", "--core", self.folder / "core.json"])]
        self.assertEqual(*written)

        def parameters(file):
            return re.findall(r"^ *parameter (?:int )?(\w+)",
                              (DATA.parents[1] / "rtl" / file).read_text(), re.M)

        serial = re.findall(r"\.(\w+)\(\d+\)", forms["SystemVerilog"])
        self.assertEqual(set(serial), set(parameters("curve_interpolator_serial.sv")))
        for build, value in (("parallel", "0"), ("engine", "2")):
            forms = dict(self.browser.get(f"forms({{...D.answers[0].core, build: '{build}'}})"))
            given = dict(re.findall(r"\.(\w+)\((\d+)\)", forms["SystemVerilog"]))
            self.assertLessEqual(set(given), set(parameters("motion_interpolator.sv")))
            self.assertEqual(dict(re.findall(r"--([A-Z]\w+) (\d+)", forms["FuseSoC"])), given)
            self.assertEqual((given["Build"], given["Order"]), (value, "4"))

    def test_a_flat_part_has_one_view(self):
        self.open("report", 1280)
        spans = self.browser.get('["x", "y", "z"].map((a) => box[a][1] - box[a][0])')
        views = self.browser.get('document.querySelectorAll(".view").length')
        self.assertEqual(views, 3 if all(spans) else 1)

    def picture(self, name, width):
        if OPTIONS.pictures:
            height = self.browser.get("document.documentElement.scrollHeight")
            self.browser.send("Emulation.setDeviceMetricsOverride", width=width, height=height,
                              deviceScaleFactor=1, mobile=width < 600)
            self.browser.get("new Promise((done) => setTimeout(done, 300))")
            self.browser.picture(OPTIONS.pictures / f"{name}_{width}.png")


if __name__ == "__main__":
    run_tests(__doc__.split("\n")[0])
