#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A laser's raster at a virtual board: each edge of S at the pin, where the program has it.

    output_test.py CURVECORE [unittest's options]
"""

import csv
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

from wire_parts import CURVECORE, STEPS_PER_MM, Board

LONG = "CURVECORE_LONG" in os.environ
FEED = 100  # mm/s
PIXEL, WIDTH, MARGIN, PITCH = 0.1, 60, 3.0, 0.1  # mm, pixels, mm, mm
TOLERANCE = 0.01
SAMPLE_S = {"parallel": 100e-6, "engine": 1.6e-3}


def raster(moves):
    """A program of so many moves with an S each, and its edges: X, and whether it is on."""
    dice = random.Random(3)
    lines = [f"G21 G90 G64 P{TOLERANCE} F{60 * FEED}", "M3 S0"]
    edges, x, level = [], 0.0, 0
    for row in range(-(-moves // WIDTH)):
        way = 1 if row % 2 == 0 else -1
        x += way * MARGIN
        lines.append(f"G1 X{x:.1f}")
        for _ in range(WIDTH):
            now = dice.choice((0, 0, 1000))
            if now != level:
                edges.append((x, now > 0))
                level = now
            x += way * PIXEL
            lines.append(f"X{x:.1f} S{now}")
        if level:
            edges.append((x, False))
            level = 0
        x += way * MARGIN
        lines.append(f"X{x:.1f} S0")
        lines.append(f"Y{PITCH * (row + 1):.1f}")
    return "\n".join(lines) + "\nM5\nM2\n", edges


class OutputTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def stream(self, part, board, *options):
        return subprocess.run(
            [CURVECORE, "stream", str(part), "--laser", "--to", f"udp:127.0.0.1:{board.port}",
             "-o", str(self.folder / "stream"), *options],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)

    def draw(self, build, moves, *options):
        """Streams a raster; returns the edges of PWM, with X there, and those of the program."""
        text, edges = raster(moves)
        part = self.folder / "part.ngc"
        part.write_text(text, encoding="ascii")
        board = Board(str(self.folder / "board"), "--fast", "--build", build)
        self.addCleanup(board.kill)
        host = self.stream(part, board, *options)
        self.assertEqual(host.returncode, 0, host.stderr)
        self.assertNotIn("nothing is switched", host.stderr)
        steps = board.end()
        with open(self.folder / "board" / "outputs.csv", newline="", encoding="ascii") as file:
            rows = [(int(clock), level == "1") for clock, output, level in
                    list(csv.reader(file))[1:] if output == "pwm"]
        drawn, x, step = [], 0, 0
        for clock, on in rows:
            while step < len(steps) and steps[step][0] <= clock:
                x += steps[step][2] if steps[step][1] == 0 else 0
                step += 1
            drawn.append((x / STEPS_PER_MM, on))
        return drawn, edges

    def check(self, build, moves, percent):
        drawn, edges = self.draw(build, moves, "--override", str(percent))
        self.assertEqual([on for _, on in drawn], [on for _, on in edges])
        most = percent / 100 * FEED * SAMPLE_S[build] + 1.5 / STEPS_PER_MM
        worst = max(abs(x - asked) for (x, _), (asked, _) in zip(drawn, edges))
        print(f"{build}, {percent} %: {len(edges)} edges of {moves} moves, {worst:.4f} mm off at "
              f"most, a sample {most:.4f}")
        self.assertLessEqual(worst, most)

    def test_draws_every_edge_in_its_sample(self):
        moves = 36_000 if LONG else 300
        for build in SAMPLE_S:
            for percent in (1, 50, 99, 150) if LONG else (99,):
                with self.subTest(build=build, percent=percent):
                    self.check(build, moves if percent > 1 else moves // 100, percent)

    def test_refuses_more_than_the_board_keeps(self):
        text = "G64 P0.01\nM3 G1 F6000\n" + "".join(
            f"X{0.004 * n:.3f} S{1000 * (n % 2)}\n" for n in range(1, 8000)) + "M2\n"
        part = self.folder / "fine.ngc"
        part.write_text(text, encoding="ascii")
        board = Board(str(self.folder / "board"), "--fast")
        self.addCleanup(board.kill)
        host = self.stream(part, board)
        self.assertEqual(host.returncode, 2, host.stderr)
        self.assertRegex(host.stderr, r"fine\.ngc:\d+: error: 768 changes of outputs within")
        board.end()


if __name__ == "__main__":
    del sys.argv[1]
    unittest.main()
