# SPDX-License-Identifier: Apache-2.0
"""cocotbext-spi's master, 16 clocks of 10 ns a bit, and between words."""

import cocotb.clock
from cocotb.types import Logic

# Names that cocotbext-spi 0.5.0 imports from cocotb 1.
cocotb.clock.BaseClock = type("BaseClock", (), {
    "__init__": lambda self, signal: setattr(self, "signal", signal)})
Logic.integer = property(int)
from cocotbext.spi import SpiBus, SpiConfig, SpiMaster  # noqa: E402


def spi_master(dut, bits):
    """Returns a master for words of this number of bits."""
    return SpiMaster(SpiBus.from_prefix(dut, "spi"), SpiConfig(
        word_width=bits, sclk_freq=1e9 / 160, frame_spacing_ns=160))
