# SPDX-License-Identifier: Apache-2.0
"""README's picture: the demo's report (build/demo/report.html) -> scripts/figures/demo.png."""

import json
import re

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402

from result_table import BUILD, ROOT  # noqa: E402

STYLE = {
    "figure.facecolor": "#10171f", "axes.facecolor": "#10171f", "axes.edgecolor": "#2a3644",
    "text.color": "#e4e9ef", "axes.labelcolor": "#93a3b5", "xtick.color": "#93a3b5",
    "ytick.color": "#93a3b5", "grid.color": "#2a3644", "axes.grid": True, "font.size": 9,
    "axes.titlesize": 10, "axes.titlelocation": "left",
}
BAND = "#3fb6ff"
LIMIT = "#ff6b5e"


def save(figure, name):
    """Writes scripts/figures/NAME.png, in few colours; from the same figure the same bytes."""
    figure.canvas.draw()
    image = Image.fromarray(np.asarray(figure.canvas.buffer_rgba())).convert("RGB").quantize(128)
    image.save(ROOT / f"scripts/figures/{name}.png", optimize=True)


def page_data():
    page = (BUILD / "demo/report.html").read_text()
    return json.loads(re.search(r"const D = (\{.*?\});\n", page, re.S)[1])


def path(axes, data):
    """The samples, coloured by the square root of the feed as on the page."""
    x, y, z = (np.array(data[axis]) for axis in "xyz")
    axes.scatter(x, y, z, c=np.sqrt(data["feed"]), cmap="viridis", s=0.6)
    axes.set_box_aspect([np.ptp(x), np.ptp(y), max(np.ptp(z), 0.25 * np.ptp(x))], zoom=1.08)
    axes.set(xlabel="x, mm", ylabel="y, mm")
    axes.zaxis.set_tick_params(pad=0)
    axes.view_init(38, -70)
    for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
        axis.set_pane_color((0, 0, 0, 0))
        axis.set_major_locator(plt.MaxNLocator(4))


def band(axes, rows, span, limit):
    """Least and largest value of each of the page's intervals, with the machine's limit."""
    low, high = np.array(rows).T
    at = np.linspace(0, span, len(rows))
    axes.fill_between(at, low, high, step="mid", color=BAND, lw=0.8)
    for level in (limit, -limit) if low.min() < 0 else (limit,):
        axes.axhline(level, color=LIMIT, lw=1, ls="--")
    axes.set(xlim=(0, span))


def main():
    data = page_data()
    plt.rcParams.update(STYLE)
    figure = plt.figure(figsize=(10, 5.2), dpi=110)
    grid = figure.add_gridspec(3, 2, width_ratios=[1.3, 1], hspace=0.62, wspace=0.22,
                               left=0.0, right=0.985, top=0.92, bottom=0.09)
    space = figure.add_subplot(grid[:, 0], projection="3d")
    path(space, data)
    figure.text(0.015, 0.945, f"{data['title']}: {data['path_mm']:.0f} mm in"
                f" {data['duration_s']:.1f} s, coloured by feed", fontsize=10)

    error, speed, acceleration = (figure.add_subplot(grid[row, 1]) for row in range(3))
    at = np.linspace(0, data["path_mm"], len(data["errors"]))
    error.fill_between(at, data["errors"], step="mid", color=BAND, lw=0.8)
    error.plot(at, data["bounds"], color=LIMIT, lw=1, ls="--")
    error.set(title=f"Error before rounding, derived bound, units of {data['unit']}",
              xlim=(0, at[-1]), xlabel="path, mm")
    band(speed, data["speed"], data["duration_s"], data["velocity"])
    speed.set(title="Speed and its limit, mm/s", xticklabels=[])
    window = data["window"]
    band(acceleration, data["total"], data["duration_s"], window["acceleration"])
    acceleration.set(title=f"Acceleration, means over {window['ms']:g} ms, and their limit,"
                     " mm/s\u00b2", xlabel="time, s")
    save(figure, "demo")


if __name__ == "__main__":
    main()
