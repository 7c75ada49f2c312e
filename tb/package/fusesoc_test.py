#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""fusesoc_test.py FUSESOC: the targets of rtl/curvecore.core, as a user types them: lint and sim
run, synth is set up for Vivado and Quartus, which are not run here."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

RTL = pathlib.Path(__file__).resolve().parent.parent.parent / "rtl"
NAME = "curvecore:motion:curvecore"
FILES = (RTL / "curvecore.f").read_text().split()


class FuseSoC(unittest.TestCase):
    def setUp(self):
        self.kept = tempfile.TemporaryDirectory()
        self.addCleanup(self.kept.cleanup)
        self.folder = pathlib.Path(self.kept.name)
        self.ask("library", "add", "curvecore", str(RTL))

    def ask(self, *words):
        done = subprocess.run([PROGRAM, *words], cwd=self.folder, text=True, capture_output=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def made(self, pattern):
        return next(self.folder.glob(f"build/*/{pattern}")).read_text()

    def test_lint(self):
        self.ask("run", "--target=lint", NAME, "--Build", "1", "--Splines", "1")

    def test_sim_draws_the_part(self):
        lines = [line for line in self.ask("run", "--target=sim", NAME).split("\n")
                 if line.count(",") == 2]
        self.assertEqual(lines[0], "0,0,0")
        self.assertEqual(lines[-1], "80000,20000,10000")  # part.ngc's end, nm
        self.assertGreater(len(set(lines)), 100)

    def test_a_warning_ends_the_lint(self):
        done = subprocess.run([PROGRAM, "run", "--target=lint", NAME, "--CoefBits", "37"],
                              cwd=self.folder, text=True, capture_output=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("%Warning-SELRANGE", done.stdout + done.stderr)

    def test_vivado(self):
        self.ask("run", "--target=synth", "--setup", NAME, "--Build", "2", "--Order", "5")
        script = self.made("synth-vivado/*[0-9].tcl")
        self.assertIn("set_property part xc7a35ticsg324-1L", script)
        self.assertIn("Build=2 Order=5 ", script)
        read = [line.split("/", 2)[2].rstrip("}") for line in script.split("\n")
                if line.startswith("read_verilog -sv")]
        self.assertEqual(read, FILES)

    def test_quartus(self):
        self.ask("run", "--target=synth", "--tool=quartus", "--setup", NAME, "--Build", "2")
        script = self.made("synth-quartus/*.tcl")
        self.assertIn("DEVICE 5CSEBA6U23I7", script)
        self.assertIn("TOP_LEVEL_ENTITY motion_interpolator", script)
        self.assertIn("set_parameter -name Build 2\n", script)
        self.assertEqual(script.count("SYSTEMVERILOG_FILE"), len(FILES))


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
