# SPDX-License-Identifier: Apache-2.0
"""Two AXI4-Streams as cocotbext-axi's sources drive them, with pauses, among words of registers
into queues that are full at times: each word arrives once, in order, in its own queue."""

import itertools
import logging
import os
import random
from collections import deque

import cocotb
from clock import start_clock
from cocotb.triggers import FallingEdge, RisingEdge
from cocotbext.axi import AxiStreamBus, AxiStreamSource

NAMES = ("segment", "profile")
PATIENCE = 1000  # clocks without a word


def pauses(seed, share):
    chance = random.Random(seed)
    return (chance.random() < share for _ in itertools.repeat(None))


class Queue:
    """Words that a stream sends, and words that its queue receives."""

    def __init__(self, dut, name, words):
        self.source = AxiStreamSource(AxiStreamBus.from_prefix(dut, name), dut.clk, dut.rst_n,
                                      reset_active_level=False)
        self.source.set_pause_generator(pauses(name, 0.4))
        self.expected = deque(words)
        for word in words:
            self.source.send_nowait(word.to_bytes(8, "little"))
        self.asks = getattr(dut, f"{name}_register")
        self.room = getattr(dut, f"{name}_register_ready")
        self.valid = getattr(dut, f"{name}_valid")
        self.ready = getattr(dut, f"{name}_ready")


@cocotb.test()
async def every_word_arrives_once_and_in_order(dut):
    dut.rst_n.value = 0
    start_clock(dut.clk)
    logging.getLogger("cocotb.axi_stream_bench").setLevel(logging.WARNING)
    chance = random.Random(6)
    number = int(os.environ["ACCESSES"])
    queues = [Queue(dut, name, [chance.getrandbits(64) for _ in range(number // 2)])
              for name in NAMES]
    dut.words.value = 0
    dut.register_word.value = 0
    for queue in queues:
        queue.asks.value = queue.ready.value = 0
    for _ in range(4):
        await RisingEdge(dut.clk)
    dut.rst_n.value = 1
    came = refused = silent = 0
    while any(queue.expected for queue in queues):
        await RisingEdge(dut.clk)
        asks = chance.choice((0, 1, None, None, None, None, None, None))
        written = chance.getrandbits(48)
        dut.words.value = words = chance.random() < 0.9
        dut.register_word.value = written
        for n, queue in enumerate(queues):
            queue.asks.value = n == asks
            queue.ready.value = chance.random() < 0.6
        # Nothing changes from here to the next edge, which takes what is ready.
        await FallingEdge(dut.clk)
        silent += 1
        for n, queue in enumerate(queues):
            valid, ready = int(queue.valid.value), int(queue.ready.value)
            assert not valid or words, "Timeout: a word of a machine that is off"
            if n == asks:
                assert int(queue.room.value) == (words and ready), f"{n} says that it has room"
                assert valid == words, f"{n} has no word of its register"
                refused += not (words and ready)
            if not (valid and ready):
                continue
            expected = written if n == asks else queue.expected.popleft() % 2**48
            assert int(dut.word.value) == expected, f"{expected:x} in queue {n}"
            came += n != asks
            silent = 0
        assert silent < PATIENCE, "Timeout: no word"
    for _ in range(2):
        await RisingEdge(dut.clk)
    assert all(queue.source.idle() for queue in queues)
    assert refused > number // 100
    cocotb.log.info("%d words, %d of registers refused, as described", came, refused)
