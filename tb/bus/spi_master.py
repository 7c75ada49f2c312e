# SPDX-License-Identifier: Apache-2.0
"""cocotbext-spi's master, 16 clocks of 10 ns a bit, and between words."""

import cocotb.clock
from cocotb.types import Logic

# What cocotbext-spi 0.5.0 imports of cocotb 1.
cocotb.clock.BaseClock = type("BaseClock", (), {
    "__init__": lambda self, signal: setattr(self, "signal", signal)})
Logic.integer = property(int)
from cocotbext.spi import SpiBus, SpiConfig, SpiMaster  # noqa: E402


def spi_master(dut, bits):
    """Of words of so many bits."""
    return SpiMaster(SpiBus.from_prefix(dut, "spi"), SpiConfig(
        word_width=bits, sclk_freq=1e9 / 160, frame_spacing_ns=160))
