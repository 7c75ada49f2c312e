# SPDX-License-Identifier: Apache-2.0
"""Boards, wires and their results, for wire_test.py and home_test.py."""

import contextlib
import csv
import json
import math
import os
import pathlib
import random
import re
import select
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import unittest
import zlib

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "formats"))
from check_json import flaw  # noqa: E402

CURVECORE = sys.argv[1]
STEPS_PER_MM = 400
STATE, EXPECT, SEQUENCE, CONTROL, SWITCHES, AXES = 0x18, 0x70, 0x74, 0x14, 0x84, 0x100
PATH_LO, PATH_HI = 0x60, 0x64
ENABLED = 1 << 16  # of STATE
QUANTA_PER_MM = 65536e6


def until(reached):
    """Asks until a condition holds; each question gives a fast board 5 ms. ctest ends a hang."""
    while not reached():
        pass


def report_of(folder):
    """The report of `stream`, as its schema says."""
    report = json.loads((pathlib.Path(folder) / "report.json").read_text(encoding="utf-8"))
    found = flaw("stream", report)
    if found:
        raise AssertionError(found)
    return report


class Board:
    """A virtual board."""

    def __init__(self, folder, *options, port=0):
        self.folder = folder
        self.process = subprocess.Popen(
            [CURVECORE, "board", "--listen", f"127.0.0.1:{port}", "-o", folder, *options],
            stdout=subprocess.PIPE, text=True)
        self.port = int(re.search(r":(\d+):", self.process.stdout.readline())[1])

    def end(self):
        """Returns its steps: (clock, axis, direction)."""
        self.process.send_signal(signal.SIGINT)
        self.process.wait()
        with open(pathlib.Path(self.folder) / "steps.csv", newline="", encoding="ascii") as file:
            return [tuple(map(int, row)) for row in list(csv.reader(file))[1:]]

    def kill(self):
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()


class WishTest(unittest.TestCase):
    """A test of `stream` with wishes on the way, in a folder of its own."""

    part_text = ""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.part = self.folder / "part.ngc"
        self.part.write_text(self.part_text, encoding="ascii")
        self.wishes = self.folder / "wishes"
        self.wishes.touch()

    def board(self, build):
        board = Board(str(self.folder / "board"), "--fast", "--build", build)
        self.addCleanup(board.kill)
        return board

    def stream(self, board, *options):
        return subprocess.Popen(
            [CURVECORE, "stream", self.part, "--to", f"udp:127.0.0.1:{board.port}", "-o",
             self.folder / "stream", *options],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def wish(self, text):
        with open(self.wishes, "a", encoding="ascii") as file:
            file.write(text + "\n")

    def end(self, host, status):
        """Text that the host printed, once it has ended with this status."""
        message = host.communicate()[1]
        self.assertEqual(host.returncode, status, message)
        return message


def command(flags, number, address, *words):
    return (flags | 0x4000 | number).to_bytes(2, "little") + address.to_bytes(2, "little") + (
        b"".join(word.to_bytes(4, "little") for word in words))


def read(port, address):
    """Reads a register, as any program may."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as host:
        host.connect(("127.0.0.1", port))
        host.settimeout(1)
        while True:  # a board takes 256 frames that wait, no more
            host.send(command(0x200, 1, address))
            try:
                return int.from_bytes(host.recv(100), "little")
            except TimeoutError:
                pass


def drawn_mm(port):
    """The path since the last flush."""
    low = read(port, PATH_LO)
    return (low | read(port, PATH_HI) << 32) / QUANTA_PER_MM


def numbered(port):
    """The beginning of a frame that is obeyed."""
    number = read(port, SEQUENCE)
    return command(0x8300, 1, EXPECT, number, (number + 1) % 2**32)


def counts(steps):
    return [sum(way for _, axis, way in steps if axis == n) for n in range(3)]


def times(steps):
    """Steps with their times from the first."""
    return [(clock - steps[0][0], axis, way) for clock, axis, way in steps]


def system_steps(part, folder):
    """Steps, as above, of the system in SystemC with the same core, queues and drives."""
    subprocess.run(
        [CURVECORE, "run", part, "-q", "-o", folder, "--on", "systemc", "--trace", "--build",
         "engine", "--set", "Splines=1", "--set", "Mode=1", "--clock", "5.12MHz",
         "--sample-period", "1600us", "--segment-queue", "4096", "--profile-queue", "1024",
         "--system", f"step={1000 / STEPS_PER_MM}um,steplen=2us,stepspace=2us,"
         "dirsetup=4us,dirhold=4us"],
        check=True)
    pins, level, now, steps = {}, {}, 0, []
    for line in (pathlib.Path(folder) / "system.vcd").read_text(encoding="ascii").split("\n"):
        words = line.split()
        if not words:
            continue
        if words[0] == "$scope":
            axis = "xyz".find(words[2])
        elif words[0] == "$var":
            pins[words[3]] = (axis, words[4])
        elif words[0][0] == "#":
            now = int(words[0][1:])  # ps
        elif words[0][1:] in pins and words[0][0] in "01":
            axis, pin = pins[words[0][1:]]
            level[axis, pin] = int(words[0][0])
            if pin == "step" and level[axis, pin]:
                steps.append((round(now * 5.12e-6), axis, -1 if level[axis, "direction"] else 1))
    return steps


class Wire(threading.Thread):
    """A wire between a host and a board: loses or doubles some datagrams, and lets some wait until
    others have overtaken them.  The fate of one follows from its number alone, not from time.

    `change` takes each answer, and returns its replacement.  Once an answer has a path of `gate_mm`
    the wire carries nothing to the board, until `open_gate` is called."""

    def __init__(self, port, chance=0, overtaken=0, change=lambda answer: answer, gate_mm=math.inf):
        super().__init__(daemon=True)
        self.chance, self.overtaken, self.change = chance, overtaken, change
        self.gate_quanta = gate_mm * QUANTA_PER_MM
        self.near = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.near.bind(("127.0.0.1", 0))
        self.far = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.far.connect(("127.0.0.1", port))
        self.port = self.near.getsockname()[1]
        self.lost = self.doubled = self.late = 0
        self.reached, self.opened = threading.Event(), threading.Event()
        self.start()

    def wait_for_gate(self):
        self.reached.wait()  # ctest ends what never is

    def open_gate(self):
        self.opened.set()

    def fates(self, data, chance, waiting):
        """Returns the datagrams to send now: this one, and those that waited for it to pass."""
        copies = [data]
        if chance.random() < self.chance:
            copies, self.lost = [], self.lost + 1
        elif chance.random() < self.chance:
            copies, self.doubled = [data, data], self.doubled + 1
        now = []
        for copy in copies:
            if chance.random() < 2 * self.chance and self.overtaken:
                waiting.append([chance.randint(1, self.overtaken) + 1, copy])
                self.late += 1
            else:
                now.append(copy)
        for late in waiting:
            late[0] -= 1
        now += [copy for left, copy in waiting if left == 0]
        waiting[:] = [late for late in waiting if late[0] > 0]
        return now

    def run(self):
        chances = {self.near: random.Random(7), self.far: random.Random(8)}
        waiting = {self.near: [], self.far: []}
        host = None
        while True:
            for end in select.select([self.near, self.far], [], [])[0]:
                try:
                    data, sender = end.recvfrom(65536)
                except ConnectionRefusedError:  # the board is gone
                    continue
                if end is self.near:
                    host = sender
                    if self.reached.is_set() and not self.opened.is_set():
                        continue
                else:
                    self.look(data)
                for copy in self.fates(data, chances[end], waiting[end]):
                    if end is self.near:
                        with contextlib.suppress(ConnectionRefusedError):
                            self.far.send(copy)
                    elif host:
                        self.near.sendto(self.change(copy), host)

    def look(self, answer):
        """STATE, AXES, PATH and more: what `stream` reads with each frame."""
        if 32 <= len(answer) <= 48:
            quanta = int.from_bytes(answer[8:16], "little")
            if quanta >= self.gate_quanta:
                self.reached.set()


def bridge(line, port):
    """A bridge between a serial line, which breaks every 50th frame, and a board behind UDP."""
    held, frames = b"", 0
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as board:
        board.connect(("127.0.0.1", port))
        while True:
            for end in select.select([line, board], [], [])[0]:
                if end is board:
                    whole = board.recv(65536)
                    whole += zlib.crc32(whole).to_bytes(4, "little")
                    os.write(line, whole.replace(b"\xdb", b"\xdb\xdd").replace(b"\xc0", b"\xdb\xdc")
                             + b"\xc0")
                    continue
                held += os.read(line, 4096)
                *whole, held = held.split(b"\xc0")
                for frame in whole:
                    frame = frame.replace(b"\xdb\xdc", b"\xc0").replace(b"\xdb\xdd", b"\xdb")
                    frames += 1
                    if frames % 50 == 0:
                        frame = frame[:1] + bytes([frame[1] ^ 4]) + frame[2:]
                    if zlib.crc32(frame[:-4]).to_bytes(4, "little") == frame[-4:]:
                        board.send(frame[:-4])
