#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""plugin_test.py CURVECORE [TESTS ..]: the plugin of pytest, with tests as users write them; their
core is recorded_core.v, with a changed sign."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

CURVECORE = pathlib.Path(sys.argv[1]).resolve()
RECORDED = pathlib.Path(__file__).resolve().parent / "recorded_core.v"
OPTIONS = ["--set", "Order=2", "--set", "CoefBits=18", "--unit", "1um", "--path", "exact"]
TESTS = """
import curvecore
import pytest

CORE = {"set": {"Order": 2, "CoefBits": 18}, "unit": "1um", "path": "exact"}

def test_kernel(curvecore_run):
    report = curvecore_run("part.ngc", on="kernel", **CORE)
    assert report["samples"] > 1000

def test_named_core(curvecore_run):
    curvecore_run("part.ngc", dut="recorded_core.v", **CORE)

def test_core_of_the_command_line(curvecore_run):
    curvecore_run("part.ngc", **CORE)

def test_refusal(curvecore_run):
    with pytest.raises(curvecore.InputError, match="no such file"):
        curvecore_run("part.ngc", dut=["recorded_core.v", "none.v"], **CORE)
"""


class PluginTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()
        (self.folder / "part.ngc").write_text("G21 G90 F900\nG1 X1\nG3 X2 Y1 I0 J1\nM2\n")
        (self.folder / "test_core.py").write_text(TESTS)
        self.run_in([CURVECORE, "vectors", "part.ngc", *OPTIONS, "-q", "-o", "."])
        samples = json.loads((self.folder / "words.json").read_text())["samples"]
        (self.folder / "recorded_settings.vh").write_text(f"`define SAMPLES {samples}\n")
        core = pathlib.Path(shutil.copy(RECORDED, self.folder))
        text = core.read_text()
        self.assertIn("<= positions[n];", text)
        core.write_text(text.replace("<= positions[n];", "<= {positions[n][3*PositionBits-1:"
                                     "PositionBits], -positions[n][PositionBits-1:0]};"))

    def run_in(self, command):
        environment = dict(os.environ, CURVECORE_CORES=str(self.folder / "cores"),
                           CURVECORE_PROGRAM=str(CURVECORE))
        return subprocess.run(command, cwd=self.folder, env=environment, check=False, text=True,
                              capture_output=True)

    def test_a_changed_sign_is_red(self):
        done = self.run_in([sys.executable, "-m", "pytest", "-p", "curvecore.pytest_plugin",
                            "--curvecore-dut", "recorded_core.v", "-v", "-p", "no:cacheprovider"])
        for name, outcome in (("kernel", "PASSED"), ("named_core", "FAILED"),
                              ("core_of_the_command_line", "FAILED"), ("refusal", "PASSED")):
            self.assertRegex(done.stdout, rf"::test_{name} {outcome}", done.stderr)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"\ncurvecore: check failed: RTL equals kernel: \d+ words"
                         r" differ; first: sample \d+, segment \d of line 2: board x -1, kernel"
                         r" x 1\n")
        self.assertRegex(done.stdout, r"\n/\S+/run0/report.html\n")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
