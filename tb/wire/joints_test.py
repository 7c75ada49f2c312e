# SPDX-License-Identifier: Apache-2.0
"""Machines whose joints bend a line, at a board: every step of their joints keeps the tool, by
forward kinematics of its own, on the program's lines."""

import math
import pathlib
import re
import sys
import unittest

from wire_parts import STATE, STEPS_PER_MM, Board, WishTest, Wire, read, until

MACHINES = pathlib.Path(__file__).resolve().parents[1] / "data" / "machines"
# Corners of each part, mm, from where the machine is at home.
CORNERS = {
    "delta": [(0, 0, 9.498408), (20, 0, 12), (25, 30, 8), (0, 0, 9.5)],
    "corexy": [(100, 50, 5), (120, 50, 5), (110, 70, 3), (90, 45, 4)],
    "polar": [(51.961524, -30, 5), (20, -20, 5), (20, 20, 4), (-20, 20, 4), (-20, -20, 4),
              (20, -20, 4), (30, 10, 5)],
}
HELD = 1 << 17 | 1 << 19  # of STATE: holding, standing
OFF = 0.005  # mm: half a step of every joint is 0.00125 mm or degrees, a step that is due as much


def delta(towers):
    """The tool below three carriages, by Newton's method: the program has a closed form."""
    radius, rod = 130, 269
    feet = [(radius * math.cos(math.radians(a)), radius * math.sin(math.radians(a)))
            for a in (90, 210, 330)]

    def miss(x, y, z):
        return [math.dist((x, y, z), (*foot, height)) - rod for foot, height in zip(feet, towers)]

    x = y = 0.0
    z = towers[0] - math.sqrt(rod ** 2 - radius ** 2)
    for _ in range(30):
        here = miss(x, y, z)
        if max(map(abs, here)) < 1e-9:
            break
        rows = [[(foot[0] - x) / rod, (foot[1] - y) / rod, (height - z) / rod]
                for foot, height in zip(feet, towers)]
        dx, dy, dz = solve(rows, here)
        x, y, z = x + dx, y + dy, z + dz
    return x, y, z


def solve(rows, right):
    """Three equations, by Cramer's rule."""
    def det(a):
        return (a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1])
                - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0])
                + a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]))
    whole = det(rows)
    return [det([[right[i] if n == k else rows[i][n] for n in range(3)] for i in range(3)]) / whole
            for k in range(3)]


TOOLS = {
    "delta": delta,
    "corexy": lambda j: ((j[0] + j[1]) / 2, (j[0] - j[1]) / 2, j[2]),
    "polar": lambda j: (j[0] * math.cos(math.radians(j[2])), j[0] * math.sin(math.radians(j[2])),
                        j[1]),
}


def off_line(place, begin, end):
    way = [b - a for a, b in zip(begin, end)]
    square = sum(w * w for w in way)
    share = sum((p - a) * w for p, a, w in zip(place, begin, way)) / square
    share = min(max(share, 0), 1)
    return math.dist(place, [a + share * w for a, w in zip(begin, way)])


class JointsTest(WishTest):
    def begin(self, machine, feed=2400, curve="series"):
        self.machine = machine
        corners = CORNERS[machine]
        self.part.write_text("G21 G90 G61\n" + "".join(
            f"G1 X{x} Y{y} Z{z} F{feed}\n" for x, y, z in corners[1:]) + "M2\n", encoding="ascii")
        options = ["--curve", curve] if curve else []
        board = Board(str(self.folder / "board"), "--fast", *options)
        self.addCleanup(board.kill)
        return board

    def stream(self, board, *options):
        return super().stream(board, "--machine", MACHINES / f"{self.machine}.ini", *options)

    def check(self, steps):
        """The tool of every step is on the line that comes, and at the end of the last at last."""
        text = (MACHINES / f"{self.machine}.ini").read_text(encoding="ascii")
        joints = [float(home) for home in re.findall(r"HOME = (\S+)", text)]
        corners, forward = CORNERS[self.machine], TOOLS[self.machine]
        lines = list(zip(corners, corners[1:]))
        worst = at = 0
        for _, joint, way in steps:
            joints[joint] += way / STEPS_PER_MM
            tool = forward(joints)
            off = off_line(tool, *lines[at])
            if at + 1 < len(lines) and (behind := off_line(tool, *lines[at + 1])) <= off:
                at, off = at + 1, behind
            worst = max(worst, off)
        self.assertLess(worst, OFF)
        self.assertEqual(at, len(lines) - 1)
        self.assertLess(math.dist(forward(joints), corners[-1]), OFF)
        return worst

    def test_the_tool_is_on_its_lines(self):
        for machine in ("delta", "corexy"):  # the polar one is below
            board = self.begin(machine)
            self.end(self.stream(board), 0)
            steps = board.end()
            print(f"{machine}: {len(steps)} steps, at most {self.check(steps):.4f} mm off")
            self.assertGreater(len(steps), 10000)

    def test_a_hold_is_on_its_lines_and_goes_on(self):
        board = self.begin("delta")
        wire = Wire(board.port, gate_mm=30)
        host = self.stream(wire, "--control", self.wishes, "--override", "99")
        wire.wait_for_gate()
        self.wish("hold")
        wire.open_gate()
        until(lambda: read(board.port, STATE) & HELD == HELD)
        self.wish("resume")
        self.wish("override 60")
        self.end(host, 0)
        self.check(board.end())

    def test_the_rest_counts_the_turns_that_were_made(self):
        board = self.begin("polar")
        wire = Wire(board.port, gate_mm=1600)  # of the joints' path: 152 mm of the tool's
        host = self.stream(wire)
        wire.wait_for_gate()
        host.kill()
        host.communicate()
        said = self.end(self.stream(board, "--rest"), 0)
        self.assertGreater(float(re.search(r"rest --from (\d+\.\d+)mm", said)[1]), 150)
        steps = board.end()
        self.check(steps)
        turned = -30 + sum(way for _, joint, way in steps if joint == 2) / STEPS_PER_MM
        self.assertAlmostEqual(turned, 360 + math.degrees(math.atan2(10, 30)), delta=0.01)

    def test_a_board_without_their_table_is_refused(self):
        for curve, said in ((None, "the board draws no further table, and this program needs the "
                                   "table series, number "),
                            ("quintic", "the board draws another table, ")):
            board = self.begin("corexy", curve=curve)
            self.assertIn(said, self.end(self.stream(board), 2))
            self.assertEqual(board.end(), [])

    def test_such_a_board_draws_plain_programs_too(self):
        board = self.begin("corexy")
        self.part.write_text("G21 G90 G61\nG1 X20 F4800\nG3 X40 Y20 I0 J20\nM2\n",
                             encoding="ascii")
        self.end(super().stream(board), 0)
        places = [0, 0, 0]
        for _, axis, way in board.end():
            places[axis] += way
        self.assertEqual(places, [40 * STEPS_PER_MM, 20 * STEPS_PER_MM, 0])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
