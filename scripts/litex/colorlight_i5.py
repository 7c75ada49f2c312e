#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Example of a LiteX system with motion, on Colorlight i5 v7.0: registers at 0x30000000, over the
UART of its extension board (litex_server --uart), pins as in scripts/boards/colorlight_i5.json.

    python3 scripts/litex/colorlight_i5.py [DIR]     DIR, build/litex unless given, gets Verilog,
                                                     constraints, scripts of Yosys and nextpnr

It was elaborated, not placed. LiteX and Migen: see scripts/versions.env.
"""

import json
import pathlib
import sys

from litex.build.generic_platform import IOStandard, Misc, Pins, Subsignal
from litex.build.io import CRG
from litex.build.lattice import LatticeECP5Platform
from litex.soc.integration.builder import Builder
from litex.soc.integration.soc import SoCRegion
from litex.soc.integration.soc_core import SoCMini

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from curvecore_motion import REGION_BYTES, ROOT, CurvecoreMotion  # noqa: E402

BOARD = json.loads((ROOT / "scripts/boards/colorlight_i5.json").read_text())


def pads(name, pull="NONE"):
    given = BOARD["pins"][name]
    return Subsignal(name, Pins(" ".join(given) if isinstance(given, list) else given),
                     Misc(f"PULLMODE={pull}"))


IO = [
    ("clk", 0, Pins(BOARD["pins"]["clk"]), IOStandard("LVCMOS33")),
    ("serial", 0, Subsignal("tx", Pins(BOARD["pins"]["uart_tx"])),
     Subsignal("rx", Pins(BOARD["pins"]["uart_rx"])), IOStandard("LVCMOS33")),
    ("motion", 0, pads("step"), pads("direction"), pads("enable"), pads("estop", "UP"),
     pads("limit", "UP"), IOStandard("LVCMOS33")),
]


class System(SoCMini):
    """Bridge from a UART to Wishbone, and the motion behind it."""

    def __init__(self, folder):
        platform = LatticeECP5Platform(BOARD["part"], IO, toolchain="trellis")
        platform.default_clk_name = "clk"
        platform.default_clk_period = 1e9 / BOARD["oscillator_hz"]
        hertz = BOARD["oscillator_hz"]
        SoCMini.__init__(self, platform, hertz, ident="curvecore motion")
        self.crg = CRG(platform.request("clk"))
        self.add_uartbone(baudrate=BOARD["baud"])
        self.motion = CurvecoreMotion(platform, platform.request("motion"), folder / "programs",
                                      ClockHertz=hertz, MultiplierForm=1)
        self.bus.add_slave("motion", self.motion.bus, SoCRegion(
            origin=0x30000000, size=REGION_BYTES, cached=False))


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "build/litex").resolve()
    builder = Builder(System(folder), output_dir=str(folder), compile_software=False,
                      csr_csv=str(folder / "csr.csv"))
    builder.build(run=False, build_name="colorlight_i5")


if __name__ == "__main__":
    main()
