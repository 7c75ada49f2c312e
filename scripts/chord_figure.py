#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""README's picture of chords beside the curve -> scripts/figures/chords.png.

On the left a quarter of a circle and three chords. On the right chords that stay within e of a
circle of radius R at the feed v: each spans 2 acos(1 - e/R), by which the velocity turns at once at
each corner.
"""

import math

import numpy as np

from demo_figure import BAND, LIMIT, STYLE, plt, save

RADIUS = 10.0  # mm
FEED = 100.0  # mm/s
ERROR = 0.01  # mm
SHOWN = 4  # chords of the right side


def main():
    turn = 2 * math.acos(1 - ERROR / RADIUS)
    corners = turn * (np.arange(SHOWN + 1) - SHOWN / 2)
    fine = np.linspace(corners[0], corners[-1], 97)
    quarter = np.linspace(0, math.pi / 2, 61)
    with plt.rc_context(STYLE):
        figure, (path, speed) = plt.subplots(1, 2, figsize=(8.4, 2.9), dpi=110,
                                           gridspec_kw={"width_ratios": (1, 1.9)})
        path.plot(RADIUS * np.cos(quarter), RADIUS * np.sin(quarter), color=BAND, label="the curve")
        path.plot(RADIUS * np.cos(quarter[::20]), RADIUS * np.sin(quarter[::20]), ".-",
                  color=LIMIT, label="chords")
        path.set(xlabel="x, mm", ylabel="y, mm", title="what an axis is told", aspect="equal")
        path.legend(fontsize=8, loc="lower left", frameon=False)
        time = RADIUS * (fine - corners[0]) / FEED * 1000
        speed.plot(time, -FEED * np.sin(fine), color=BAND)
        middles = (corners[:-1] + corners[1:]) / 2
        speed.stairs(-FEED * np.sin(middles), RADIUS * (corners - corners[0]) / FEED * 1000,
                     color=LIMIT, baseline=None)
        speed.set(xlabel="t, ms", ylabel="y velocity, mm/s",
                  title=f"chords {ERROR * 1000:g} um off a circle of {RADIUS:g} mm,"
                  f" at {FEED:g} mm/s:\nthe velocity jumps by {FEED * turn:.1f} mm/s a corner")
        figure.tight_layout()
        save(figure, "chords")


if __name__ == "__main__":
    main()
