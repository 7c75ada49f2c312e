# SPDX-License-Identifier: Apache-2.0
"""Boards, wires and what came of them: for wire_test.py and home_test.py."""

import csv
import heapq
import os
import pathlib
import random
import re
import select
import signal
import socket
import subprocess
import sys
import threading
import time
import zlib

CURVECORE = sys.argv[1]
STEPS_PER_MM = 400
STATE, EXPECT, SEQUENCE, CONTROL, SWITCHES, AXES = 0x18, 0x70, 0x74, 0x14, 0x84, 0x100
ENABLED = 1 << 16  # of STATE


def until(reached):
    """Asks until it is so; each question gives a fast board 5 ms.  ctest ends what never is."""
    while not reached():
        pass


class Board:
    """A virtual board."""

    def __init__(self, folder, *options, port=0):
        self.folder = folder
        self.process = subprocess.Popen(
            [CURVECORE, "board", "--listen", f"127.0.0.1:{port}", "-o", folder, *options],
            stdout=subprocess.PIPE, text=True)
        self.port = int(re.search(r":(\d+):", self.process.stdout.readline())[1])

    def end(self):
        """Its steps: (clock, axis, direction)."""
        self.process.send_signal(signal.SIGINT)
        self.process.wait()
        with open(pathlib.Path(self.folder) / "steps.csv", newline="", encoding="ascii") as file:
            return [tuple(map(int, row)) for row in list(csv.reader(file))[1:]]

    def kill(self):
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()


def command(flags, number, address, *words):
    return (flags | 0x4000 | number).to_bytes(2, "little") + address.to_bytes(2, "little") + (
        b"".join(word.to_bytes(4, "little") for word in words))


def read(port, address):
    """A register, as any program may read it."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as host:
        host.connect(("127.0.0.1", port))
        host.settimeout(1)
        while True:  # a board takes 256 frames that wait, no more
            host.send(command(0x200, 1, address))
            try:
                return int.from_bytes(host.recv(100), "little")
            except TimeoutError:
                pass


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
         "serial", "--set", "Splines=1", "--set", "Mode=1", "--clock", "2.56MHz",
         "--segment-queue", "4096", "--profile-queue", "1024", "--system",
         f"step={1000 / STEPS_PER_MM}um,steplen=2us,stepspace=2us,dirsetup=4us,dirhold=4us"],
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
                steps.append((round(now * 2.56e-6), axis, -1 if level[axis, "direction"] else 1))
    return steps


class Wire(threading.Thread):
    """Between a host and a board: delays datagrams, loses some, doubles some, and some overtake;
    changes what the board says."""

    def __init__(self, port, chance, delay, change=lambda answer: answer):
        super().__init__(daemon=True)
        self.board = ("127.0.0.1", port)
        self.chance, self.delay, self.change = chance, delay, change
        self.random = random.Random(7)
        self.near = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.near.bind(("127.0.0.1", 0))
        self.far = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.port = self.near.getsockname()[1]
        self.lost = self.doubled = 0
        self.start()

    def run(self):
        late, host, number = [], None, 0
        while True:
            wait = max(0, late[0][0] - time.monotonic()) if late else 1
            for end in select.select([self.near, self.far], [], [], wait)[0]:
                data, sender = end.recvfrom(65536)
                if end is self.near:
                    host = sender
                copies = 1
                if self.random.random() < self.chance:
                    copies, self.lost = 0, self.lost + 1
                elif self.random.random() < self.chance:
                    copies, self.doubled = 2, self.doubled + 1
                for _ in range(copies):
                    number += 1
                    quick = self.random.random() < self.chance
                    due = time.monotonic() + self.delay * (0.5 if quick else 1)
                    heapq.heappush(late, (due, number, end is self.near, data))
            while late and late[0][0] <= time.monotonic():
                _, _, to_board, data = heapq.heappop(late)
                if to_board:
                    self.far.sendto(data, self.board)
                elif host:
                    self.near.sendto(self.change(data), host)


def bridge(line, port):
    """Between a serial line, of which every 50th frame is broken, and a board behind UDP."""
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
