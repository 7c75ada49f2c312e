# SPDX-License-Identifier: Apache-2.0
"""A user's bench of a changed copy of the RTL: cocotb runs it."""

import os

import cocotb
import curvecore
from curvecore.bench import MotionBench


def part():
    return curvecore.plan(os.environ["PART"], set={"Order": 2, "CoefBits": 18, "Splines": 1},
                          unit="1um", holds="bounds", sample_period="1ms")


@cocotb.test()
async def draws_the_part(dut):
    bench = MotionBench(dut, part())
    await bench.check()
    assert bench.samples > 100


@cocotb.test()
async def draws_it_with_stalls(dut):
    await MotionBench(dut, part(), stall=0.3).check(samples=60)
