#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""action_test.py ROOT CURVECORE WRONG_ROUNDING [TESTS ..]: .github/actions/run, its shell with a
program that says what it is given and where; and what CI systems are given, junit.xml."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import yaml

ROOT, CURVECORE, WRONG = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]


class ActionTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_passes_on_what_it_is_given(self):
        action = yaml.safe_load((ROOT / ".github/actions/run/action.yml").read_text())
        step, = action["runs"]["steps"]
        for name in step["env"].values():
            self.assertIn(name.strip("${} ").removeprefix("inputs."), action["inputs"])
        tree = self.folder / "tree"
        for name, text in (("scripts/setup.sh", ":"), ("bin/cmake", ":"),
                           ("build/curvecore", 'pwd -P; printf "<%s>" "$@"')):
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            (tree / name).write_text(f"#!/bin/sh\n{text}\n", encoding="ascii")
            (tree / name).chmod(0o755)
        shutil.copy(ROOT / "scripts/demo.sh", tree / "scripts")
        (tree / ".github/actions/run").mkdir(parents=True)
        here = self.folder / "here"  # where relative files are
        here.mkdir()
        (here / "Order=4").touch()
        for given, expected in (
                ({"PART": "a b.ngc", "RTL": "", "DUT": "", "OPTIONS": ""}, "<--junit>"),
                ({"PART": "p.ngc", "RTL": "", "DUT": "a.v O*=4.v", "OPTIONS": ""},
                 "<--dut><a.v><--dut><O*=4.v><--junit>"),
                ({"PART": "p.ngc", "RTL": "my rtl", "DUT": "",
                  "OPTIONS": "--machine my/mill.ini --set O*=4"},
                 "<--rtl><my rtl><--junit><--machine><my/mill.ini><--set><O*=4>")):
            done = subprocess.run(
                ["bash", "-e", "-c", step["run"]], cwd=here, check=True, text=True,
                capture_output=True,
                env={**given, "GITHUB_ACTION_PATH": str(tree / ".github/actions/run"),
                     "GITHUB_OUTPUT": str(self.folder / "output"),
                     "PATH": f"{tree}/bin:/usr/bin:/bin"})
            self.assertEqual(done.stdout.split("\n")[:2],
                             [str(here.resolve()),
                              f"<run><{given['PART']}><-o><{tree}/build/demo>{expected}"])
        self.assertIn(f"folder={tree}/build/demo\n", (self.folder / "output").read_text())

    def cases(self, program, status):
        part = self.folder / "a&b<.ngc"
        part.write_text("G21 G61 G90 F450\nG1 X0.1\nG3 X0.2 Y0.1 I0 J0.1\nM2\n",
                        encoding="ascii")
        done = subprocess.run([program, "run", part, "--junit", "-q", "-o", self.folder / "out"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, status, done.stderr)
        suite = xml.etree.ElementTree.parse(self.folder / "out/junit.xml").getroot()
        self.assertEqual(suite.get("name"), str(part))
        cases = suite.findall("testcase")
        self.assertEqual(len(cases), int(suite.get("tests")))
        failed = [case.get("name") for case in cases if case.find("failure") is not None]
        self.assertEqual(len(failed), int(suite.get("failures")))
        return cases, failed, done.stderr

    def test_checks_are_test_cases(self):
        cases, failed, _ = self.cases(CURVECORE, 0)
        self.assertGreater(len(cases), 8)
        self.assertEqual(failed, [])
        cases, failed, said = self.cases(WRONG, 1)
        self.assertIn("RTL equals kernel", failed)
        self.assertEqual(said.count("check failed: "), len(failed))
        first = next(case.find("failure").get("message") for case in cases
                     if case.get("name") == "RTL equals kernel")
        self.assertRegex(first, r"^\d+ words differ; first: sample \d+, segment \d+ of line \d: ")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
