#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""vendor_test.py ROOT YOSYS [TESTS ..]: projects for Vivado and Quartus name all that they need,
and Yosys elaborates the files that they name. The vendors' tools are not here."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT, YOSYS = pathlib.Path(sys.argv[1]), sys.argv[2]
FILES = [f"rtl/{name}" for name in (ROOT / "rtl/curvecore.f").read_text().split()]
CELLS = {"arty_a7": "+/xilinx/cells_sim.v +/xilinx/cells_xtra.v", "de10_nano": ""}


def table_of(board):
    return json.loads((ROOT / f"scripts/vendor_boards/{board}.json").read_text())


def pins_of(table):
    """Returns pins by port, as the table has them."""
    pins = {}
    for name, given in table["pins"].items():
        if name in ("outputs", "pwm"):  # without the parameter Outputs they are not used
            continue
        pins |= ({f"{name}[{axis}]": pin for axis, pin in enumerate(given)}
                 if isinstance(given, list) else {name: given})
    return pins


class Project(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def ask(self, *words, status=0):
        done = subprocess.run([sys.executable, ROOT / "scripts/synth.py", "--output", self.folder,
                               *words], text=True, capture_output=True)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout if status == 0 else done.stderr

    def make(self, board):
        """Returns the project's script."""
        table = table_of(board)
        said = self.ask("--project", board)
        self.assertIn(f"{table['part']} at 50 MHz, set up, not run; with ", said)
        self.assertIn("set up, not run", table["board"])
        self.project = self.folder / "projects" / board
        return (self.project / f"{board}.tcl").read_text()

    def elaborates(self, board, files):
        """Checks that Yosys finds every module from the top down, and not without one of them."""
        def yosys(read):
            return subprocess.run(
                [YOSYS, "-q", "-p", f"read_verilog -sv -defer {' '.join(read)}; "
                 f"read_verilog -lib +/ecp5/cells_bb.v +/ice40/cells_sim.v {CELLS[board]}; "
                 "hierarchy -check -top top; select -assert-min 10 t:*"], cwd=self.project,
                text=True, capture_output=True)

        done = yosys(files)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        lacking = yosys([name for name in files if not name.endswith("/uart_line.sv")])
        self.assertIn("uart_line", lacking.stderr)
        self.assertNotEqual(lacking.returncode, 0)

    def test_is_vivados(self):
        script = self.make("arty_a7")
        self.assertIn("set_property part xc7a35ticsg324-1L ", script)
        self.assertIn("set_property top top ", script)
        read = dict(reversed(line.rstrip("}").split(" {")) for line in script.splitlines()
                    if line.startswith("read_"))
        self.assertEqual(read, dict.fromkeys(FILES, "read_verilog -sv") | {
            "top.v": "read_verilog", "pll.v": "read_verilog", "board.xdc": "read_xdc",
            "program.mem": "read_mem", "data.mem": "read_mem"})
        pins = re.findall(r"^set_property -dict {PACKAGE_PIN (\w+) IOSTANDARD LVCMOS33"
                          r"(?: PULLUP TRUE)?} \[get_ports {(.*)}\]$",
                          (self.project / "board.xdc").read_text(), re.M)
        self.assertEqual({port: pin for pin, port in pins}, pins_of(table_of("arty_a7")))
        self.elaborates("arty_a7", [name for name in read if name.endswith("v")])

    def test_is_quartuses(self):
        script = self.make("de10_nano")
        self.assertIn("set_global_assignment -name DEVICE 5CSEBA6U23I7\n", script)
        self.assertIn("set_global_assignment -name TOP_LEVEL_ENTITY top\n", script)
        self.assertIn("\nsource board.tcl\n", script)
        self.assertIn("set_global_assignment -name SDC_FILE board.sdc\n", script)
        read = re.findall(r"-name (?:SYSTEM)?VERILOG_FILE (\S+)", script)
        self.assertEqual(read, [*FILES, "top.v"])
        pins = re.findall(r'^set_location_assignment PIN_(\w+) -to "(.*)"$',
                          (self.project / "board.tcl").read_text(), re.M)
        self.assertEqual({port: pin for pin, port in pins}, pins_of(table_of("de10_nano")))
        self.elaborates("de10_nano", read)

    def test_is_refused_with_the_reason(self):
        file = self.folder / "mine.json"
        for board, change, reason in (
                ("arty_a7", {"clock_hz": 70000000}, "the PLL does not make 70000000 Hz"),
                ("de10_nano", {"clock_hz": 100000000}, "clock_hz must be 50000000, the oscillator"),
                ("de10_nano", {"family": "ecp5"}, "unknown family 'ecp5': one of xc7, cyclonev"),
                ("arty_a7", {"baud": 30000000}, "30000000 baud: a bit has 2 clocks"),
                ("arty_a7", {"package": "csg324"}, "'package': a board has board, part,")):
            with self.subTest(reason=reason):
                file.write_text(json.dumps(table_of(board) | change))
                said = self.ask("--project", str(file), status=2)
                self.assertIn(f"synth: {file}: {reason}", said)
        self.assertIn("synth: unknown board 'arty': one of arty_a7, de10_nano, or a file",
                      self.ask("--project", "arty", status=2))
        self.assertIn("--project has all of it in its table",
                      self.ask("--project", "arty_a7", "--board", "ulx3s_85", status=2))
        self.assertFalse((self.folder / "projects").exists())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
