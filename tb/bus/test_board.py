# SPDX-License-Identifier: Apache-2.0
"""A board starts by itself, reports its table's values over its UART, and sees its switches."""

import json
import os

import cocotb
from clock import start_clock
from cocotb.triggers import ClockCycles, with_timeout
from cocotbext.uart import UartSink, UartSource
from synthesis.boards import board_named
from test_frames import END, WORDS, command, slip, unslip

BOARD = board_named(os.environ["BOARD"])
with open(os.environ["REGISTERS_JSON"], encoding="ascii") as file:
    REGISTERS = {register["name"]: register for register in json.load(file)["registers"]}


class Host:
    def __init__(self, dut):
        self.source = UartSource(dut.uart_rx, baud=BOARD.baud, bits=8)
        self.sink = UartSink(dut.uart_tx, baud=BOARD.baud, bits=8)

    async def read(self, name):
        """The fields of a register."""
        register = REGISTERS[name]
        await self.source.write(slip(command(WORDS, 1, register["address"])))
        line = b""
        while not line.endswith(END):
            line += bytes(await with_timeout(self.sink.read(1), 1, "ms"))
        word = int.from_bytes(unslip(line), "little")
        return {field["name"]: word >> field["low"] & (1 << field["bits"]) - 1
                for field in register["fields"]}


@cocotb.test()
async def says_what_it_is_and_sees_its_switches(dut):
    start_clock(dut.clk, 2 * round(5e11 / BOARD.clock_hz), "ps")
    dut.estop.value = 0
    dut.limit.value = 0
    host = Host(dut)
    await ClockCycles(dut.clk, 400)
    identity = REGISTERS["ID"]["fields"][0]
    assert await host.read("ID") == {identity["name"]: identity["reset"]}
    assert await host.read("CLOCK") == {"hertz": BOARD.clock_hz}
    capability = await host.read("CAPABILITY")
    assert capability["axes"] == BOARD.axes
    assert capability["period_log2"] == int(BOARD.parameters["PeriodLog2"])
    assert capability["build"] + 2 * capability["engine"] == int(BOARD.parameters["Build"])
    assert (await host.read("STATE"))["estop_pin"] == 0
    dut.estop.value = 1
    dut.limit.value = 0b010
    assert (await host.read("STATE"))["estop_pin"] == 1
    assert (await host.read("AXES"))["limit"] == 0b010
    assert dut.enable.value == 0
    assert dut.step.value == 0
