# SPDX-License-Identifier: Apache-2.0
"""Frames over a line of bytes (lines.py), some lost, doubled, broken or nonsense."""

import os
import random
import zlib

import cocotb
from clock import start_clock
from cocotb.triggers import RisingEdge
from lines import line_of
from register_model import Registers

END, ESCAPE, ESCAPED_END, ESCAPED_ESCAPE = b"\xc0", b"\xdb", b"\xdb\xdc", b"\xdb\xdd"
NOTHING = 2 * ESCAPE  # of a line that cannot wait
EXPECT, SEQUENCE, IDENTITY = 0x70, 0x74, 0x00
WRITE, ADDRESS, WORDS, PAIRS, INCREMENT = 0x8000, 0x4000, 0x200, 0x300, 0x80
LONGEST = 251
PATIENCE = 2000  # bytes


def slip(frame):
    whole = frame + zlib.crc32(frame).to_bytes(4, "little")
    return whole.replace(ESCAPE, ESCAPED_ESCAPE).replace(END, ESCAPED_END) + END


def unslip(line):
    whole = line[:-1].replace(NOTHING, b"")
    whole = whole.replace(ESCAPED_END, END).replace(ESCAPED_ESCAPE, ESCAPE)
    assert zlib.crc32(whole[:-4]).to_bytes(4, "little") == whole[-4:], whole.hex()
    return whole[:-4]


def command(flags, number, address, *words):
    return (flags | ADDRESS | number).to_bytes(2, "little") + address.to_bytes(2, "little") + (
        b"".join(word.to_bytes(4, "little") for word in words))


def write(address, word):
    return command(WRITE | WORDS, 1, address, word)


def number(before, after):
    """Begin of a frame that is obeyed if its number is the board's."""
    return command(WRITE | PAIRS, 1, EXPECT, before, after)


class Host:
    """Sends frames and knows their expected answers."""

    def __init__(self, dut):
        self.line = line_of(dut)
        self.registers = Registers()
        self.sequence = 0
        self.chance = random.Random(5)
        self.accesses = self.errors = 0

    async def send(self, line):
        await self.line.write(line)

    async def answer(self):
        line = b""
        for _ in range(PATIENCE):
            line += await self.line.byte()
            if line == END:  # nothing
                line = b""
            if line.endswith(END):
                return unslip(line)
        raise AssertionError("Timeout: no answer")

    def access(self, is_write, address, data=0):
        """Returns the model's answer, 4 bytes a read."""
        self.accesses += 1
        error, value = self.registers.access(is_write, address, data)
        self.errors += error
        return b"" if is_write else None if error else value.to_bytes(4, "little")

    def commands(self, obeyed, number):
        """Returns random commands as bytes, and their answers; None: any answer."""
        frame, answers = b"", []
        for is_write, address, data in self.registers.accesses(number, self.chance.random()):
            if address in (EXPECT, SEQUENCE):
                continue
            pairs = address % 8 == 0 and self.chance.random() < 0.5
            increment = self.chance.random() < 0.5
            count = self.chance.randrange(3)
            step = 8 if pairs else 4
            places = [(address + (step * n if increment else 0) + half) % 512
                      for n in range(count) for half in ((0, 4) if pairs else (0,))]
            if any(place in (EXPECT, SEQUENCE) for place in places):
                continue
            if len(frame) + 4 + 4 * len(places) > LONGEST - 12:  # beside its number
                break
            flags = (PAIRS if pairs else WORDS) | (INCREMENT if increment else 0)
            if is_write:
                words = [self.chance.getrandbits(32) ^ data for _ in places]
                frame += command(WRITE | flags, count, address, *words)
                for place, word in zip(places, words):
                    if obeyed:
                        self.access(True, place, word)
            else:
                frame += command(flags, count, address)
                answers += [self.access(False, place) for place in places]
        return frame, answers


async def start(dut):
    dut.rst_n.value = 0
    start_clock(dut.clk)
    host = Host(dut)
    for _ in range(4):
        await RisingEdge(dut.clk)
    dut.rst_n.value = 1
    for _ in range(200):
        await RisingEdge(dut.clk)
    return host


async def check(host, frame, answers):
    await host.send(slip(frame))
    if not answers:
        return
    answer = await host.answer()
    assert len(answer) == 4 * len(answers), (answer.hex(), frame.hex())
    for n, expected in enumerate(answers):
        assert expected is None or answer[4 * n:4 * n + 4] == expected, (n, frame.hex())


async def check_sequence(host):
    await check(host, command(WORDS, 1, SEQUENCE), [host.sequence.to_bytes(4, "little")])


@cocotb.test()
async def every_frame_is_obeyed_once_and_answered_as_described(dut):
    host = await start(dut)
    while host.accesses < int(os.environ["ACCESSES"]):
        kind = host.chance.randrange(5)
        after = host.chance.getrandbits(32)
        if kind == 0:  # not in order
            wrong = host.sequence ^ 1 << host.chance.randrange(32)
            frame, answers = host.commands(False, 5)
            await check(host, number(wrong, after) + frame, answers)
        elif kind == 1:  # without a number
            await check(host, *host.commands(False, 5))
        else:
            frame, answers = host.commands(True, 5)
            frame = number(host.sequence, after) + frame
            await check(host, frame, answers)
            host.sequence = after
            if kind == 2:  # doubled: the same reads, no write
                await host.send(slip(frame))
                if answers:
                    await host.answer()
        if host.chance.random() < 0.1:
            await check_sequence(host)
    assert host.accesses // 8 < host.errors < 4 * host.accesses // 5
    cocotb.log.info("%d accesses, %d errors as described", host.accesses, host.errors)


@cocotb.test()
async def answers_wait_for_writes_between_reads(dut):
    host = await start(dut)
    for writes in (1, 16, 20, 27):
        before, after = host.sequence, host.chance.getrandbits(32)
        read = command(WORDS, 1, SEQUENCE)
        frame = number(before, after) + read + writes * write(IDENTITY, 0) + read
        await check(host, frame, 2 * [after.to_bytes(4, "little")])
        host.sequence = after


@cocotb.test()
async def what_is_broken_changes_nothing(dut):
    host = await start(dut)
    values = {address: word["value"] for address, word in host.registers.words.items()
              if word["write"] and word["read"]}
    for _ in range(int(os.environ["ACCESSES"]) // 10):
        frame = number(host.sequence, 7) + b"".join(
            write(host.chance.choice(list(values)), host.chance.getrandbits(32)) for _ in range(3))
        line = bytearray(slip(frame))
        kind = host.chance.randrange(4)
        if kind == 0:
            line[host.chance.randrange(len(line) - 1)] ^= 1 << host.chance.randrange(8)
        elif kind == 1:
            del line[host.chance.randrange(len(line) - 1)]
        elif kind == 2:
            line = line[:host.chance.randrange(len(line) - 1)] + END
        else:  # too long
            line = bytearray(slip(frame + bytes(LONGEST + 1 - len(frame))))
        await host.send(bytes(line))
    await check_sequence(host)
    for address, value in values.items():
        await check(host, command(WORDS, 1, address), [value.to_bytes(4, "little")])
    assert await host.line.silent()


@cocotb.test()
async def nonsense_in_whole_frames_ends(dut):
    host = await start(dut)
    for _ in range(int(os.environ["ACCESSES"]) // 10):
        frame = host.chance.randbytes(host.chance.randrange(1, 40))
        await host.send(slip(frame))
        await check_behind(host)


@cocotb.test()
async def a_frame_that_is_cut_is_answered(dut):
    host = await start(dut)
    for cut in range(1, 8):
        before, after = host.sequence, host.chance.getrandbits(32)
        read = command(WORDS, 1, SEQUENCE)
        frame = number(before, after) + read + write(IDENTITY, 0)[:-cut]
        await host.send(slip(frame))
        answer = await host.answer()
        assert len(answer) == 8 and answer[:4] == after.to_bytes(4, "little"), (cut, answer.hex())
        host.sequence = after
        await check_sequence(host)


async def check_behind(host):
    """The number is answered, whatever frames without one were before it."""
    await host.send(slip(command(WORDS, 2, IDENTITY) + command(WORDS, 1, SEQUENCE)))
    answer = await host.answer()
    while answer[:8] != 2 * b"1MVC" or len(answer) != 12:
        answer = await host.answer()
