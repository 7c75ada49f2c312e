# SPDX-License-Identifier: Apache-2.0
"""Bytes to and from a bench, by masters from other projects."""

from collections import deque

from cocotb.triggers import with_timeout
from cocotbext.uart import UartSink, UartSource
from spi_master import spi_master

BAUD = 12_500_000  # 8 clocks of 10 ns a bit
IDLE = 0xC0


class UartLine:
    def __init__(self, dut):
        self.source = UartSource(dut.rx, baud=BAUD, bits=8)
        self.sink = UartSink(dut.tx, baud=BAUD, bits=8)

    async def write(self, data):
        await self.source.write(data)
        await self.source.wait()

    async def byte(self):
        return bytes(await with_timeout(self.sink.read(1), 100, "us"))

    async def silent(self):
        return self.sink.empty()


class SpiLine:
    """A line that works both ways at once: a listener sends idle bytes."""

    def __init__(self, dut):
        self.master = spi_master(dut, 8, clocks=12.5)
        self.received = deque()
        self.last = IDLE

    async def write(self, data):
        await self.master.write(data, burst=True)
        for byte in await self.master.read():
            if byte != IDLE or self.last != IDLE:
                self.received.append(byte)
            self.last = byte

    async def byte(self):
        if not self.received:
            await self.write(bytes([IDLE]) * 8)
        return bytes([self.received.popleft()])

    async def silent(self):
        await self.write(bytes([IDLE]) * 300)
        return not self.received


def line_of(dut):
    return SpiLine(dut) if hasattr(dut, "spi_sclk") else UartLine(dut)
