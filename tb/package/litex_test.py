#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""litex_test.py ROOT YOSYS VERILATOR [TESTS ..]: the example of a LiteX system is made, Yosys
elaborates it, and its registers are read in simulation, through its UART and its Wishbone."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT, YOSYS, VERILATOR = pathlib.Path(sys.argv[1]), *sys.argv[2:4]

# A read of one word by LiteX's bridge of UARTs: 2, count, address of the word; then the word.
BENCH = """`timescale 1ns / 1ns
module bench;
  localparam Bit = 1000;
  reg clk = 0, rx = 1;
  wire tx;
  always #20 clk = !clk;
  colorlight_i5 u_system (.clk(clk), .serial_rx(rx), .serial_tx(tx),
                          .motion_estop(1'b0), .motion_limit(3'd0));
  task send(input [7:0] data);
    integer i;
    begin
      rx = 0;
      for (i = 0; i < 8; i = i + 1) #Bit rx = data[i];
      #Bit rx = 1;
      #(2 * Bit);
    end
  endtask
  task read(input [31:0] address);
    begin
      send(2); send(1);
      send(address[31:26]); send(address[25:18]); send(address[17:10]); send(address[9:2]);
    end
  endtask
  reg [7:0] got;
  integer k;
  always @(negedge tx) begin
    #(Bit / 2);
    for (k = 0; k < 8; k = k + 1) #Bit got[k] = tx;
    #Bit $write("%h", got);
  end
  initial begin
    #20000 read(32'h30000000);  // ID
    #60000 read(32'h30000010);  // CLOCK
    #60000 $finish(0);
  end
endmodule
"""


class LitexTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        done = subprocess.run([sys.executable, ROOT / "scripts/litex/colorlight_i5.py", cls.folder],
                              text=True, capture_output=True)
        assert done.returncode == 0, done.stdout + done.stderr
        cls.gateware = cls.folder / "gateware"

    def sources(self):
        script = (self.gateware / "colorlight_i5.ys").read_text()
        return [file for _, file in re.findall(r"^read_verilog (-sv )?(\S+)$", script, re.M)]

    def test_names_all_files_and_pins(self):
        for name in (ROOT / "rtl/curvecore.f").read_text().split():
            self.assertIn(str(ROOT / "rtl" / name), self.sources())
        pins = (self.gateware / "colorlight_i5.lpf").read_text()
        for line in ('LOCATE COMP "motion_step[0]" SITE "C17";',
                     'LOCATE COMP "motion_estop" SITE "D1";', "PULLMODE=UP"):
            self.assertIn(line, pins)

    def test_elaborates(self):
        done = subprocess.run(
            [YOSYS, "-q", "-p", f"read_verilog -sv -defer {' '.join(self.sources())}; "
             "read_verilog -lib +/ecp5/cells_bb.v +/ice40/cells_sim.v; "
             "hierarchy -check -top colorlight_i5"], cwd=self.gateware, text=True,
            capture_output=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_what_it_is_given_is_checked(self):
        sys.path.insert(0, str(ROOT / "scripts/litex"))
        from colorlight_i5 import IO, CurvecoreMotion, LatticeECP5Platform
        from synthesis.refused import Refused
        platform = LatticeECP5Platform("LFE5U-25F-6BG381C", IO, toolchain="trellis")
        pads = platform.request("motion")
        for settings, reason in (({"AuxAxes": 1}, "pads.step has 3 bits for 4 axes"),
                                 ({"Orders": 6}, "motion_system has no parameter Orders"),
                                 ({"PeriodLog2": 11}, "PeriodLog2")):
            with self.assertRaisesRegex(Refused, reason):
                CurvecoreMotion(platform, pads, self.folder / "refused", **settings)
        self.assertFalse(list(self.folder.glob("refused/*.hex")))

    def test_registers_are_read(self):
        (self.gateware / "bench.v").write_text(BENCH)
        # Migen's warnings of widths are none of ours.
        made = subprocess.run(
            [VERILATOR, "--binary", "--timing", "-Wno-fatal", "-Wno-lint", "-CFLAGS", "-O0",
             "--top-module", "bench", "-o", "bench", "bench.v", "-v",
             ROOT / "tb/support/primitives/MULT18X18D.sv", *self.sources()], cwd=self.gateware,
            text=True, capture_output=True)
        self.assertEqual(made.returncode, 0, made.stderr[-3000:])
        said = subprocess.run([self.gateware / "obj_dir/bench"], cwd=self.gateware, text=True,
                              capture_output=True).stdout
        self.assertIn(f"{0x43564D31:08x}{25000000:08x}", said)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
