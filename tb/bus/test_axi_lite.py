# SPDX-License-Identifier: Apache-2.0
"""AXI4-Lite as cocotbext-axi's master drives it, with pauses on every channel."""

import itertools
import logging
import os
import random

import cocotb
from clock import start_clock
from cocotb.triggers import RisingEdge
from cocotbext.axi import AxiLiteBus, AxiLiteMaster, AxiResp
from register_model import Registers


def pauses(seed, share):
    chance = random.Random(seed)
    return (chance.random() < share for _ in itertools.repeat(None))


@cocotb.test()
async def every_access_is_answered_as_described(dut):
    dut.rst_n.value = 0
    start_clock(dut.clk)
    master = AxiLiteMaster(AxiLiteBus.from_prefix(dut, "s_axi"), dut.clk, dut.rst_n,
                           reset_active_level=False)
    logging.getLogger("cocotb.axi_lite_bench").setLevel(logging.WARNING)
    for seed, channel in enumerate((master.write_if.aw_channel, master.write_if.w_channel,
                                    master.write_if.b_channel, master.read_if.ar_channel,
                                    master.read_if.r_channel)):
        channel.set_pause_generator(pauses(seed, 0.3))
    for _ in range(4):
        await RisingEdge(dut.clk)
    dut.rst_n.value = 1
    registers = Registers()
    errors = 0
    number = int(os.environ["ACCESSES"])
    for write, address, data in registers.accesses(number):
        error, value = registers.access(write, address, data)
        if write:
            answer = await master.write(address, data.to_bytes(4, "little"))
        else:
            answer = await master.read(address, 4)
            assert error or int.from_bytes(answer.data, "little") == value, hex(address)
        assert (answer.resp == AxiResp.SLVERR) == error, hex(address)
        errors += error
    # A part of a word is refused, and changes nothing.
    before = await master.read(0x24, 4)
    part = await master.write(0x25, b"\x01")
    after = await master.read(0x24, 4)
    assert part.resp == AxiResp.SLVERR and before.data == after.data
    # Reads and writes at once.
    both = [cocotb.start_soon(master.write(0x24, n.to_bytes(4, "little"))) for n in range(50)]
    both += [cocotb.start_soon(master.read(0x00, 4)) for n in range(50)]
    for task in both:
        await task
    assert number // 4 < errors < 3 * number // 4
    cocotb.log.info("%d accesses, %d errors as described", number, errors)
