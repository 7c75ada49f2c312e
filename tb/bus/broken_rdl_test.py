#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A register description that is broken is refused with its path and the reason, status 2, without
Python's own trace, and nothing is written; the unbroken one makes its four files.

    broken_rdl_test.py hls/registers
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest


class BrokenDescription(unittest.TestCase):
    def make(self, change):
        """Status, stderr and the files made of a changed description; None: there is none."""
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        shutil.copy(self.registers / "make_registers.py", folder)
        text = change((self.registers / "registers.rdl").read_text())
        self.rdl = folder / "registers.rdl"
        if text is not None:
            self.rdl.write_text(text)
        made = folder / "made"
        made.mkdir()
        run = subprocess.run([sys.executable, folder / "make_registers.py", made],
                             capture_output=True, text=True, check=False)
        return run.returncode, run.stderr, sorted(file.name for file in made.iterdir())

    def refused(self, change, reason):
        status, told, files = self.make(change)
        self.assertEqual((status, files), (2, []))
        self.assertIn(f"{self.rdl}: error: {reason}", told)
        self.assertNotIn("Traceback", told)
        return told

    def test_the_description_itself_is_made(self):
        names = ["registers.h", "registers.html", "registers.json", "registers_pkg.sv"]
        self.assertEqual(self.make(lambda text: text), (0, "", names))

    def test_syntax_with_its_line(self):
        told = self.refused(lambda text: text.replace("};", "}", 1), "Parse aborted")
        self.assertRegex(told, rf"{self.rdl}:\d+:\d+: error: ")

    def test_an_unknown_value_with_its_line(self):
        told = self.refused(lambda text: text.replace("sw = r;", "sw = q;", 1), "Reference to 'q'")
        self.assertRegex(told, rf"{self.rdl}:\d+:\d+: ")

    def test_another_map(self):
        self.refused(lambda text: text.replace("addrmap registers", "addrmap other"),
                     "Elaboration target 'registers' not found")

    def test_no_axes(self):
        self.refused(lambda text: text[:text.rindex("regfile")] + "};", "there is no regfile")

    def test_no_file(self):
        self.refused(lambda text: None, "No such file")


if __name__ == "__main__":
    BrokenDescription.registers = pathlib.Path(sys.argv.pop(1))
    unittest.main()
