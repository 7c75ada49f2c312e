#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Encoders at a virtual board whose axes lag, or slip: the host's report, and the pins.

    encoder_test.py CURVECORE [unittest's options]
"""

import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

from wire_parts import (CURVECORE, ENABLED, STATE, STEPS_PER_MM, SWITCHES, Board, Wire, counts,
                        read, report_of)

FERROR, MIN_FERROR = 0.1, 0.01
LIMIT = round(FERROR * STEPS_PER_MM)
PROGRAM = "G1 X4 Y-3\nG2 X6 Y-1 I0 J2\nG1 X0 Y0 Z1"
FEED = 10  # mm/s
STEP = 1 / STEPS_PER_MM
CAPABILITY, WIDTHS, ENCODERS = 0x08, 0x48, 1 << 25
HERTZ, DAMPING, RADIUS = 50, 0.05, 5
TICK_S = 20e-6
CLOCK_HZ = {"engine": 5.12e6, "parallel": 2.56e6}


def machine(**changes):
    text = "[TRAJ]\nCOORDINATES = X Y Z\nMAX_LINEAR_VELOCITY = 50\n"
    for axis in range(3):
        values = {"MAX_VELOCITY": 50, "MAX_ACCELERATION": 1000, "MIN_LIMIT": -10, "MAX_LIMIT": 10}
        if axis < 2:
            values.update({"ENCODER_SCALE": STEPS_PER_MM, "FERROR": FERROR,
                           "MIN_FERROR": MIN_FERROR})
            values.update(changes)
        text += f"[JOINT_{axis}]\n" + "".join(f"{n} = {v}\n" for n, v in values.items())
    return text


class EncoderTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.machine = self.folder / "mill.ini"
        self.machine.write_text(machine(), encoding="ascii")
        self.write_program(PROGRAM)

    def write_program(self, text):
        part = self.folder / "part.ngc"
        part.write_text(f"G21 G90 G61 F{60 * FEED}\n{text}\nM2\n", encoding="ascii")

    def board(self, *options):
        board = Board(str(self.folder / "board"), "--fast", *options)
        self.addCleanup(board.kill)
        return board

    def stream(self, board, status=0, text="", with_machine=True):
        """Returns the following errors of the report."""
        given = ["--machine", str(self.machine)] if with_machine else []
        host = subprocess.run(
            [CURVECORE, "stream", str(self.folder / "part.ngc"), "--to",
             f"udp:127.0.0.1:{board.port}", "-o", str(self.folder / "stream"), *given],
            stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        self.assertEqual(host.returncode, status, host.stderr)
        self.assertIn(text, host.stderr)
        if status == 2:
            return None
        report = report_of(self.folder / "stream")
        self.assertEqual(report["end"], "fault" if "stopped" in text else "drawn")
        return report.get("following_error_mm")

    def test_an_ideal_axis_is_within_a_count(self):
        board = self.board()
        for _ in range(2):
            errors = self.stream(board)
            self.assertEqual(list(errors), ["X", "Y"])
            for axis in errors.values():
                self.assertEqual(axis["end"], 0)
                self.assertLessEqual(abs(axis["worst"]), 1.001 * STEP)
                self.assertGreater(abs(axis["worst"]), 0)

    def test_a_late_axis_is_off_by_its_speed_and_stands_where_it_is_to(self):
        lag = 0.005
        errors = self.stream(self.board("--lag", f"{lag}s"))
        for axis in errors.values():
            self.assertAlmostEqual(abs(axis["worst"]), FEED * lag, delta=2 * STEP)
            self.assertEqual(axis["end"], 0)

    def test_a_later_one_stops_the_machine(self):
        board = self.board("--lag", "20ms")
        self.stream(board, 1, "the board stopped: X: following error")
        self.assertLess(len(board.end()), 200)

    def test_an_axis_that_slips_stops_the_machine_within_a_step_of_the_limit(self):
        for axis, first, way in (("X", 1000, 1), ("Y", -600, -1)):
            last = first + 100
            board = self.board("--slip", f"{axis.lower()}={first}..{last}")
            errors = self.stream(board, 1, f"the board stopped: {axis}: following error")
            self.assertAlmostEqual(errors[axis]["worst"], way * (FERROR + STEP), delta=STEP / 100)
            self.assertEqual(errors[axis]["end"], errors[axis]["worst"])
            self.assertFalse(read(board.port, STATE) & ENABLED)
            given = counts(board.end())["XY".index(axis)]
            # A step or none on the way, until the count is there.
            slipped = given - first + 1 if way > 0 else last - given + 1
            self.assertIn(slipped, (LIMIT + 1, LIMIT + 2))

    def test_an_axis_that_slips_is_homed_no_more(self):
        text = machine()
        for name, value in (("HOME_SEARCH_VEL", 10), ("HOME_LATCH_VEL", 1), ("HOME_OFFSET", 0.5)):
            text = text.replace("[JOINT_1]", f"{name} = {value}\n[JOINT_1]")
            text = text.replace("[JOINT_2]", f"{name} = {value}\n[JOINT_2]")
        self.machine.write_text(text, encoding="ascii")
        board = self.board("--home", "x=200..99999,y=200..99999", "--slip", "x=1000..1100")
        subprocess.run([CURVECORE, "home", "--machine", str(self.machine), "--to",
                        f"udp:127.0.0.1:{board.port}", "-q"], check=True)
        self.assertEqual(read(board.port, SWITCHES) >> 10, 0b011)
        self.stream(board, 1, "the board stopped: X: following error")
        self.assertEqual(read(board.port, SWITCHES) >> 10, 0b010)
        self.stream(board, 2, "X is not homed")

    def test_an_axis_that_stands_elsewhere_in_the_end_is_told(self):
        # Of 21 steps that it slips on its way out, 16 slip back.
        self.write_program("G1 X6\nG1 X5")
        board = self.board("--slip", "x=1995..2015")
        errors = self.stream(board, 1, "X stands 0.0125 mm off, and MIN_FERROR is 0.01 mm")
        self.assertAlmostEqual(errors["X"]["end"], 5 * STEP)
        self.machine.write_text(machine(MIN_FERROR=0.0126), encoding="ascii")
        self.write_program("G0 X5\nG1 X5.1")
        self.stream(self.board("--slip", "x=1995..1999"), 0)

    def test_an_encoder_that_counts_the_other_way_is_a_fault(self):
        self.machine.write_text(machine(ENCODER_SCALE=-STEPS_PER_MM), encoding="ascii")
        self.stream(self.board(), 1, "the board stopped: X: following error")

    def test_without_a_machine_nothing_is_watched(self):
        board = self.board("--slip", "x=1000..1100")
        self.stream(board, 1, "the board stopped: X: following error")
        self.assertIsNone(self.stream(board, with_machine=False))

    def test_a_board_without_inputs_is_told(self):
        board = self.board("--slip", "x=1000..1100")
        kind = read(board.port, CAPABILITY)
        said, bare = (word.to_bytes(4, "little") for word in (kind, kind & ~ENCODERS))
        wire = Wire(board.port, change=lambda answer: answer.replace(said, bare))
        line = 1 + machine().split("\n").index(f"ENCODER_SCALE = {STEPS_PER_MM}")
        self.assertIsNone(self.stream(
            wire, text=f"{self.machine}:{line}: warning: [JOINT_0] ENCODER_SCALE: the board has "))

    def test_encoders_that_cannot_be(self):
        board = self.board()
        for changes, text in (({"FERROR": 0}, "FERROR is missing"),
                              ({"FERROR": 1e-9}, "FERROR of 1e-09 mm"),
                              ({"ENCODER_SCALE": 1e12}, "no ratio that the board can have")):
            self.machine.write_text(machine(**changes), encoding="ascii")
            self.stream(board, 2, text)
        self.assertEqual(board.end(), [])

    def tool_off(self, build, shaper):
        """Returns the mm that a tool, on springs behind the drives, is off a circle at most."""
        modes = "".join(f"[AXIS_{axis}]\nSHAPER_FREQUENCY = {HERTZ}\n" for axis in "XY")
        self.machine.write_text(f"[TRAJ]\nSHAPER = {shaper}\n{modes}", encoding="ascii")
        self.write_program(f"F6000 G3 X0 Y0 I{RADIUS} J0")
        board = self.board("--build", build)
        self.stream(board)
        steps = board.end()
        self.assertEqual(counts(steps), [0, 0, 0])
        drive, place, speed, worst, next_step = [0, 0], [0, 0], [0, 0], 0, 0
        w = 2 * math.pi * HERTZ
        tick = CLOCK_HZ[build] * TICK_S
        for now in range(int(steps[-1][0] / tick) + 2000):
            while next_step < len(steps) and steps[next_step][0] <= now * tick:
                _, axis, way = steps[next_step]
                drive[axis] += way / STEPS_PER_MM
                next_step += 1
            for axis in range(2):
                pull = w * w * (drive[axis] - place[axis]) - 2 * DAMPING * w * speed[axis]
                speed[axis] += TICK_S * pull
                place[axis] += TICK_S * speed[axis]
            worst = max(worst, abs(math.hypot(place[0] - RADIUS, place[1]) - RADIUS))
        return worst

    def test_a_shaper_that_cannot_be(self):
        board = self.board()
        shaped = "[TRAJ]\nSHAPER = zv\n[AXIS_X]\nSHAPER_FREQUENCY = {}\n"
        self.machine.write_text(shaped.format(1), encoding="ascii")
        self.stream(board, 2, "X: SHAPER_FREQUENCY = 1 asks for a delay of 313 samples of 1.6 ms")
        widths = read(board.port, WIDTHS)
        said, bare = (word.to_bytes(4, "little") for word in (widths, widths & 0x7fff))
        wire = Wire(board.port, change=lambda answer: answer.replace(said, bare))
        self.machine.write_text(shaped.format(50), encoding="ascii")
        self.stream(wire, 2, "mill.ini: SHAPER needs a board with the parameter Shaper")

    def test_a_tool_on_springs_is_nearer_to_the_path_with_a_shaper(self):
        for build in CLOCK_HZ:
            plain, led = (self.tool_off(build, shaper) for shaper in ("none", "feed-forward"))
            print(f"{build}: {1e3 * plain:.2f} um off the path, {1e3 * led:.2f} with a shaper")
            self.assertGreater(plain, 0.015)
            self.assertLess(led, 0.003)


if __name__ == "__main__":
    del sys.argv[1]
    unittest.main()
