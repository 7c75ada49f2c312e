# SPDX-License-Identifier: Apache-2.0
"""Programs of short moves and corners as CAM writes them, in G64 P: the planner draws a path."""

import math

import numpy as np


def program(points, tolerance, feed):
    """Lines through points, mm, moved so that they begin at 0; feed in mm/s."""
    places = np.array(points[1:]) - np.array(points[0])
    moves = "".join(f"G1 X{x:.5f} Y{y:.5f} Z{z:.5f}\n" for x, y, z in places)
    return f"G21 G90 G17 G94 G64 P{tolerance:g} F{feed * 60:g}\n{moves}M2\n"


def chords(curve, end, chord):
    """Points of curve(u), 0 .. end, about a chord apart."""
    u = np.linspace(0, end, 200001)
    places = np.array([curve(v) for v in u])
    s = np.concatenate(([0], np.cumsum(np.linalg.norm(np.diff(places, axis=0), axis=1))))
    wanted = np.linspace(0, s[-1], max(2, round(s[-1] / chord) + 1))
    return np.column_stack([np.interp(wanted, s, places[:, i]) for i in range(3)])


def sine(chord):
    return chords(lambda x: (x, 3 * math.sin(x), 0), 60, chord)


def circle(chord):
    return chords(lambda t: (10 * math.cos(t), 10 * math.sin(t), 0), 2 * math.pi, chord)


def turn(chord):
    """A turn between two lines of 40 mm, 5 mm apart."""
    half = chords(lambda t: (40 + 2.5 * math.sin(t), 2.5 - 2.5 * math.cos(t), 0), math.pi, chord)
    return np.vstack(([(0, 0, 0)], half, [(0, 5, 0)]))


def spiral(chord):
    """A round pocket, from inside."""
    return chords(lambda t: ((1 + t / 8) * math.cos(t), (1 + t / 8) * math.sin(t), 0),
                  10 * math.pi, chord)


def surface(chord):
    """Rows of 20 mm, 0.3 mm apart, to and fro over a wavy surface."""
    rows = []
    for k in range(6):
        x = np.arange(0, 20 + chord / 2, chord)
        x = x if k % 2 == 0 else x[::-1]
        y = 0.3 * k * np.ones_like(x)
        rows.append(np.column_stack((x, y, 2 * np.sin(x / 3) * np.cos(y / 2))))
    return np.vstack(rows)


def corners(count, length):
    """Right angles, left and right in turn."""
    points = [(0, 0, 0)]
    for k in range(count + 1):
        x, y, _ = points[-1]
        points.append((x + length, y, 0) if k % 2 == 0 else (x, y + length, 0))
    return points


def stadium(tolerance, feed):
    return (f"G21 G90 G17 G94 G64 P{tolerance:g}\nF{feed * 60:g}\nG1 X60\nG3 Y20 J10\nG1 X0\n"
            "G3 Y0 J-10\nM2\n")


FEED = 500.0  # mm/s: the machine's limits decide
PROGRAMS = {
    "sine, chords of 0.1 mm": program(sine(0.1), 0.005, FEED),
    "sine, chords of 0.02 mm": program(sine(0.02), 0.005, FEED),
    "circle, chords of 0.1 mm": program(circle(0.1), 0.005, FEED),
    "turn, chords of 0.1 mm": program(turn(0.1), 0.005, FEED),
    "spiral, chords of 0.1 mm": program(spiral(0.1), 0.005, FEED),
    "surface, chords of 0.2 mm": program(surface(0.2), 0.01, FEED),
    "40 corners, P 0.1": program(corners(40, 10), 0.1, FEED),
    "40 corners, P 0.02": program(corners(40, 10), 0.02, FEED),
    "stadium, R 10": stadium(0.005, FEED),
}
