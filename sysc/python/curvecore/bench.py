# SPDX-License-Identifier: Apache-2.0
"""A motion_interpolator in a cocotb bench: a part's words in, every sample held to the kernel's.

    @cocotb.test()
    async def draws_the_part(dut):
        part = curvecore.plan("part.ngc", set={"Order": 2, "CoefBits": 18})
        await MotionBench(dut, part).check()

The plan's parameters are those of the module.
"""

from __future__ import annotations

import collections
import random
from typing import Any

from cocotb.clock import Clock
from cocotb.triggers import RisingEdge
import cocotb
import numpy

from curvecore import Drawn, Plan

PATIENCE = 1 << 14  # clocks without a sample


class MotionBench:
    """Drives the ports of rtl/motion_interpolator.sv and takes its samples.

    part   curvecore.Plan
    stall  share of clocks in which a stream of words, or who takes samples, pauses
    """

    def __init__(self, dut: Any, part: Plan, stall: float = 0, seed: int = 1) -> None:
        self.dut, self.part, self.stall = dut, part, stall
        self.random = random.Random(seed)
        self.samples = 0  # that were compared
        self._of_program: collections.deque[int] = collections.deque()  # of samples on their way
        self._loaded = {"segment": False, "profile": False}

    async def check(self, samples: int | None = None) -> None:
        """Draws the part, or its first samples. Raises AssertionError at the first word that
        differs, and where no sample comes."""
        drawn = self.part.draw()
        wanted = len(drawn.position) - 1 if samples is None else samples
        await self._begin()
        for name, words in (("segment", self.part.segment_words),
                            ("profile", self.part.profile_words)):
            cocotb.start_soon(self._send(name, words))
        dut, requested, waited = self.dut, 0, 0
        while self.samples < wanted:
            await self._clock()
            if int(dut.sample_request_valid_i.value) and int(dut.sample_request_ready_o.value):
                requested += 1
            # Time starts once the queues are full, or have all: an underrun would stop it.
            dut.sample_request_valid_i.value = int(all(self._loaded.values())
                                                   and requested < wanted)
            if int(dut.path_valid_o.value):
                self._of_program.append(int(dut.path_active_o.value))
            if int(dut.sample_valid_o.value) and int(dut.sample_ready_i.value):
                waited = 0
                if self._of_program.popleft():
                    self._compare(drawn)
                else:
                    requested -= 1  # the axes stood: its words did not cover a stop yet
            dut.sample_ready_i.value = int(not self._pauses())
            waited += 1
            assert waited < PATIENCE, (f"no sample {self.samples + 1} for {waited} clocks: fault_o"
                                       f" is {int(dut.fault_o.value):#04x}")

    def _compare(self, drawn: Drawn) -> None:
        self.samples += 1
        for port, bits, rows in (
                (self.dut.sample_position_o, self._bits(), drawn.position),
                (self.dut.sample_fine_o, self._bits() + self.part.parameters["GuardBits"],
                 drawn.fine)):
            value = int(port.value)
            for axis, expected in enumerate(rows[self.samples].tolist()):
                word = value >> axis * bits & (1 << bits) - 1
                word -= word >> bits - 1 << bits
                assert word == expected, (f"sample {self.samples}, axis {axis}: {port._name} is"
                                          f" {word}, the kernel's {expected}")

    def _bits(self) -> int:
        return self.part.parameters["PositionBits"]

    def _pauses(self) -> bool:
        return self.stall > 0 and self.random.random() < self.stall

    async def _clock(self) -> None:
        await RisingEdge(self.dut.clk_i)

    async def _begin(self) -> None:
        """Starts the clock, sets the settings and resets."""
        dut = self.dut
        for name in ("segment_valid_i", "profile_valid_i", "sample_request_valid_i", "hold_i",
                     "kill_i", "segment_data_i", "profile_data_i", "sample_ready_i", "rst_ni"):
            getattr(dut, name).value = 0
        for name, value in self.part.settings.items():
            getattr(dut, f"{name}_i").value = value
        cocotb.start_soon(Clock(dut.clk_i, 10, "ns").start())
        for _ in range(10):
            await self._clock()
        dut.rst_ni.value = 1

    async def _send(self, name: str, words: numpy.ndarray) -> None:
        valid, ready, data = (getattr(self.dut, f"{name}_{port}")
                              for port in ("valid_i", "ready_o", "data_i"))
        for word in words.tolist():
            while self._pauses():
                await self._clock()
            data.value = word
            valid.value = 1
            await self._clock()
            while not int(ready.value):
                self._loaded[name] = True
                await self._clock()
            valid.value = 0
        self._loaded[name] = True
