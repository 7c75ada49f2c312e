#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`curvecore stream` and `curvecore board`, each other's only acquaintance, over a bad wire.

    wire_test.py CURVECORE [unittest's options]
"""

import csv
import heapq
import json
import math
import os
import pathlib
import pty
import random
import re
import select
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import tty
import unittest
import zlib

CURVECORE = ""
STEPS_PER_MM = 400
RADIUS = 20
# 20 mm along X, a quarter turn around (20, 20), 20 mm along Y.
PART = f"G21 G90 G61\nG1 X20 F2400\nG3 X40 Y20 I0 J{RADIUS}\nG1 Y40\nM2\n"
END = (40, 40, 0)
STATE, EXPECT, SEQUENCE, CONTROL = 0x18, 0x70, 0x74, 0x14
WATCHDOG, STANDING, ENABLED = 1 << 1, 1 << 19, 1 << 16


def off_path(x, y):
    """Distance from PART's path, mm."""
    line = math.hypot(x - min(max(x, 0), 20), y)
    arc = abs(math.hypot(x - 20, y - RADIUS) - RADIUS) if x >= 20 and y <= 20 else math.inf
    up = math.hypot(x - 40, y - min(max(y, 20), 40))
    return min(line, arc, up)


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
        self.process.wait(timeout=20)
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
        host.settimeout(5)
        host.sendto(command(0x200, 1, address), ("127.0.0.1", port))
        return int.from_bytes(host.recv(100), "little")


def numbered(port):
    """The beginning of a frame that is obeyed."""
    number = read(port, SEQUENCE)
    return command(0x8300, 1, EXPECT, number, (number + 1) % 2**32)


def counts(steps):
    return [sum(way for _, axis, way in steps if axis == n) for n in range(3)]


def times(steps):
    """Steps with their times from the first."""
    return [(clock - steps[0][0], axis, way) for clock, axis, way in steps]


class Wire(threading.Thread):
    """Between a host and a board: delays datagrams, loses some, doubles some, and some overtake."""

    def __init__(self, port, chance, delay):
        super().__init__(daemon=True)
        self.board = ("127.0.0.1", port)
        self.chance, self.delay = chance, delay
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
                    self.near.sendto(data, host)


class WireTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.part = self.folder / "part.ngc"
        self.part.write_text(PART, encoding="ascii")

    def board(self, *options, name="board", port=0):
        board = Board(str(self.folder / name), *options, port=port)
        self.addCleanup(board.kill)
        return board

    def stream(self, to, *options):
        return subprocess.Popen(
            [CURVECORE, "stream", str(self.part), "--to", to, "-q", "-o",
             str(self.folder / "stream"), *options],
            stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def finish(self, host, status=0, text=""):
        _, message = host.communicate(timeout=120)
        self.assertEqual(host.returncode, status, message)
        self.assertIn(text, message)

    def report(self):
        return json.loads((self.folder / "stream/report.json").read_text(encoding="utf-8"))

    def wait_for_path(self, port, mm):
        """Until the board has drawn so much; quanta of 2^-16 nm."""
        end = time.monotonic() + 60
        while read(port, 0x60) + (read(port, 0x64) << 32) < mm * 1e6 * 65536:
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)

    def draw(self, *options, through=None, name="board"):
        board = self.board(*options, name=name)
        wire = through(board.port) if through else board
        self.finish(self.stream(f"udp:127.0.0.1:{wire.port}"))
        return board.end(), wire

    def test_part_is_drawn(self):
        steps, _ = self.draw("--fast")
        self.assertEqual(counts(steps), [STEPS_PER_MM * mm for mm in END])
        report = self.report()
        self.assertEqual(report["drawn"]["steps"], counts(steps))
        self.assertEqual(report["drawn"]["path_quanta"], report["planned"]["path_quanta"])
        self.assertFalse(report["drawn"]["held"])

    def test_bad_wire_changes_no_step(self):
        expected, _ = self.draw(name="good")
        steps, wire = self.draw(through=lambda port: Wire(port, 0.1, 0.05), name="bad")
        self.assertGreater(wire.lost, 20)
        self.assertGreater(wire.doubled, 20)
        self.assertGreater(self.report()["link"]["repeated"], 0)
        self.assertEqual(times(steps), times(expected))

    def test_hold_and_resume_keep_the_path(self):
        control = self.folder / "control"
        control.touch()
        board = self.board()
        host = self.stream(f"udp:127.0.0.1:{board.port}", "--control", str(control))
        self.wait_for_path(board.port, 10)
        with control.open("a", encoding="ascii") as file:
            file.write("hold\nsome words\n")
        end = time.monotonic() + 30
        while not read(board.port, STATE) & STANDING:
            self.assertLess(time.monotonic(), end)
        with control.open("a", encoding="ascii") as file:
            file.write("override 50\nresume\n")
        self.finish(host, text="'some words' is none of")
        self.assertTrue(self.report()["drawn"]["held"])
        steps = board.end()
        self.assertEqual(counts(steps), [STEPS_PER_MM * mm for mm in END])
        self.check_path(steps)

    def check_path(self, steps):
        place = [0, 0, 0]
        for _, axis, way in steps:
            place[axis] += way
            self.assertLess(off_path(place[0] / STEPS_PER_MM, place[1] / STEPS_PER_MM),
                            2 / STEPS_PER_MM)

    def test_killed_host_leaves_a_machine_that_stands_on_the_path(self):
        board = self.board()
        host = self.stream(f"udp:127.0.0.1:{board.port}")
        self.wait_for_path(board.port, 25)
        host.kill()
        host.communicate()
        end = time.monotonic() + 30
        while not read(board.port, STATE) & STANDING:
            self.assertLess(time.monotonic(), end)
            # The board counts any reader as life.
            time.sleep(1)
        self.assertTrue(read(board.port, STATE) & WATCHDOG)
        self.assertTrue(read(board.port, STATE) & ENABLED)
        steps = board.end()
        self.assertLess(sum(counts(steps)), sum(END) * STEPS_PER_MM)
        self.check_path(steps)
        # It became slower step by step.
        waits = [b[0] - a[0] for a, b in zip(steps, steps[1:])]
        self.assertGreater(min(waits[-5:]), 4 * sorted(waits)[len(waits) // 2])

    def test_interrupted_host_stops_on_the_path(self):
        board = self.board()
        host = self.stream(f"udp:127.0.0.1:{board.port}")
        self.wait_for_path(board.port, 25)
        host.send_signal(signal.SIGINT)
        self.finish(host, 130)
        report = self.report()
        self.assertEqual(report["end"], "stopped")
        self.assertLess(report["drawn"]["path_quanta"], report["planned"]["path_quanta"])
        steps = board.end()
        self.assertEqual(report["drawn"]["steps"], counts(steps))
        self.check_path(steps)

    def test_estop_is_told(self):
        control = self.folder / "control"
        control.touch()
        board = self.board()
        host = self.stream(f"udp:127.0.0.1:{board.port}", "--control", str(control))
        self.wait_for_path(board.port, 10)
        with control.open("a", encoding="ascii") as file:
            file.write("estop\n")
        self.finish(host, 1, "the board stopped: e-stop")
        self.assertFalse(read(board.port, STATE) & ENABLED)

    def test_restarted_board_is_noticed(self):
        board = self.board()
        host = self.stream(f"udp:127.0.0.1:{board.port}")
        self.wait_for_path(board.port, 10)
        board.kill()
        self.board(name="again", port=board.port)
        self.finish(host, 1, "the board was restarted, or has another master")

    def test_silent_board_is_told(self):
        self.finish(self.stream("udp:127.0.0.1:9"), 1, "the board does not answer")

    def test_names_that_are_no_board(self):
        for name in ("tcp:127.0.0.1", "udp:", "udp:localhost", "udp:127.0.0.1:70000",
                     "serial:/nowhere", "serial:/dev/null@1200", ""):
            self.finish(self.stream(name), 2, "curvecore: error:")

    def test_strangers_change_nothing(self):
        board = self.board("--fast")
        host = self.stream(f"udp:127.0.0.1:{board.port}")
        self.wait_for_path(board.port, 5)
        chance = random.Random(3)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
            for n in range(2000):
                data = chance.randbytes(chance.randrange(1, 300))
                if n % 2:
                    data = numbered(board.port) + command(0x8200, 1, CONTROL, chance.randrange(16))
                stranger.sendto(data, ("127.0.0.1", board.port))
                if n % 20 == 0:
                    time.sleep(0.01)
        self.finish(host)
        self.assertEqual(counts(board.end()), [STEPS_PER_MM * mm for mm in END])

    def test_random_writes_give_no_step(self):
        board = self.board("--fast")
        chance = random.Random(4)
        number = int(os.environ.get("CURVECORE_DATAGRAMS", "1000"))
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as host:
            host.settimeout(5)
            host.connect(("127.0.0.1", board.port))
            for n in range(number):
                sequence = numbered(board.port)
                data = chance.randbytes(chance.randrange(1, 200)) if n % 2 else command(
                    0x8200, 1, 4 * chance.randrange(128), chance.getrandbits(32))
                host.send(sequence + data)
        self.assertTrue(read(board.port, STATE) & 0xFFFF)
        self.assertEqual(board.end(), [])

    def test_serial_line(self):
        board = self.board()
        master, device = pty.openpty()
        tty.setraw(master)
        threading.Thread(target=bridge, args=(master, board.port), daemon=True).start()
        self.finish(self.stream(f"serial:{os.ttyname(device)}@115200"))
        self.assertEqual(counts(board.end()), [STEPS_PER_MM * mm for mm in END])


    def test_slow_line_slows_time(self):
        board = self.board()
        master, device = pty.openpty()
        tty.setraw(master)
        threading.Thread(target=bridge, args=(master, board.port), daemon=True).start()
        self.finish(self.stream(f"serial:{os.ttyname(device)}@38400"), text="warning: time went at")
        report = self.report()
        self.assertLess(report["link"]["rate"], 0.9)
        self.assertGreater(report["planned"]["words_of_busiest_second"] * 0.95,
                           report["link"]["words_per_s"])
        steps = board.end()
        self.assertEqual(counts(steps), [STEPS_PER_MM * mm for mm in END])
        seconds = (steps[-1][0] - steps[0][0]) / 2.56e6
        self.assertGreater(seconds, 0.8 * report["planned"]["duration_s"] / report["link"]["rate"])


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


if __name__ == "__main__":
    CURVECORE = sys.argv.pop(1)
    unittest.main()
