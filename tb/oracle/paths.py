# SPDX-License-Identifier: Apache-2.0
"""Paths in closed form: as G-code for the planner, as derivatives by path length for the oracle.

A path is a list of curves; a curve has its G-code, its length and derivatives(s), which gives r',
r'' and r''' (arrays of three rows) at places s from its start.
"""

import math
from dataclasses import dataclass

import numpy as np

HEAD = "G21 G90 G17 G94 G61\n"


@dataclass(frozen=True)
class Line:
    """A line from start along a unit direction."""

    start: tuple
    end: tuple

    @property
    def length(self):
        return math.dist(self.start, self.end)

    @property
    def code(self):
        return f"G1 X{self.end[0]:.9f} Y{self.end[1]:.9f} Z{self.end[2]:.9f}\n"

    def derivatives(self, s):
        along = (np.array(self.end) - np.array(self.start)) / self.length
        flat = np.zeros((3, len(s)))
        return np.outer(along, np.ones(len(s))), flat, flat


@dataclass(frozen=True)
class Arc:
    """An arc counter-clockwise in XY from an angle; a helix if it rises."""

    centre: tuple
    radius: float
    begin: float
    turn: float
    rise: float = 0.0
    z: float = 0.0

    @property
    def length(self):
        return math.hypot(self.radius * self.turn, self.rise)

    @property
    def code(self):
        end = self.begin + self.turn
        x = self.centre[0] + self.radius * math.cos(end)
        y = self.centre[1] + self.radius * math.sin(end)
        turns = max(1, math.ceil(self.turn / (2 * math.pi) - 1e-9))
        return (f"G3 X{x:.9f} Y{y:.9f} Z{self.z + self.rise:.9f}"
                f" I{-self.radius * math.cos(self.begin):.9f}"
                f" J{-self.radius * math.sin(self.begin):.9f} P{turns}\n")

    def derivatives(self, s):
        rate = self.turn / self.length
        angle = self.begin + rate * s
        out = np.array([np.cos(angle), np.sin(angle), 0 * s])
        on = np.array([-np.sin(angle), np.cos(angle), 0 * s])
        speed = self.radius * rate
        first = speed * on
        first[2] += self.rise / self.length
        return first, -speed * rate * out, -speed * rate**2 * on


class Cubic:
    """A cubic by Bezier points; s(u) by quadrature, u(s) by interpolation and Newton's method."""

    def __init__(self, points, parts=4000):
        self.points = np.array(points, float)
        self.parts = parts
        p = self.points
        self.c = np.array([p[0], 3 * (p[1] - p[0]), 3 * (p[0] - 2 * p[1] + p[2]),
                           p[3] - 3 * p[2] + 3 * p[1] - p[0]]).T
        u = np.linspace(0, 1, parts + 1)
        x, w = np.polynomial.legendre.leggauss(5)
        inside = (u[:-1, None] + (x + 1) / 2 / parts).ravel()
        steps = (self.speed(inside).reshape(-1, 5) * w).sum(axis=1) / 2 / parts
        self.u = u
        self.s = np.concatenate(([0], np.cumsum(steps)))

    def velocity(self, u):
        return self.c[:, 1:2] + 2 * self.c[:, 2:3] * u + 3 * self.c[:, 3:4] * u**2

    def speed(self, u):
        return np.linalg.norm(self.velocity(u), axis=0)

    @property
    def length(self):
        return self.s[-1]

    @property
    def code(self):
        p = self.points
        flat = not p[:, 2].any()  # Z K R are the reader's own
        words = [*zip("XYZ", p[3]), *zip("IJK", p[1] - p[0]), *zip("PQR", p[2] - p[3])]
        return "G5" + "".join(f" {letter}{value:.9f}" for letter, value in words
                              if not (flat and letter in "ZKR")) + "\n"

    def derivatives(self, s):
        u = np.interp(s, self.s, self.u)
        for _ in range(3):
            near = np.clip(np.searchsorted(self.s, s) - 1, 0, self.parts - 1)
            x, w = np.polynomial.legendre.leggauss(5)
            half = (u - self.u[near]) / 2
            at = self.u[near][:, None] + half[:, None] * (x + 1)
            here = self.s[near] + half * (self.speed(at.ravel()).reshape(at.shape) * w).sum(axis=1)
            u = np.clip(u + (s - here) / self.speed(u), 0, 1)
        v = self.velocity(u)
        w = 2 * self.c[:, 2:3] + 6 * self.c[:, 3:4] * u
        j = 6 * self.c[:, 3:4] * np.ones_like(u)
        n = np.linalg.norm(v, axis=0)
        vw = (v * w).sum(axis=0)
        first = v / n
        second = (w - v * vw / n**2) / n**2
        # d/ds of the second: by u, over the speed
        vw_u = (w * w).sum(axis=0) + (v * j).sum(axis=0)
        top = w - v * vw / n**2
        top_u = j - (w * vw + v * vw_u) / n**2 + 2 * v * vw**2 / n**4
        third = (top_u / n**2 - 2 * top * vw / n**4) / n
        return first, second, third


def stadium(straight, radius):
    return [Line((0, 0, 0), (straight, 0, 0)),
            Arc((straight, radius), radius, -math.pi / 2, math.pi),
            Line((straight, 2 * radius, 0), (0, 2 * radius, 0)),
            Arc((0, radius), radius, math.pi / 2, math.pi)]


def wave(height, length, rate, step):
    """The wave y = height sin(rate x) as cubics with its slopes every step."""
    curves = []
    count = round(length / step)
    for i in range(count):
        x0, x1 = length * i / count, length * (i + 1) / count
        h = (x1 - x0) / 3
        y0, y1 = height * math.sin(rate * x0), height * math.sin(rate * x1)
        m0 = height * rate * math.cos(rate * x0)
        m1 = height * rate * math.cos(rate * x1)
        curves.append(Cubic([(x0, y0, 0), (x0 + h, y0 + h * m0, 0), (x1 - h, y1 - h * m1, 0),
                             (x1, y1, 0)]))
    return curves


def random_chain(seed, count):
    """Cubics with common tangents, no sharper than their size."""
    random = np.random.default_rng(seed)
    curves = []
    at = np.zeros(3)
    out = np.array([4.0, 0, 0])
    for _ in range(count):
        end = at + np.array([random.uniform(8, 16), random.uniform(-12, 12), 0])
        leave = np.array([random.uniform(3, 7), random.uniform(-6, 6), 0])
        curves.append(Cubic([at, at + out, end - leave, end]))
        at, out = end, leave * random.uniform(0.7, 1.4)
    return curves


def space_chain(seed, count):
    """Smooth cubics as above, in space."""
    random = np.random.default_rng(seed)
    curves = []
    at = np.zeros(3)
    out = np.array([4.0, 0, 0])
    for _ in range(count):
        end = at + random.uniform((6, -10, -10), (12, 10, 10))
        leave = random.uniform((2, -5, -5), (6, 5, 5))
        curves.append(Cubic([at, at + out, end - leave, end]))
        at, out = end, leave * random.uniform(0.7, 1.4)
    return curves


PATHS = {
    "line1": [Line((0, 0, 0), (1, 0, 0))],
    "line10": [Line((0, 0, 0), (10, 0, 0))],
    "line100": [Line((0, 0, 0), (100, 0, 0))],
    "line300": [Line((0, 0, 0), (300, 0, 0))],
    "circle25": [Arc((-25, 0), 25, 0, 2 * math.pi)],
    "circle2": [Arc((-2, 0), 2, 0, 2 * math.pi)],
    "stadium": stadium(60, 10),
    "helix": [Arc((-10, 0), 10, 0, 6 * math.pi, 12)],
    "wave": wave(6, 60, math.pi / 20, 2.5),
    "sine": wave(3, 18.849555921538759, 1, math.pi / 16),
    "random1": random_chain(1, 5),
    "random2": random_chain(2, 5),
    "chain3d": space_chain(3, 20),
}


def code(curves, feed):
    """A program at `feed` mm/min."""
    return f"{HEAD}F{feed:g}\n" + "".join(curve.code for curve in curves) + "M2\n"
