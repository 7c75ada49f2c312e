# SPDX-License-Identifier: Apache-2.0
"""Path that a plan draws, from its segments.json, as curves for the oracle."""

import json

import numpy as np
from paths import Cubic, Line


class Turn:
    """A part of a circle, by its tangents."""

    def __init__(self, segment):
        self.length = segment["length_mm"]
        self.bend = segment["curvature_start_per_mm"]
        self.out = np.array(segment["tangent_start"])
        angle = self.bend * self.length
        self.inward = (np.array(segment["tangent_end"]) - self.out * np.cos(angle)) / np.sin(angle)

    def derivatives(self, s):
        angle = self.bend * s
        along = np.outer(self.out, np.cos(angle)) + np.outer(self.inward, np.sin(angle))
        inward = np.outer(self.inward, np.cos(angle)) - np.outer(self.out, np.sin(angle))
        return along, self.bend * inward, -self.bend**2 * along


def curve(segment, unit):
    if segment["kind"] == "line":
        return Line(tuple(segment["start_mm"]), tuple(segment["end_mm"]))
    if segment["kind"] == "arc":
        return Turn(segment)
    scale = 2.0**segment["lambda"] * unit
    beta = segment["beta"]
    a, b, c = (np.array(segment[name]) * scale * beta**power
               for name, power in (("a", 3), ("b", 2), ("c", 1)))
    start = np.array(segment["start_mm"][:3])
    return Cubic([start, start + c / 3, start + (2 * c + b) / 3, start + a + b + c], 64)


def stretches(file):
    """The path between stops."""
    plan = json.loads(file.read_text())
    found = [[]]
    for segment in plan["segments"]:
        found[-1].append(curve(segment, plan["unit_mm"]))
        if segment["feed_end"] < 1e-6:
            found.append([])
    return found[:-1]
