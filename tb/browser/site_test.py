#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The site: its links, its positions beside those of the program, and its demo in a real browser,
on a desk and on a phone.

    site_test.py --program build/curvecore [--pictures FOLDER]
"""

import os
import pathlib
import subprocess
import tempfile
import time
import unittest

from chromium import OPTIONS, Chromium, run_tests

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "tb/data"
SITE = ROOT / "build/site"
WIDTHS = (1280, 390)
QUICK = ["--on", "kernel", "--holds", "bounds"]
WAIT = 120  # s, for a part in the browser


def positions(file):
    """Columns of a samples.csv behind the path length."""
    lines = file.read_text().split("\n")
    return [line.split(",")[3:] for line in lines if line and not line.startswith("#")]


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        subprocess.run([ROOT / "scripts/site.sh"], check=True,  # which checks all links, too
                       env={**os.environ, "CURVECORE_PROGRAM": str(OPTIONS.program)})
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.browser = Chromium()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.temporary.cleanup()

    def drawn_by_wasm(self, part, options):
        samples = self.folder / "wasm.csv"
        said = subprocess.run(["node", ROOT / "tb/browser/wasm_samples.js",
                               SITE / "wasm/curvecore.js", part, " ".join(options), samples],
                              check=True, capture_output=True, text=True).stdout
        return said.strip(), samples

    def test_positions_are_those_of_the_program(self):
        for part in ("splines.ngc", "arcs.ngc"):
            for more in ([], ["--set", "Order=4", "--set", "CoefBits=26", "--error", "3nm"]):
                with self.subTest(part=part, more=more):
                    said, samples = self.drawn_by_wasm(DATA / part, QUICK + more)
                    self.assertEqual(said, "")
                    subprocess.run([OPTIONS.program, "run", DATA / part, *QUICK, *more, "-q",
                                    "-o", self.folder / "run"], check=True)
                    mine, theirs = positions(samples), positions(self.folder / "run/samples.csv")
                    self.assertGreater(len(mine), 1000)
                    self.assertEqual(mine, theirs)

    def test_a_broken_program_is_named_with_its_line(self):
        part = self.folder / "broken.ngc"
        part.write_text("G21\nG1 X10 F1000\nG2 X5\nM2\n", encoding="ascii")
        said, _ = self.drawn_by_wasm(part, QUICK)
        self.assertEqual(said, "program: broken.ngc:3: error: G2 without a centre (I, J) or a"
                               " radius (R)")

    def open(self, width):
        self.browser.send("Emulation.setDeviceMetricsOverride", width=width, height=900,
                          deviceScaleFactor=1, mobile=width < 600)
        self.browser.open(SITE / "html/demo.html")

    def answer(self):
        """Waits for the worker, and returns what the page says."""
        time.sleep(0.5)  # the page waits for the end of typing
        deadline = time.monotonic() + WAIT
        while self.browser.get('byId("demo").hasAttribute("aria-busy")'):
            self.assertLess(time.monotonic(), deadline, "nothing is drawn")
            time.sleep(0.1)
        return self.browser.get('byId("status").textContent')

    def enter(self, text):
        self.browser.get(f"""(() => {{
            byId("text").value = {text!r};
            byId("text").dispatchEvent(new Event("input"));
        }})()""")
        return self.answer()

    def test_the_demo_draws_on_a_desk_and_on_a_phone(self):
        for width in WIDTHS:
            with self.subTest(width=width):
                self.open(width)
                self.assertIn("Every check held", self.answer())
                self.assertGreater(self.browser.get("shown.data.worst"), 0)
                self.assertTrue(self.browser.get("shown.data.worst < shown.data.bound"))
                self.assertGreater(self.browser.get("shown.data.traffic.profile_words"), 0)
                wide = self.browser.get(f"""[...document.querySelectorAll("#demo *")].filter((e) =>
                    e.getBoundingClientRect().right > {width} + 0.5).length""")
                self.assertEqual(wide, 0)
                self.assertEqual(self.browser.get("""[...document.querySelectorAll("#demo canvas")]
                    .filter((e) => !e.getAttribute("aria-label")).length"""), 0)
                self.assertEqual(self.browser.errors(), [])
                self.assertEqual(self.browser.addresses(), [], "the page wants the network")
                self.picture(f"demo_{width}")

    def test_narrower_words_are_drawn_within_a_wider_bound(self):
        self.open(1280)
        self.answer()
        bound = self.browser.get("shown.data.bound")
        self.browser.get('byId("bits").value = 24; byId("bits").dispatchEvent(new Event("input"))')
        self.assertIn("Every check held", self.answer())
        self.assertGreater(self.browser.get("shown.data.bound"), 10 * bound)

    def test_the_page_names_a_broken_line_and_draws_the_mended_one(self):
        self.open(1280)
        self.answer()
        said = self.enter("G21\nG1 X10 F1000\nG2 X5\nM2\n")
        self.assertIn("part.ngc:3: error: G2 without a centre", said)
        selected = self.browser.get('byId("text").value.slice(byId("text").selectionStart, '
                                    'byId("text").selectionEnd)')
        self.assertEqual(selected, "G2 X5")
        self.assertIn("Every check held", self.enter("G21\nG1 X10 F1000\nM2\n"))

    def test_a_part_that_lasts_too_long_is_refused(self):
        self.open(1280)
        self.answer()
        self.assertIn("samples are drawn at most", self.enter("G21\nG1 X100 F1\nM2\n"))

    def picture(self, name):
        if OPTIONS.pictures:
            OPTIONS.pictures.mkdir(parents=True, exist_ok=True)
            self.browser.picture(OPTIONS.pictures / f"{name}.png", captureBeyondViewport=True)


if __name__ == "__main__":
    run_tests(__doc__.split("\n")[0])
