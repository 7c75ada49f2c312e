#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs a program on LinuxCNC's own motion in simulation, without a screen, and records positions.

    simulate.py PROGRAM --folder FOLDER [--velocity MM_S] [--acceleration MM_S2] [--tools FILE]
                [--board HOST:PORT [--scale STEPS_PER_MM] [--buffer S] [--following MM]]

Writes FOLDER/samples: the commanded positions of X Y Z A B C U V W, mm and degrees, a line for
every servo cycle of 1 ms. LinuxCNC runs in real time, one at a time on a computer.

With --board X Y Z are on that board, by the installed component curvecore; each line then has the
positions of X Y Z that came back too, mm, the component's latency, s, and how often it was late.
With --following the board watches encoders of an edge a step.
"""

import argparse
import os
import subprocess
import sys
import time
from pathlib import Path

AXES = "XYZABCUVW"
BOARD_AXES = 3
LONGEST = 900  # s
POLL = 0.05  # s
USER = 65534  # real-time parts refuse to run as root: nobody

INI = """[EMC]
VERSION = 1.1
MACHINE = simulation
[DISPLAY]
DISPLAY = {me}
[TASK]
TASK = milltask
CYCLE_TIME = 0.001
[RS274NGC]
PARAMETER_FILE = parameters.var
RS274NGC_STARTUP_CODE = G21
SUBROUTINE_PATH = {subroutines}
[EMCMOT]
EMCMOT = motmod
SERVO_PERIOD = 1000000
[EMCIO]
EMCIO = io
CYCLE_TIME = 0.01
TOOL_TABLE = tools.tbl
[HAL]
HALFILE = simulation.hal
[KINS]
KINEMATICS = trivkins coordinates=XYZABCUVW
JOINTS = 9
[TRAJ]
COORDINATES = X Y Z A B C U V W
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
MAX_LINEAR_VELOCITY = {velocity}
MAX_ANGULAR_VELOCITY = {velocity}
MAX_LINEAR_ACCELERATION = {acceleration}
MAX_ANGULAR_ACCELERATION = {acceleration}
DEFAULT_LINEAR_VELOCITY = {velocity}
DEFAULT_LINEAR_ACCELERATION = {acceleration}
NO_FORCE_HOMING = 1
"""
LIMITS = """MAX_VELOCITY = {velocity}
MAX_ACCELERATION = {acceleration}
MIN_LIMIT = -99999
MAX_LIMIT = 99999
"""
HAL = """loadrt trivkins coordinates=XYZABCUVW
loadrt motmod servo_period_nsec=1000000 num_joints=9
loadrt sampler depth=30000 cfg={kinds}
{before}addf motion-command-handler servo-thread
addf motion-controller servo-thread
{behind}addf sampler.0 servo-thread
net estop iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in
net prepare iocontrol.0.tool-prepare => iocontrol.0.tool-prepared
net change iocontrol.0.tool-change => iocontrol.0.tool-changed
setp spindle.0.at-speed 1
"""
BOARD = """net on joint.0.amp-enable-out => curvecore.enable
net fault curvecore.fault => joint.0.amp-fault-in
net hold curvecore.hold => motion.feed-inhibit
setp curvecore.watchdog-time 5
setp curvecore.buffer-time {buffer}
net latency curvecore.latency => sampler.0.pin.12
net late curvecore.late => sampler.0.pin.13
"""
BOARD_JOINT = """setp curvecore.joint.{joint}.scale {scale}
net place-{joint} joint.{joint}.motor-pos-cmd sampler.0.pin.{joint}
net place-{joint} => curvecore.joint.{joint}.position-cmd
setp curvecore.joint.{joint}.encoder-counts {encoder}
setp curvecore.joint.{joint}.following-limit {following}
net back-{joint} curvecore.joint.{joint}.position-fb sampler.0.pin.{pin}
net back-{joint} => joint.{joint}.motor-pos-fb
"""


def prepare(given, folder):
    """LinuxCNC's own files."""
    values = {"me": Path(__file__).resolve(), "subroutines": given.program.resolve().parent,
              "velocity": given.velocity, "acceleration": given.acceleration}
    limits = LIMITS.format(**values)
    ini = INI.format(**values)
    board = BOARD_AXES if given.board else 0
    hal = HAL.format(
        kinds="f" * len(AXES) + ("f" * board + "fu" if board else ""),
        before=f"loadrt curvecore personality={board} address={given.board}\n"
               "addf curvecore.read servo-thread\n" if board else "",
        behind="addf curvecore.write servo-thread\n" if board else "")
    hal += BOARD.format(buffer=given.buffer) if board else ""
    for joint, axis in enumerate(AXES):
        kind = "ANGULAR" if axis in "ABC" else "LINEAR"
        ini += f"[AXIS_{axis}]\n{limits}[JOINT_{joint}]\nTYPE = {kind}\n{limits}"
        ini += "HOME_SEQUENCE = 0\nFERROR = 1000\nMIN_FERROR = 1000\n"
        if joint < board:
            hal += BOARD_JOINT.format(joint=joint, pin=len(AXES) + joint, scale=given.scale,
                                      encoder=int(given.following > 0), following=given.following)
            continue
        hal += (f"net place-{joint} joint.{joint}.motor-pos-cmd joint.{joint}.motor-pos-fb "
                f"sampler.0.pin.{joint}\n")
    (folder / "simulation.ini").write_text(ini)
    (folder / "simulation.hal").write_text(hal)
    (folder / "program").write_text(str(given.program.resolve()))
    (folder / "step").write_text(str(1 / given.scale))
    (folder / "parameters.var").write_text("")
    (folder / "tools.tbl").write_text(given.tools.read_text() if given.tools else "")


def wait(status, ready, longest):
    """Polls until a condition holds."""
    end = time.monotonic() + longest
    while time.monotonic() < end:
        status.poll()
        if ready(status):
            return True
        time.sleep(POLL)
    return False


def inside(program, step):
    """The user's side, which LinuxCNC starts in place of a screen. Returns the exit status.

    At the end each joint is within `step`, mm, of its commanded place."""
    import linuxcnc
    status, command, errors = linuxcnc.stat(), linuxcnc.command(), linuxcnc.error_channel()
    command.state(linuxcnc.STATE_ESTOP_RESET)
    command.wait_complete()
    command.state(linuxcnc.STATE_ON)
    command.wait_complete()
    command.mode(linuxcnc.MODE_MANUAL)
    command.wait_complete()
    command.home(-1)
    if not wait(status, lambda s: all(s.homed[:9]), 20):
        print("simulate: not homed", file=sys.stderr)
        return 1
    command.mode(linuxcnc.MODE_AUTO)
    command.wait_complete()
    command.program_open(program)
    with open("samples", "wb") as samples:
        recorder = subprocess.Popen(["halsampler"], stdout=samples)
        time.sleep(0.3)
        command.auto(linuxcnc.AUTO_RUN, 0)
        wait(status, lambda s: s.interp_state != linuxcnc.INTERP_IDLE, 5)

        def ended(now):
            if now.interp_state == linuxcnc.INTERP_PAUSED:  # M0, M1
                command.auto(linuxcnc.AUTO_RESUME)
            return now.interp_state == linuxcnc.INTERP_IDLE and now.inpos
        done = wait(status, ended, LONGEST)
        # A board lags. Its steps are within half a step.
        done = done and wait(status, lambda now: all(
            abs(joint["output"] - joint["input"]) <= step for joint in now.joint), LONGEST)
        time.sleep(0.3)
        recorder.terminate()
        recorder.wait()
    error = errors.poll()
    if error and error[0] in (linuxcnc.NML_ERROR, linuxcnc.OPERATOR_ERROR):
        print(f"simulate: {error[1]}", file=sys.stderr)
        return 1
    if not done:
        print("simulate: the program did not end", file=sys.stderr)
    return 0 if done else 1


def main():
    if "-ini" in sys.argv:  # LinuxCNC has started this in its folder
        status = inside(Path("program").read_text(), float(Path("step").read_text()))
        Path("status").write_text(str(status))
        return status
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", type=Path)
    parser.add_argument("--folder", type=Path, required=True)
    parser.add_argument("--velocity", type=float, default=500)
    parser.add_argument("--acceleration", type=float, default=5000)
    parser.add_argument("--tools", type=Path)
    parser.add_argument("--board")
    parser.add_argument("--scale", type=float, default=400)
    parser.add_argument("--buffer", type=float, default=0.004)
    parser.add_argument("--following", type=float, default=0)
    given = parser.parse_args()
    folder = given.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    prepare(given, folder)
    environment = {**os.environ, "HOME": str(folder), "DISPLAY": ""}
    environment["RTAPI_FIFO_PATH"] = str(folder / "rtapi_fifo")
    if os.getuid() == 0:
        environment["RTAPI_UID"] = str(USER)
        os.chown(folder, USER, -1)
    with open(folder / "log", "w") as log:
        subprocess.run(["linuxcnc", "-r", folder / "simulation.ini"], cwd=folder, env=environment,
                       stdin=subprocess.DEVNULL, stdout=log, stderr=log, timeout=LONGEST + 60)
    ended = folder / "status"
    if not ended.exists() or ended.read_text() != "0":
        sys.exit(f"simulate: LinuxCNC did not run the program: {folder}/log")
    return 0


if __name__ == "__main__":
    sys.exit(main())
