# SPDX-License-Identifier: Apache-2.0
"""A program through AXI: settings by cocotbext-axi's AXI4-Lite master, words by two of its
AXI4-Streams, all with pauses; the pins give the programmed steps."""

import itertools
import json
import logging
import os
import pathlib
import random

import cocotb
from clock import start_clock
from cocotb.triggers import ClockCycles, RisingEdge, ValueChange
from cocotbext.axi import AxiLiteBus, AxiLiteMaster, AxiResp, AxiStreamBus, AxiStreamSource

with open(os.environ["REGISTERS_JSON"], encoding="ascii") as file:
    DESCRIPTION = json.load(file)
REGISTERS = {register["name"]: register for register in DESCRIPTION["registers"]}
WORDS = pathlib.Path(os.environ["WORDS"])
PLAN = json.loads((WORDS / "words.json").read_text(encoding="utf-8"))
STEPS_PER_MM = 4000
POSITION_BITS = 32


def pauses(seed, share):
    chance = random.Random(seed)
    return (chance.random() < share for _ in itertools.repeat(None))


def words_of(name):
    """Converts words to bytes of TDATA; upper bits are ignored."""
    lines = (WORDS / PLAN[name]["file"]).read_text(encoding="ascii").split("\n")
    words = [int(line, 16) for line in lines if line and not line.startswith("//")]
    return [(word | 0xABCD << 48).to_bytes(8, "little") for word in words]


class Host:
    def __init__(self, dut):
        self.master = AxiLiteMaster(AxiLiteBus.from_prefix(dut, "s_axi"), dut.clk, dut.rst_n,
                                    reset_active_level=False)
        for seed, channel in enumerate((self.master.write_if.w_channel,
                                        self.master.read_if.r_channel)):
            channel.set_pause_generator(pauses(seed, 0.3))

    async def write(self, name, word, offset=0):
        address = REGISTERS[name]["address"] + offset
        answer = await self.master.write(address, word.to_bytes(4, "little"))
        assert answer.resp == AxiResp.OKAY, name

    async def read(self, name, offset=0):
        answer = await self.master.read(REGISTERS[name]["address"] + offset, 4)
        assert answer.resp == AxiResp.OKAY, name
        return int.from_bytes(answer.data, "little")

    async def state(self, field):
        word = await self.read("STATE")
        low = next(f["low"] for f in REGISTERS["STATE"]["fields"] if f["name"] == field)
        assert word & 0xFFFF == 0, hex(word)
        return word >> low & 1

    async def prepare(self, axes):
        scale = round(STEPS_PER_MM * PLAN["unit_mm"] * 2 ** (POSITION_BITS + 16))
        for axis in range(axes):
            offset = axis * DESCRIPTION["axes"]["stride"]
            await self.write("SCALE_LO", scale % 2**32, offset)
            await self.write("SCALE_HI", scale >> 32, offset)
        await self.write("TIMING", PLAN["samples_per_tick_log2"])
        await self.write("HOLD_ACCELERATION", PLAN["hold_acceleration"])
        await self.write("HOLD_SLOPE", PLAN["hold_slope"] % 2**32)
        await self.write("STOP_TICKS", PLAN["stop_ticks"])
        await self.write("DIGEST", PLAN["digest_register"])
        await self.write("REFERENCE", (1 << axes) - 1)
        await self.write("CONTROL", 1)


async def count_steps(dut, counts):
    """Counts steps at the pins of all axes."""
    before = 0
    while True:
        await ValueChange(dut.step)
        step, direction = int(dut.step.value), int(dut.direction.value)
        for axis in range(len(counts)):
            if (step & ~before) >> axis & 1:
                counts[axis] += -1 if direction >> axis & 1 else 1
        before = step


@cocotb.test()
async def streams_draw_a_program(dut):
    dut.rst_n.value = 0
    start_clock(dut.clk)
    host = Host(dut)
    logging.getLogger("cocotb.motion_axi_bench").setLevel(logging.WARNING)
    sources = {}
    for seed, name in enumerate(("segment", "profile")):
        sources[name] = AxiStreamSource(AxiStreamBus.from_prefix(dut, name), dut.clk, dut.rst_n,
                                        reset_active_level=False)
        sources[name].set_pause_generator(pauses(seed + 7, 0.5))
    await ClockCycles(dut.clk, 4)
    dut.rst_n.value = 1
    words = {"segment": words_of("segments"), "profile": words_of("profile")}
    # They wait until the machine is on.
    for name, source in sources.items():
        for word in words[name]:
            source.send_nowait(word)
    for _ in range(300):
        await RisingEdge(dut.clk)
        assert dut.segment_tready.value == 0 and dut.profile_tready.value == 0
    counts = [0, 0, 0]
    cocotb.start_soon(count_steps(dut, counts))
    await host.prepare(3)
    for source in sources.values():
        await source.wait()
    path, polls = 0, 0
    while await host.state("active") or path != PLAN["path_quanta"]:
        polls += 1
        assert polls < 2 * 256 * PLAN["samples"] // 1000, "stands before the end"
        await ClockCycles(dut.clk, 1000)
        path = await host.read("PATH_LO")
        path += await host.read("PATH_HI") << 32
    await ClockCycles(dut.clk, 20 * 256)
    end = [round(float(place) * STEPS_PER_MM) for place in os.environ["END"].split()]
    assert counts == end
    cocotb.log.info("%d words, %s steps", sum(map(len, words.values())), end)
