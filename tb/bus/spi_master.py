# SPDX-License-Identifier: Apache-2.0
"""cocotbext-spi's master; a clock has 10 ns."""

import cocotb.clock
from cocotb.types import Logic

# Names that cocotbext-spi 0.5.0 imports from cocotb 1.
cocotb.clock.BaseClock = type("BaseClock", (), {
    "__init__": lambda self, signal: setattr(self, "signal", signal)})
Logic.integer = property(int)
from cocotbext.spi import SpiBus, SpiConfig, SpiMaster  # noqa: E402


def spi_master(dut, bits, clocks):
    """Returns a master for words of this number of bits, each of so many clocks, as between words.
    """
    return SpiMaster(SpiBus.from_prefix(dut, "spi"), SpiConfig(
        word_width=bits, sclk_freq=1e8 / clocks, frame_spacing_ns=10 * clocks))
