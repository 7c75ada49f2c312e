# SPDX-License-Identifier: Apache-2.0
"""Module of LiteX: motion_system, registers to step and direction pins, behind Wishbone.

    from curvecore_motion import REGION_BYTES, CurvecoreMotion
    self.motion = CurvecoreMotion(platform, platform.request("motion"), "build/motion",
                                  ClockHertz=sys_clk_freq, MultiplierForm=1)
    self.bus.add_slave("motion", self.motion.bus,
                       SoCRegion(origin=0x30000000, size=REGION_BYTES, cached=False))

Registers: hls/registers/registers.rdl; what a host writes: sysc/wire/README.md.
"""

import pathlib
import sys

from litex.gen import LiteXModule
from litex.soc.interconnect import wishbone
from migen import ClockSignal, Instance, ResetSignal, Signal

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.append(str(ROOT / "scripts"))
from synthesis import microcode  # noqa: E402
from synthesis.cores import check_parameters, parameters  # noqa: E402
from synthesis.refused import Refused  # noqa: E402

TOP = "motion_system"
REGION_BYTES = 512


class CurvecoreMotion(LiteXModule):
    """Wishbone slave `bus`, 32-bit words; a write of a part of a word is answered by an error.

    pads has step, direction, limit (one bit an axis), enable, estop, and may have home (one bit an
    axis; else the limit switches are the home switches) and probe. estop and limit are of open
    switches: a pull-up and a switch that closes to ground stop when a wire is off.

    folder gets the engine's programs (Build 2, the default), which are compiled on first use.
    settings are parameters of rtl/motion_system.sv. Raises synthesis.refused.Refused."""

    def __init__(self, platform, pads, folder, **settings):
        settings = {name: str(value) for name, value in settings.items()}
        check_parameters(TOP, settings)
        axes = 3 + int((parameters(TOP) | settings)["AuxAxes"])
        for name in ("step", "direction", "limit"):
            if len(getattr(pads, name)) != axes:
                raise Refused(f"pads.{name} has {len(getattr(pads, name))} bits for {axes} axes")
        folder = pathlib.Path(folder).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        settings = microcode.make(TOP, settings, folder, folder / "microcode.log")
        for name in (ROOT / "rtl/curvecore.f").read_text().split():
            platform.add_source(str(ROOT / "rtl" / name), language="systemverilog")

        self.bus = wishbone.Interface(data_width=32, adr_width=30, addressing="word")
        request = {"valid": Signal(), "write": Signal(), "word": Signal(7), "data": Signal(32)}
        answer = {"done": Signal(), "error": Signal(), "data": Signal(32)}
        clock = {"i_clk_i": ClockSignal(), "i_rst_ni": ~ResetSignal()}
        self.specials += Instance(
            "wishbone_port", **clock, i_cyc_i=self.bus.cyc, i_stb_i=self.bus.stb,
            i_we_i=self.bus.we, i_adr_i=self.bus.adr[:7], i_dat_i=self.bus.dat_w,
            i_sel_i=self.bus.sel, o_ack_o=self.bus.ack, o_err_o=self.bus.err,
            o_dat_o=self.bus.dat_r, **{f"o_{name}_o": wire for name, wire in request.items()},
            **{f"i_{name}_i": wire for name, wire in answer.items()})
        self.specials += Instance(
            TOP, **{f"p_{name}": self.value(name, text, folder)
                    for name, text in settings.items()},
            **clock, **{f"i_{name}_i": wire for name, wire in request.items()},
            **{f"o_{name}_o": wire for name, wire in answer.items()},
            i_segment_valid_i=0, i_segment_data_i=0, i_profile_valid_i=0, i_profile_data_i=0,
            i_estop_i=pads.estop, i_limit_i=pads.limit, i_probe_i=getattr(pads, "probe", 0),
            i_home_i=getattr(pads, "home", pads.limit), i_encoder_a_i=0, i_encoder_b_i=0,
            o_step_o=pads.step, o_direction_o=pads.direction, o_enable_o=pads.enable)

    @staticmethod
    def value(name, text, folder):
        """Returns a parameter as LiteX wants it: a number, or a file's name."""
        return str(folder / text.strip('"')) if name in microcode.FILES else int(text)
