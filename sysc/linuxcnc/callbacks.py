#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The path of a program by LinuxCNC's own Python side alone: the reference of interpret.py.

    callbacks.py PROGRAM --scratch FOLDER --ini FILE --path FILE

Knows nothing of canon_recorder.cpp: offsets and rotation are those of LinuxCNC's Python modules.
Writes vertices as ten doubles: X Y Z (mm) A B C (degrees) U V W (mm), and how far the radii at the
ends of its arc differ (mm). Arcs are chords within ARC_ERROR, splines LinuxCNC's own 60 chords.
"""

import argparse
import array
import math
import os
import sys
from pathlib import Path

import gcode
from interpret import Ini, Refused, Tools, check, settings_of
from rs274.interpret import Translated

INCH = 25.4  # mm: the module counts in inches
ARC_ERROR = 1e-5  # mm
SAME_ANGLE = 1e-6  # LinuxCNC's: below, a full turn


class Path9(Translated):
    """Collects vertices."""

    def __init__(self, ini, tools, parameters):
        self.ini = ini
        self.tools = tools
        self.parameter_file = str(parameters)
        self.set_xy_rotation(0)
        self.lo = (0.0,) * 9
        self.tool = (0.0,) * 9
        self.plane = 1
        self.vertices = array.array("d", [0.0] * 10)

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return lambda *_: None

    def set_plane(self, plane):
        self.plane = plane

    def vertex(self, place, mismatch=0.0):
        self.lo = tuple(place)
        at = [p + t for p, t in zip(place, self.tool)]
        self.vertices.extend(v if 3 <= i < 6 else v * INCH for i, v in enumerate(at))
        self.vertices.append(mismatch * INCH)

    def program_place(self):
        """The last vertex as the program counts it."""
        offset = [getattr(self, f"g5x_offset_{axis}") for axis in "xyzabcuvw"]
        shift = [getattr(self, f"g92_offset_{axis}") for axis in "xyzabcuvw"]
        place = [p - o for p, o in zip(self.lo, offset)]
        x, y = place[:2]
        place[0] = x * self.rotation_cos + y * self.rotation_sin
        place[1] = y * self.rotation_cos - x * self.rotation_sin
        return [p - s for p, s in zip(place, shift)]

    def straight_traverse_translated(self, *place):
        self.vertex(place)

    straight_feed_translated = straight_traverse_translated

    def straight_probe(self, *place):
        self.straight_feed(*place)

    def rigid_tap(self, x, y, z):
        back = self.lo
        self.vertex((*self.rotate_and_translate(x, y, z, 0, 0, 0, 0, 0, 0)[:3], *back[3:]))
        self.vertex(back)

    def arc_feed(self, x1, y1, cx, cy, turns, z1, *rest):
        start = self.program_place()
        first, second, third = {1: (0, 1, 2), 2: (1, 2, 0), 3: (2, 0, 1)}[self.plane]
        end = [0.0, 0.0, 0.0, *rest]
        end[first], end[second], end[third] = x1, y1, z1
        begin = math.atan2(start[second] - cy, start[first] - cx)
        radius = math.hypot(start[first] - cx, start[second] - cy)
        grown = math.hypot(x1 - cx, y1 - cy) - radius
        sign = 1 if turns > 0 else -1
        angle = sign * (math.atan2(y1 - cy, x1 - cx) - begin) % math.tau
        if angle < SAME_ANGLE or angle > math.tau - SAME_ANGLE:
            angle = math.tau
        angle += math.tau * (abs(turns) - 1)
        step = 2 * math.acos(max(0.5, 1 - ARC_ERROR / (radius * INCH)))
        count = math.ceil(angle / step)
        for i in range(1, count + 1):
            part = i / count
            place = [s + (e - s) * part for s, e in zip(start, end)]
            if i < count:
                at = begin + sign * angle * part
                place[first] = cx + (radius + grown * part) * math.cos(at)
                place[second] = cy + (radius + grown * part) * math.sin(at)
            self.vertex(self.rotate_and_translate(*place), abs(grown))

    def tool_offset(self, *offset):
        self.lo = tuple(p + t - o for p, t, o in zip(self.lo, self.tool, offset))
        self.tool = offset

    def get_axis_mask(self):
        return self.ini.axis_mask()

    def get_external_length_units(self):
        return 1.0 if self.ini.metric() else 1 / INCH

    def get_external_angular_units(self):
        return 1.0

    def get_block_delete(self):
        return False

    def check_abort(self):
        return False

    def get_tool(self, slot):
        return self.tools.tuple_of(slot)

    def change_tool(self, slot):
        self.tools.in_spindle = slot


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    for name in ("scratch", "ini", "path"):
        parser.add_argument(f"--{name}", required=True)
    given = parser.parse_args()
    ini = Ini(given.ini)
    scratch = Path(given.scratch)
    canon = Path9(ini, Tools(ini, scratch), settings_of(ini, given.program, scratch))
    result, _ = gcode.parse(given.program, canon, f"G2{1 if ini.metric() else 0}", "")
    try:
        check(result)
    except Refused as refused:
        print(f"{refused.line}: {refused}", file=sys.stderr)
        os._exit(1)
    with open(given.path, "wb") as file:
        canon.vertices.tofile(file)
    os._exit(0)  # libraries of LinuxCNC do not always end well


if __name__ == "__main__":
    main()
