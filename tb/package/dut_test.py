#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""dut_test.py CURVECORE ROOT [TESTS ..]: designs of others in the place of the core, `run --dut`.

recorded_core.v stands for a design of others, and scripts/flat.sh makes copies of ours.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

CURVECORE, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
RECORDED = pathlib.Path(__file__).resolve().parent / "recorded_core.v"
PART = "G21 G90 F900\nG1 X1\nG3 X2 Y1 I0 J1\nG1 Y3\nM2\n"
OPTIONS = ["--set", "Order=2", "--set", "CoefBits=18", "--set", "Splines=0", "--path", "exact",
           "--unit", "1um"]


class DutTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()
        (self.folder / "part.ngc").write_text(PART, encoding="ascii")

    def program(self, command, *arguments):
        environment = dict(os.environ, CURVECORE_CORES=str(self.folder / "cores"))
        return subprocess.run([CURVECORE, command, "part.ngc", *OPTIONS, *arguments], check=False,
                              cwd=self.folder, env=environment, capture_output=True, text=True)

    def run_dut(self, *files, status=0, more=()):
        """Runs the part with these files; returns what the program says on stderr."""
        options = [*more, *(text for file in files for text in ("--dut", file))]
        done = self.program("run", *options, "-q", "-o", "out")
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertNotIn("internal", done.stderr)
        return done.stderr

    def record(self):
        """Writes the recorded core of the part, and returns its file."""
        done = self.program("vectors", "-q", "-o", ".")
        self.assertEqual(done.returncode, 0, done.stderr)
        samples = json.loads((self.folder / "words.json").read_text())["samples"]
        (self.folder / "recorded_settings.vh").write_text(f"`define SAMPLES {samples}\n",
                                                          encoding="ascii")
        return shutil.copy(RECORDED, self.folder)

    def change(self, file, old, new):
        text = pathlib.Path(file).read_text()
        self.assertIn(old, text)
        pathlib.Path(file).write_text(text.replace(old, new))

    def test_is_held_to_the_kernel(self):
        core = self.record()
        self.assertEqual(self.run_dut(core), "")
        report = json.loads((self.folder / "out/report.json").read_text())
        self.assertEqual(report["rtl_equals_kernel"], 0)
        self.assertGreater(report["samples"], 1000)
        self.assertEqual(self.run_dut(core, more=["--trace", "--stall", "7"]), "", "the kept model")
        self.assertIn("\ndut.recorded_core.sample_position_o[",
                      (self.folder / "out/waves.gtkw").read_text())
        self.assertEqual(len([*self.folder.glob("cores/*/core.so")]), 1)

        # What it includes belongs to it; a sign of y is flipped from sample 1001 on.
        header = self.folder / "recorded_settings.vh"
        header.write_text(header.read_text() + "`define FLIPPED\n")
        self.change(core, "      n <= n + 1;", "`ifdef FLIPPED\n      if (n >= 1000)"
                    " sample_position_o[PositionBits+:PositionBits] <="
                    " -positions[n][PositionBits+:PositionBits];\n`endif\n      n <= n + 1;")
        error = self.run_dut(core, status=1)
        found = re.search(r"first: sample 1001, segment \d+ of line (\d+): board y (-\d+), kernel"
                          r" y (\d+)\n", error)
        self.assertIsNotNone(found, error)
        self.assertEqual(int(found[2]), -int(found[3]))
        self.assertIn(int(found[1]), (3, 4))
        header.write_text(header.read_text().replace("`define FLIPPED\n", ""))
        self.assertEqual(self.run_dut(core), "", "without it, from an include that changed")

    def test_without_a_cores_ports_is_refused(self):
        core = self.record()
        whole = pathlib.Path(core).read_text()
        for old, new, reason in (
                ("    input kill_i,\n", "", "it has no input kill_i of 1 bit"),
                ("    input [15:0] digest_i,", "    input [14:0] digest_i,",
                 "its digest_i has 15 bits, expected are 16"),
                ("PositionBits-1:0] sample_position_o", "PositionBits:0] sample_position_o",
                 "its sample_position_o has 97 bits, expected are 96"),
                ("    input hold_i,", "    output hold_i,",
                 "its hold_i is an output, expected is an input")):
            with self.subTest(reason=reason):
                pathlib.Path(core).write_text(whole.replace(old, new))
                self.assertEqual(self.run_dut(core, status=2),
                                 f"curvecore: error: --dut {core}: recorded_core has not the ports"
                                 f" of motion_interpolator: {reason}\n")
        pathlib.Path(core).write_text("module nothing (input clk);\nendmodule\n")
        self.assertEqual(self.run_dut(core, status=2),
                         f"curvecore: error: --dut {core}: no module has a port of"
                         " motion_interpolator; at the top are: nothing\n")
        pathlib.Path(core).write_text("module top (input clk_i);\n  sub u_sub ();\nendmodule\n")
        self.assertRegex(self.run_dut(core, status=2),
                         rf"^curvecore: error: --dut {core}: %Error: {core}:2:3: Cannot find file"
                         r" containing module: 'sub'; all of it: \S+\.log\n$")
        self.assertFalse((self.folder / "out").exists())
        self.assertEqual([file.name for file in self.folder.glob("cores/*") if file.is_dir()], [])

    def test_that_gives_no_sample_is_red(self):
        core = self.record()
        self.change(core, "sample_valid_o <= 1'b1", "sample_valid_o <= 1'b0")
        self.assertRegex(self.run_dut(core, status=1),
                         r"^curvecore: error: the board gave no sample for 2 million turns; faults:"
                         r" none; its words are for parallel Order=2 .* MultiplierForm=0\n$")
        self.assertFalse((self.folder / "out").exists())

    def test_flat_copies_are_held_to_the_kernel(self):
        core = self.folder / "flat.v"
        subprocess.run([ROOT / "scripts/flat.sh", "motion_interpolator", "Order=2", "CoefBits=18",
                        "-o", core], check=True, capture_output=True)
        self.assertEqual(self.run_dut(core), "")
        self.change(core, "{ \\g_circuits.u_motion.u_core.u_side.u_landing.g_output[2].position_q ,"
                    " \\g_circuits.u_motion.u_core.u_side.u_landing.g_output[1].position_q ,",
                    "{ \\g_circuits.u_motion.u_core.u_side.u_landing.g_output[2].position_q ,"
                    " -\\g_circuits.u_motion.u_core.u_side.u_landing.g_output[1].position_q ,")
        self.assertRegex(self.run_dut(core, status=1),
                         r"first: sample \d+, segment \d of line 3: board y -1, kernel y 1\n")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
