#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`curvecore stream` and `curvecore board`, connected by a bad wire alone.

    wire_test.py CURVECORE [unittest's options]
"""

import json
import math
import os
import pathlib
import pty
import random
import re
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import tty
import unittest
import zlib

from wire_parts import (CONTROL, CURVECORE, ENABLED, QUANTA_PER_MM, SEQUENCE, STATE, STEPS_PER_MM,
                        Board, Wire, bridge, command, counts, numbered, read, report_of,
                        system_steps, times, until)

ROOT = pathlib.Path(__file__).resolve().parents[2]
RADIUS = 20
# 20 mm along X, a quarter turn around (20, 20), 20 mm along Y.
PART = f"G21 G90 G61\nG1 X20 F4800\nG3 X40 Y20 I0 J{RADIUS}\nG1 Y40\nM2\n"
END = (40, 40, 0)
WATCHDOG, ACTIVE, STANDING = 1 << 1, 1 << 18, 1 << 19


def off_path(x, y):
    """Distance from PART's path, mm."""
    line = math.hypot(x - min(max(x, 0), 20), y)
    arc = abs(math.hypot(x - 20, y - RADIUS) - RADIUS) if x >= 20 and y <= 20 else math.inf
    up = math.hypot(x - 40, y - min(max(y, 20), 40))
    return min(line, arc, up)


class WireTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.boards = []
        self.part = self.folder / "part.ngc"
        self.part.write_text(PART, encoding="ascii")

    def board(self, *options, name="board", port=0):
        self.boards.append(Board(str(self.folder / name), *options, port=port))
        self.addCleanup(self.boards[-1].kill)
        return self.boards[-1]

    def stream(self, to, *options):
        return subprocess.Popen(
            [CURVECORE, "stream", str(self.part), "--to", to, "-q", "-o",
             str(self.folder / "stream"), *options],
            stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def finish(self, host, status=0, text=""):
        _, message = host.communicate()
        boards = [board.process.poll() for board in self.boards]  # None: it runs
        self.assertEqual(host.returncode, status, f"{message} (boards: {boards})")
        self.assertIn(text, message)

    def report(self):
        return report_of(self.folder / "stream")

    def draw(self, *options, through=None, name="board"):
        board = self.board(*options, name=name)
        wire = through(board.port) if through else board
        self.finish(self.stream(f"udp:127.0.0.1:{wire.port}"))
        return board.end(), wire

    def check_equal(self, steps, expected):
        """Compares without a text of the differences, which takes minutes."""
        differ = [pair for pair in zip(steps, expected) if pair[0] != pair[1]]
        self.assertEqual((len(steps), differ[:1]), (len(expected), []))

    def test_part_is_drawn(self):
        steps, _ = self.draw("--fast")
        self.assertEqual(counts(steps), [STEPS_PER_MM * mm for mm in END])
        report = self.report()
        self.assertEqual(report["drawn"]["steps"], counts(steps))
        self.assertEqual(report["drawn"]["path_quanta"], report["planned"]["path_quanta"])

    def test_a_board_of_the_parallel_build_draws_it(self):
        steps, _ = self.draw("--fast", "--build", "parallel")
        self.assertEqual(counts(steps), [STEPS_PER_MM * mm for mm in END])
        report = self.report()
        self.assertEqual(report["drawn"]["path_quanta"], report["planned"]["path_quanta"])

    def test_steps_are_those_of_the_system(self):
        curves = self.folder / "curves.ngc"
        curves.write_text("G21 G90 G61 F1800\nG1 X5 Z1\nG5 X9 Y6 I0 J3 P-2 Q0\n"
                          "G3 X12 Y9 Z3 I3\nG64 P0.02\nG1 X14\nY4 Z2\nM2\n", encoding="ascii")
        radii = self.folder / "radii.ngc"
        some = (ROOT / "tb/data/small_radii.ngc").read_text(encoding="ascii").splitlines()[:10]
        radii.write_text("\n".join(some) + "\n", encoding="ascii")
        # So quick that stream, too, plans them at once.
        for part in (self.part, curves, radii):
            self.part = self.folder / f"quick_{part.name}"
            self.part.write_text(re.sub(r"F[\d.]+", "F9600", part.read_text(encoding="ascii")),
                                 encoding="ascii")
            steps, _ = self.draw("--fast", name=part.stem)
            expected = system_steps(str(self.part), str(self.folder / "system"))
            self.assertGreater(len(steps), 1000)
            self.check_equal(sorted(times(steps)), sorted(times(expected)))

    def test_a_dialects_part_is_drawn(self):
        plain, _ = self.draw("--fast")
        self.part.write_text(PART.replace("X40 Y20 I0", "X40000 Y20. I0").replace("X20 ", "X20. ")
                             .replace("Y40\n", "Y40.\n")
                             .replace(f"J{RADIUS}", f"J{RADIUS}000"), encoding="ascii")
        board = self.board("--fast", name="fanuc")
        self.finish(self.stream(f"udp:127.0.0.1:{board.port}", "--dialect", "fanuc"),
                    text="an axis' number without a point counts in 0.001 mm")
        self.check_equal(sorted(times(board.end())), sorted(times(plain)))

    def test_override_above_100_percent_is_planned(self):
        durations = []
        for percent in ("100", "200"):
            board = self.board("--fast", name=percent)
            self.finish(self.stream(f"udp:127.0.0.1:{board.port}", "--override", percent))
            self.assertEqual(counts(board.end()), [STEPS_PER_MM * mm for mm in END])
            durations.append(self.report()["planned"]["duration_s"])
        self.assertLess(durations[1], 0.7 * durations[0])

    def stream_to_gate(self, board, mm, *options):
        """Waits until the path has reached the gate, where it stays until the gate is opened."""
        wire = Wire(board.port, gate_mm=mm)
        host = self.stream(f"udp:127.0.0.1:{wire.port}", *options)
        wire.wait_for_gate()
        return host, wire

    def test_bad_wire_changes_no_step(self):
        # Words in time depend on real time: lossy_link_test.cpp tests them in the board's.
        expected, _ = self.draw("--fast", name="good")
        steps, wire = self.draw("--fast", through=lambda port: Wire(port, 0.1, 5), name="bad")
        for count in (wire.lost, wire.doubled, wire.late, self.report()["link"]["repeated"]):
            self.assertGreater(count, 5)
        self.assertEqual(counts(steps), counts(expected))
        self.check_path(steps)
        if not self.report()["drawn"]["held"]:
            self.check_equal(times(steps), times(expected))

    def test_hold_and_resume_keep_the_path(self):
        control = self.folder / "control"
        control.touch()
        board = self.board("--fast")
        host, wire = self.stream_to_gate(board, 10, "--control", str(control))
        with control.open("a", encoding="ascii") as file:
            file.write("hold\nsome words\n")
        wire.open_gate()
        until(lambda: read(board.port, STATE) & STANDING)
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
        # An eighth of the speed, 10 mm/s: the watchdog's 500 ms are 5 mm of the 59 that are left.
        board = self.board("--fast")
        host, _ = self.stream_to_gate(board, 12, "--override", "12")
        host.kill()
        host.communicate()
        # A monitor that never rests; ACTIVE ends where the program does.
        while not read(board.port, STATE) & STANDING:
            self.assertTrue(read(board.port, STATE) & ACTIVE, "it drew on to the end")
        self.assertLess(read(board.port, 0x60) + (read(board.port, 0x64) << 32), 27e6 * 65536)
        self.assertTrue(read(board.port, STATE) & WATCHDOG)
        self.assertTrue(read(board.port, STATE) & ENABLED)
        steps = board.end()
        self.assertLess(sum(counts(steps)), sum(END) * STEPS_PER_MM)
        self.check_path(steps)
        # It became slower step by step: on the arc two axes do so beside each other.
        waits = [b[0] - a[0] for a, b in zip(steps, steps[1:])]
        self.assertGreater(sum(waits[-5:]) / 5, 4 * sorted(waits)[len(waits) // 2])

    def test_interrupted_host_stops_on_the_path_and_another_draws_the_rest(self):
        board = self.board("--fast")
        host, wire = self.stream_to_gate(board, 25)
        host.send_signal(signal.SIGINT)
        wire.open_gate()
        self.finish(host, 130)
        report = self.report()
        self.assertEqual(report["end"], "stopped")
        self.assertLess(report["drawn"]["path_quanta"], report["planned"]["path_quanta"])
        drawn_mm = report["drawn"]["path_quanta"] / QUANTA_PER_MM
        self.finish(self.stream(f"udp:127.0.0.1:{board.port}", "--from", f"{drawn_mm:.6f}mm"))
        steps = board.end()
        self.assertNotEqual(report["drawn"]["steps"], counts(steps))
        self.assertEqual(self.report()["drawn"]["steps"], counts(steps))
        self.assertEqual(counts(steps), [STEPS_PER_MM * mm for mm in END])
        self.check_path(steps)

    def test_estop_is_told(self):
        control = self.folder / "control"
        control.touch()
        board = self.board("--fast")
        host, wire = self.stream_to_gate(board, 10, "--control", str(control))
        with control.open("a", encoding="ascii") as file:
            file.write("estop\n")
        wire.open_gate()
        self.finish(host, 1, "the board stopped: e-stop")
        self.assertFalse(read(board.port, STATE) & ENABLED)

    def test_restarted_board_is_noticed(self):
        board = self.board("--fast")
        host, wire = self.stream_to_gate(board, 10)
        board.kill()
        self.board("--fast", name="again", port=board.port)
        wire.open_gate()
        self.finish(host, 1, "the board was restarted, or has another master")

    def test_silent_board_is_told(self):
        self.finish(self.stream("udp:127.0.0.1:9"), 1, "the board does not answer")

    def test_names_that_are_no_board(self):
        for name in ("tcp:127.0.0.1", "udp:", "udp:localhost", "udp:127.0.0.1:70000",
                     "serial:/nowhere", "serial:/dev/null@1200", "spi:/nowhere",
                     "spi:/dev/null@1000000", "spi:/dev/null@fast", ""):
            self.finish(self.stream(name), 2, "curvecore: error:")

    def test_times_that_the_board_cannot_count(self):
        # 4,096 clocks of 5.12 MHz: more than its 12 bits.
        board = self.board("--fast")
        self.finish(self.stream(f"udp:127.0.0.1:{board.port}", "--steplen", "800us"), 2,
                    "more than 2047 clocks of the board")

    def test_boards_of_other_widths_are_asked(self):
        # The board's description is changed on its way: times of 10 bits, scales of 40.
        def change(answer):
            words = [answer[n:n + 4] for n in range(0, len(answer), 4)]
            made, other = ((times | scales << 5 | 15 << 11 | 8 << 15).to_bytes(4, "little")
                           for times, scales in ((12, 44), (10, 40)))
            return b"".join(other if word == made else word for word in words)
        board = self.board("--fast")
        to = f"udp:127.0.0.1:{Wire(board.port, change=change).port}"
        self.finish(self.stream(to, "--steplen", "125us"), 2, "more than 511 clocks of the board")
        self.finish(self.stream(to, "--steps-per-mm", "4000"), 2,
                    "steps per mm are too many for the board, whose scales have 40")

    def test_registers_of_another_version_are_refused(self):
        def change(answer):
            return answer[:4] + b"\x01" + answer[5:] if answer[:4] == b"1MVC" else answer
        board = self.board("--fast")
        self.finish(self.stream(f"udp:127.0.0.1:{Wire(board.port, change=change).port}"), 2,
                    "registers of version 1")

    def test_words_are_made_for_the_board_that_is_asked(self):
        board = self.board("--fast")
        out = self.folder / "words"
        subprocess.run([CURVECORE, "words", str(self.part), "-q", "-o", str(out), "--to",
                        f"udp:127.0.0.1:{board.port}"], check=True)
        words = json.loads((out / "words.json").read_text(encoding="utf-8"))
        self.assertEqual(words["queue_words"], {"segments": 4096, "profile": 1024})
        self.assertEqual((words["clock_hz"], words["sample_period_s"]), (5.12e6, 1.6e-3))
        self.assertEqual(words["parameters"]["Mode"], 1)
        self.assertEqual(read(board.port, SEQUENCE), 0, "it was only asked")
        capability, core, clock = (read(board.port, address) for address in (0x08, 0x0C, 0x10))
        period = 1 << (capability >> 4 & 31)
        digest = 0
        for word in (capability & 0x400060f, core, period, clock):
            for byte in word.to_bytes(4, "little"):
                top = digest >> 8
                digest = (digest << 8 ^ top << 3 ^ top ^ byte) & 0xffff
        self.assertEqual(words["digest"], digest ^ words["digest_register"])

    def draw_in_c(self, name, change=lambda folder: None, through=None):
        """hls/examples/stream_words.c: its end, what it says, and the steps."""
        host = self.folder / "stream_words"
        subprocess.run(["cc", "-std=c99", "-O1", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-o",
                        host, ROOT / "hls/examples/stream_words.c", "-lm"], check=True)
        board = self.board("--fast", name=name)
        out = self.folder / f"words_{name}"
        subprocess.run([CURVECORE, "words", str(self.part), "-q", "-o", str(out), "--to",
                        f"udp:127.0.0.1:{board.port}"], check=True)
        change(out)
        wire = through(board.port) if through else board
        ended = subprocess.run([host, out, "127.0.0.1", str(wire.port), str(STEPS_PER_MM)],
                               stderr=subprocess.PIPE, text=True, check=False)
        return ended.returncode, ended.stderr, board.end()

    def test_host_in_c_draws_the_steps_of_stream(self):
        expected, _ = self.draw("--fast")
        wires = []

        def bad(port):
            wires.append(Wire(port, 0.05, 3))
            return wires[0]
        for name, through in (("good", None), ("bad", bad)):
            status, message, steps = self.draw_in_c(name, through=through)
            self.assertEqual((status, message), (0, ""), name)
            self.assertEqual(counts(steps), counts(expected), name)
            if name == "good":  # that words come in time is a matter of time
                self.check_equal(times(steps), times(expected))
        self.assertGreater(wires[0].lost + wires[0].doubled, 5)

    def test_host_in_c_tells_of_a_broken_word(self):
        def change(folder):
            segments = folder / "segments.hex"
            *lines, last = segments.read_text(encoding="ascii").split("\n")
            lines[-3] = f"{int(lines[-3], 16) ^ 1:012x}"
            segments.write_text("\n".join([*lines, last]), encoding="ascii")
        expected, _ = self.draw("--fast")
        status, message, steps = self.draw_in_c("broken", change)
        self.assertEqual(status, 1)
        self.assertIn("a segment word that cannot be", message)
        self.assertLess(sum(counts(steps)), sum(counts(expected)))

    def test_examples_of_the_page(self):
        page = ROOT / "sysc/wire/README.md"
        text = page.read_text(encoding="ascii")
        rows = re.findall(r"^\| .* \| `([0-9a-f ]+)` \| `([0-9a-f ]+)` \|$",
                          text[text.index("<!-- examples -->"):], re.MULTILINE)
        self.assertEqual(len(rows), 6)
        board = self.board("--fast")
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as host:
            host.connect(("127.0.0.1", board.port))
            for frame, answer in rows:
                host.send(bytes.fromhex(frame))
                self.assertEqual(host.recv(1000).hex(), answer.replace(" ", ""), frame)
        line = bytes.fromhex(re.search(r"serial line, whole: `([0-9a-f ]+)`", text)[1])
        self.assertEqual(line[-1:], b"\xc0")
        self.assertEqual(zlib.crc32(line[:-5]).to_bytes(4, "little"), line[-5:-1])

    def test_strangers_change_nothing(self):
        board = self.board("--fast")
        host, wire = self.stream_to_gate(board, 5)
        chance = random.Random(3)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
            for n in range(2000):
                data = chance.randbytes(chance.randrange(1, 300))
                if n % 2:
                    data = numbered(board.port) + command(0x8200, 1, CONTROL, chance.randrange(16))
                stranger.sendto(data, ("127.0.0.1", board.port))
                if n == 20:
                    wire.open_gate()
                if n % 20 == 0:  # it has room for 256
                    read(board.port, STATE)
        self.finish(host)
        self.assertEqual(counts(board.end()), [STEPS_PER_MM * mm for mm in END])

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
        seconds = (steps[-1][0] - steps[0][0]) / 5.12e6
        self.assertGreater(seconds, 0.8 * report["planned"]["duration_s"] / report["link"]["rate"])


if __name__ == "__main__":
    del sys.argv[1]
    unittest.main()
