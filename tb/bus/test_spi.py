# SPDX-License-Identifier: Apache-2.0
"""SPI as cocotbext-spi's master drives it: frames of two words each, one after the other."""

import os
import random

import cocotb
from clock import start_clock
from cocotb.triggers import RisingEdge
from register_model import Registers
from spi_master import spi_master

STATUS = 0xA0
BITS = 8 + 2 * 40


@cocotb.test()
async def every_access_is_answered_as_described(dut):
    dut.rst_n.value = 0
    start_clock(dut.clk)
    await RisingEdge(dut.clk)
    master = spi_master(dut, BITS, clocks=16)
    for _ in range(4):
        await RisingEdge(dut.clk)
    dut.rst_n.value = 1
    for _ in range(200):
        await RisingEdge(dut.clk)
    registers = Registers()
    chance = random.Random(3)
    number = int(os.environ["ACCESSES"])
    before = 0  # the access before was an error
    errors = 0
    for write, address, data in registers.accesses(number // 2):
        more = chance.getrandbits(32)
        words = (data, more) if write else (0, 0)
        frame = write << 87 | (address // 4) << 80 | words[0] << 40 | words[1]
        expected = [registers.access(write, (address + 4 * n) % 512, words[n]) for n in (0, 1)]
        await master.write([frame])
        answer = (await master.read())[0]
        for (error, value), low in zip(expected, (40, 0)):
            assert answer >> low + 32 & 0xFF == STATUS | before, hex(address)
            if not write and not error:
                assert answer >> low & 0xFFFFFFFF == value, hex(address)
            before = int(error)
            errors += before
    assert number // 4 < errors < 3 * number // 4
    cocotb.log.info("%d accesses, %d errors as described", number, errors)
