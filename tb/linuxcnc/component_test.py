#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""LinuxCNC in simulation on a virtual board, by the HAL component of sysc/linuxcnc.

    component_test.py CURVECORE [unittest's options]

The component is compiled, and found by LinuxCNC in a view of its folder of modules that this test
alone has. Exit status 77: LinuxCNC is not installed, or nobody may make such a view.
"""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "wire"))
from wire_parts import ENABLED, STATE, STEPS_PER_MM, Board, Wire, counts, read  # noqa: E402

INSIDE = HERE.parent.parent / "sysc/linuxcnc"
MODULES = "/usr/lib/linuxcnc/modules"
PROGRAM = HERE / "board.ngc"
END = (1.25, -3.5, 2)  # mm
STEPS_OF_X = 0x108
FOLLOWING_FAULT = 1 << 26  # of STATE
PERIOD, SAMPLE = 1e-3, 1e-4  # s, of LinuxCNC and of the board
CLOSEST = 0.98  # of the samples' even distance, where more of them are wanted
# From a sample that waits no more to its last step, in samples, and those of a period that is
# commanded at the same time.
UNDER_WAY = 4 + 10
LONGEST = 1200  # s: it hangs
FOLLOWING = 5 / STEPS_PER_MM  # mm, that encoders may be off; they are ideal
VIEW = ["unshare", "--mount", "--ipc", "sh", "-c"]


def may_run():
    return all(map(shutil.which, ("linuxcnc", "halcompile", "unshare"))) and subprocess.run(
        [*VIEW, f"mount --bind {MODULES} {MODULES}"], stderr=subprocess.DEVNULL,
        check=False).returncode == 0


def distance(point, line):
    """Distances from a polyline, along the axis where it is longest."""
    way = np.diff(line, axis=0)
    along = np.einsum("ij,ij->i", point - line[:-1], way) / np.maximum(
        np.einsum("ij,ij->i", way, way), 1e-30)
    nearest = line[:-1] + np.clip(along, 0, 1)[:, None] * way
    return np.abs(nearest - point).max(axis=1).min()


class ComponentTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.folder.chmod(0o755)

    def compile(self):
        modules = self.folder / "modules"
        shutil.copytree(MODULES, modules)
        subprocess.run(["halcompile", "--compile", INSIDE / "curvecore.comp"], cwd=modules,
                       check=True, capture_output=True)

    def run_program(self, port, buffer, meanwhile):
        """LinuxCNC's values of every servo period: commanded, given, latency, late so far."""
        out = self.folder / "out"
        simulate = (f"{INSIDE}/simulate.py {PROGRAM} --folder {out} --board 127.0.0.1:{port} "
                    f"--scale {STEPS_PER_MM} --buffer {buffer} --following {FOLLOWING}")
        with subprocess.Popen([*VIEW, f"mount --bind modules {MODULES} && exec {simulate}"],
                              cwd=self.folder, stderr=subprocess.PIPE, text=True,
                              start_new_session=True) as runs:
            try:
                meanwhile()
                said = runs.communicate(timeout=LONGEST)[1]
            except BaseException:
                os.killpg(runs.pid, signal.SIGTERM)  # LinuxCNC ends its processes
                raise
        log = out / "log"
        self.assertEqual(runs.returncode, 0, said + (log.read_text() if log.exists() else ""))
        rows = np.loadtxt(out / "samples", usecols=range(14))
        return rows[:, :3], rows[:, 9:12], rows[:, 12], rows[:, 13]

    def check_follows(self, commanded, given, latency):
        """Checks that steps are on the commanded path, no further back than the waiting samples."""
        moves = np.abs(np.diff(commanded, axis=0)).max(axis=1) > 0
        path = commanded[np.concatenate(([True], moves))]
        at = np.concatenate(([0], np.cumsum(moves)))  # of each period, on the path
        periods = (latency / SAMPLE + UNDER_WAY) / (PERIOD / SAMPLE * CLOSEST)
        reach = np.ceil(periods).astype(int) + 1
        under_way = np.nonzero(np.abs(commanded - given).max(axis=1) > 1 / STEPS_PER_MM)[0]
        self.assertGreater(len(under_way), 300)
        worst, behind = 0, 0
        for n in under_way:
            line = path[max(0, at[n] - reach[n]):at[n] + 2]
            worst = max(worst, distance(given[n], line) * STEPS_PER_MM)
            behind = max(behind, np.abs(commanded[n] - given[n]).max() * STEPS_PER_MM)
        self.assertLess(worst, 1)
        self.assertGreater(behind, 100, "it does not move")
        print(f"{len(under_way)} periods: {worst:.2f} steps off what was commanded, "
              f"{behind:.0f} behind at most, {1e3 * latency.max():.0f} ms", flush=True)

    def draw(self, through=lambda board: board, meanwhile=lambda board: None, board=()):
        """Draws the program and returns the number of late samples."""
        self.compile()
        board = Board(str(self.folder / "board"), "--build", "parallel", *board)
        self.addCleanup(board.kill)
        *places, late = self.run_program(through(board).port, 0.03, lambda: meanwhile(board))
        self.check_follows(*places)
        self.assertEqual(counts(board.end()), [round(STEPS_PER_MM * mm) for mm in END])
        return late[-1]

    def wait_for(self, board, steps):
        end = time.monotonic() + LONGEST
        while read(board.port, STEPS_OF_X) < steps:
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)

    def stall(self, board):
        """Stops the servo thread several times in motion, for longer than samples last."""
        for steps in (500, 1500, 2500):
            self.wait_for(board, steps)
            thread = self.servo_process()
            os.kill(thread, signal.SIGSTOP)
            time.sleep(1)
            os.kill(thread, signal.SIGCONT)

    def servo_process(self):
        """Finds LinuxCNC's process: of this name, with this test's folder in its environment."""
        for process in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                if (process / "comm").read_text().strip() in ("rtapi_app", "rtapi_app:T#1") and (
                        bytes(self.folder) in (process / "environ").read_bytes()):
                    return int(process.name)
            except OSError:  # it has ended
                pass
        return self.fail("no servo thread")

    def check_line(self, folder, drift):
        """Returns for a board whose clock drifts: (worst error of the samples' distance, percent,
        lowest and highest level, late samples)."""
        check = self.folder / "check"
        subprocess.run(["cc", "-O1", "-o", check, folder / "sample_line_check.c", "-lm"],
                       check=True)
        said = subprocess.run([check, str(drift)], stdout=subprocess.PIPE, check=True).stdout
        return tuple(map(float, said.split()))

    def test_samples_follow_the_clock_of_the_board(self):
        for drift in (0, 200, -200, 2000, -2000):
            worst, low, high, late = self.check_line(INSIDE, drift)
            # Beside the rounding to units, of which a sample's way has 1000.
            self.assertLess(worst, 0.15 + abs(drift) * 1.2e-4)
            self.assertTrue(0.65 < low <= high < 1.35, drift)
            self.assertEqual(late, 0)

    def test_samples_that_do_not_follow_come_late(self):
        broken = self.folder / "sysc/linuxcnc"
        shutil.copytree(INSIDE, broken)
        shutil.copytree(INSIDE.parent.parent / "hls/registers", self.folder / "hls/registers")
        line = broken / "sample_line.h"
        line.write_text(line.read_text().replace("LINE_GAIN 0.01", "LINE_GAIN 0.0"))
        self.assertGreater(self.check_line(broken, 200)[3], 0)

    def test_program_with_arcs_runs_on_a_board(self):
        self.draw()

    def test_bad_wire_loses_no_step(self):
        wires = []

        def bad(board):
            wires.append(Wire(board.port, 0.02, 2))
            return wires[0]
        self.draw(bad)
        self.assertGreater(wires[0].lost, 10)
        self.assertGreater(wires[0].doubled, 10)

    def test_stalled_servo_thread_loses_no_step(self):
        self.assertGreater(self.draw(meanwhile=self.stall), 0)

    def test_board_that_is_gone_is_a_fault(self):
        def end(board):
            self.wait_for(board, 500)
            board.kill()
        with self.assertRaisesRegex(AssertionError, "joint 0 amplifier fault"):
            self.draw(meanwhile=end)

    def test_joint_that_slips_is_a_fault(self):
        boards = []
        with self.assertRaisesRegex(AssertionError, "joint 0 amplifier fault"):
            self.draw(meanwhile=boards.append, board=("--slip", "x=500..600"))
        state = read(boards[0].port, STATE)
        self.assertTrue(state & FOLLOWING_FAULT)
        self.assertFalse(state & ENABLED)
        # A step or none on the way, until the count is there.
        off = counts(boards[0].end())[0] - 500
        self.assertIn(off, (round(FOLLOWING * STEPS_PER_MM), round(FOLLOWING * STEPS_PER_MM) + 1))


if __name__ == "__main__":
    del sys.argv[1]
    if not may_run():
        print("LinuxCNC is not installed, or modules cannot be shown to it")
        sys.exit(77)
    unittest.main()
