# SPDX-License-Identifier: Apache-2.0
"""Wishbone as cocotbext-wishbone's master drives it, with random pauses between accesses."""

import logging
import os
import random

import cocotb
from clock import start_clock
from cocotb.triggers import RisingEdge
from cocotbext.wishbone.driver import WBOp, WishboneMaster
from register_model import Registers

ERR = 2


@cocotb.test()
async def every_access_is_answered_as_described(dut):
    dut.rst_n.value = 0
    # Icarus 11 loses what the master sets at time 0.
    for signal in (dut.wb_cyc, dut.wb_stb, dut.wb_we, dut.wb_adr, dut.wb_datwr, dut.wb_sel):
        signal.value = 0
    start_clock(dut.clk)
    await RisingEdge(dut.clk)
    names = {name: name for name in ("cyc", "stb", "we", "adr", "datwr", "datrd", "ack", "err",
                                     "sel")}
    master = WishboneMaster(dut, "wb", dut.clk, width=32, timeout=1000, signals_dict=names)
    master.log.setLevel(logging.WARNING)
    for _ in range(4):
        await RisingEdge(dut.clk)
    dut.rst_n.value = 1
    registers = Registers()
    chance = random.Random(2)
    errors = 0
    number = int(os.environ["ACCESSES"])
    todo = list(registers.accesses(number))
    while todo:
        count = chance.randint(1, 8)
        block, todo = todo[:count], todo[count:]
        expected = [registers.access(*access) for access in block]
        answers = await master.send_cycle([
            WBOp(adr=address // 4, dat=data if write else None, idle=chance.choice((0, 0, 1, 5)),
                 sel=15, acktimeout=1000) for write, address, data in block])
        assert len(answers) == len(block)
        for (write, address, _), (error, value), answer in zip(block, expected, answers):
            assert (answer.ack == ERR) == error, hex(address)
            assert error or write or int(answer.datrd) == value, hex(address)
            errors += error
    before, part, after = [(await master.send_cycle([WBOp(
        adr=9, dat=dat, sel=sel, idle=0, acktimeout=1000)]))[0] for dat, sel in (
            (None, 15), (5, 7), (None, 15))]
    assert part.ack == ERR and int(before.datrd) == int(after.datrd)
    assert number // 4 < errors < 3 * number // 4
    cocotb.log.info("%d accesses, %d errors as described", number, errors)
