# SPDX-License-Identifier: Apache-2.0
"""The shortest time along a path under limits of velocity, acceleration and jerk, by collocation:
an oracle for the planner, which shares no code with it.

Grid points on the path; between two of them the jerk along the path is constant in time:

    ds = v h + a h^2/2 + j h^3/6      dv = a h + j h^2/2      da = j h

The limits hold at both ends of every interval, with the path's derivatives as seen from within:

    |r'| v <= V    |r' a + r'' v^2| <= A    |r' j + 3 r'' v a + r''' v^3| <= J

for the path, and for each axis that has limits of its own.  Where r'' steps (a joint) its step
takes the joint time T: v^2 |dr''| <= J T.  IPOPT (by casadi)
minimises the sum of h.  The problem is not convex: a start from a fast motion may find a better
optimum than one from a slow one.
"""

from dataclasses import dataclass

import casadi
import numpy as np


@dataclass(frozen=True)
class Limits:
    """Limits of the path, and of X Y Z if they have their own: (velocity, acceleration, jerk)."""

    velocity: float = 500.0
    acceleration: float = 5000.0
    jerk: float = 100000.0
    joint_time: float = 1e-3
    axes: tuple = ()

    def shares(self, acceleration, jerk):
        """Reduces the limits inside the path; joints keep the whole limit."""
        axes = tuple((v, a * acceleration, j * jerk) for v, a, j in self.axes)
        return Limits(self.velocity, self.acceleration * acceleration, self.jerk * jerk,
                      self.joint_time / jerk, axes)

    def each(self):
        """Returns (rows of X Y Z concerned, velocity, acceleration, jerk) of every limit."""
        yield slice(0, 3), self.velocity, self.acceleration, self.jerk
        for i, (velocity, acceleration, jerk) in enumerate(self.axes):
            yield slice(i, i + 1), velocity, acceleration, jerk

    def ramp(self):
        """Time to full acceleration of the quickest limit."""
        return min(acceleration / jerk for _, _, acceleration, jerk in self.each())


@dataclass
class Motion:
    """State at grid points: place, velocity, acceleration, time from the start."""

    s: np.ndarray
    v: np.ndarray
    a: np.ndarray
    t: np.ndarray

    @property
    def duration(self):
        return self.t[-1]

    def slowed(self, factor):
        return Motion(self.s, self.v / factor, self.a / factor**2, self.t * factor)


def grid_of(curves, count):
    """Returns places, denser near rest and with all joints; the curve of each interval, its s."""
    total = sum(curve.length for curve in curves)
    u = np.linspace(0, 1, count + 1)
    even = total * u**2 * (3 - 2 * u)
    joints = np.cumsum([curve.length for curve in curves])
    places = np.unique(np.concatenate((even, joints[:-1])))
    gap = total / count / 20
    keep = [0.0]
    for place in places[1:]:
        if np.any(np.isclose(joints, place, rtol=0, atol=1e-12)) and place - keep[-1] < gap:
            if keep[-1] not in joints and len(keep) > 1:
                keep.pop()
        elif place - keep[-1] < gap * min(1, keep[-1] / total * 20 + 1e-3):
            continue
        keep.append(place)
    keep[-1] = total
    return np.array(keep)


def ends_of(curves, s):
    """Derivatives at the start and at the end of every interval, each seen from within."""
    joints = np.concatenate(([0], np.cumsum([curve.length for curve in curves])))
    middle = (s[:-1] + s[1:]) / 2
    index = np.clip(np.searchsorted(joints, middle) - 1, 0, len(curves) - 1)
    found = []
    for places in (s[:-1], s[1:]):
        parts = [np.zeros((3, len(middle))) for _ in range(3)]
        for k, curve in enumerate(curves):
            on = index == k
            if not on.any():
                continue
            local = np.clip(places[on] - joints[k], 0, curve.length)
            for part, value in zip(parts, curve.derivatives(local)):
                part[:, on] = value
        found.append(parts)
    return found


def oracle(curves, limits, feed, count=400, start=None, quiet=True):
    """Solves for the least time; feed in mm/s; `start`: a Motion to begin from, or a slow bump."""
    s = grid_of(curves, count)
    n = len(s) - 1
    ds = np.diff(s)
    ends = ends_of(curves, s)
    top = min(limits.velocity, feed)
    if start is None:
        v0, a0, h0 = bump(s, ends, limits, top)
    else:
        v0 = np.interp(s, start.s, start.v)
        a0 = np.interp(s, start.s, start.a)
        h0 = np.maximum(np.diff(np.interp(s, start.s, start.t)), 1e-6)
    # Of order one: time in units of `unit`, length as it is.
    unit = limits.ramp()
    v = casadi.MX.sym("v", n + 1)
    a = casadi.MX.sym("a", n + 1)
    j = casadi.MX.sym("j", n)
    h = casadi.MX.sym("h", n)
    va, vb, aa, ab = v[:-1], v[1:], a[:-1], a[1:]
    equal = [va * h + aa * h**2 / 2 + j * h**3 / 6 - ds,
             va + aa * h + j * h**2 / 2 - vb,
             aa + j * h - ab]
    less = []
    for (first, second, third), speed, gain in zip(ends, (va, vb), (aa, ab)):
        loads = [first[i] * gain + second[i] * speed**2 for i in range(3)]
        pulls = [first[i] * j + 3 * second[i] * speed * gain + third[i] * speed**3
                 for i in range(3)]
        for rows, _, acceleration, jerk in limits.each():
            if not first[rows].any() and not second[rows].any():
                continue
            less.append(sum(x * x for x in loads[rows]) / (acceleration * unit**2)**2)
            less.append(sum(x * x for x in pulls[rows]) / (jerk * unit**3)**2)
    caps = velocities(ends, limits, top) * unit
    caps[0] = caps[-1] = 0
    rest = np.full(n + 1, np.inf)
    rest[0] = rest[-1] = 0
    problem = {"x": casadi.vertcat(v, a, j, h), "f": casadi.sum1(h),
               "g": casadi.vertcat(*equal, *less)}
    options = {"print_time": 0, "ipopt": {"print_level": 0 if quiet else 5, "tol": 1e-8,
                                          "max_iter": 3000, "sb": "yes"}}
    solver = casadi.nlpsol("oracle", "ipopt", problem, options)
    j0 = np.diff(a0) / h0
    found = solver(
        x0=np.concatenate((v0 * unit, a0 * unit**2, j0 * unit**3, h0 / unit)),
        lbx=np.concatenate((np.zeros(n + 1), -rest, np.full(n, -np.inf), np.full(n, 1e-9))),
        ubx=np.concatenate((caps, rest, np.full(n, np.inf), np.full(n, np.inf))),
        lbg=np.concatenate((np.zeros(3 * n), np.full(len(less) * n, -np.inf))),
        ubg=np.concatenate((np.zeros(3 * n), np.ones(len(less) * n))))
    if not solver.stats()["success"]:
        return None
    x = np.array(found["x"]).ravel()
    times = x[-n:] * unit
    return Motion(s, x[:n + 1] / unit, x[n + 1:2 * n + 2] / unit**2,
                  np.concatenate(([0], np.cumsum(times))))


def velocities(ends, limits, top):
    """Returns the worst at the grid's points: from within on both sides, and through joints."""
    caps = np.full(ends[0][0].shape[1] + 1, top)
    steps = ends[0][1][:, 1:] - ends[1][1][:, :-1]
    for rows, velocity, _, jerk in limits.each():
        for (first, _, _), cut in zip(ends, (slice(None, -1), slice(1, None))):
            rate = np.linalg.norm(first[rows], axis=0)
            caps[cut] = np.minimum(caps[cut], velocity / np.maximum(rate, 1e-9))
        step = np.linalg.norm(steps[rows], axis=0)
        joint = step > 1e-9
        through = np.sqrt(jerk * limits.joint_time / step[joint])
        caps[1:-1][joint] = np.minimum(caps[1:-1][joint], through)
    return caps


def bump(s, ends, limits, top):
    """A slow motion within the limits, as a start."""
    u = np.linspace(0, 1, 4001)
    place = s[-1] * u**3 * (10 - 15 * u + 6 * u**2)
    at = np.interp(s, place, u)
    speed = s[-1] * 30 * at**2 * (1 - at)**2
    gain = s[-1] * 60 * at * (1 - at) * (1 - 2 * at)
    change = s[-1] * 60 * (1 - 6 * at + 6 * at**2)
    duration = speed.max() / top
    for (first, second, third), cut in zip(ends, (slice(None, -1), slice(1, None))):
        v, a, j = speed[cut], gain[cut], change[cut]
        moves = first * v, first * a + second * v**2, first * j + 3 * second * v * a + third * v**3
        for rows, *most in limits.each():
            for order, (load, limit) in enumerate(zip(moves, most), 1):
                worst = np.linalg.norm(load[rows], axis=0).max()
                duration = max(duration, (worst / limit)**(1 / order))
    duration *= 1.02
    return speed / duration, gain / duration**2, np.maximum(np.diff(at) * duration, 1e-7)
