# SPDX-License-Identifier: Apache-2.0
"""The figure of tb/README.md: build/figures/others.json -> scripts/figures/others.png."""

import json

from demo_figure import plt, save
from result_table import BUILD

MARKS = ["o", "s", "^", "D"]


def main():
    rows = json.loads((BUILD / "figures/others.json").read_text())["rows"]
    curves = list(dict.fromkeys(row["curve"] for row in rows))
    methods = list(dict.fromkeys(row["method"] for row in rows))
    figure, axes = plt.subplots(figsize=(8, 4.2), dpi=110, layout="constrained")
    for number, method in enumerate(methods):
        for mark, curve in zip(MARKS, curves, strict=True):
            row = next(r for r in rows if (r["curve"], r["method"]) == (curve, method))
            axes.plot(row["bits_per_mm"], row["off_mm"], mark, color=f"C{number}", markersize=8)
    handles = [plt.Line2D([], [], marker="s", ls="", color=f"C{n}") for n in range(len(methods))]
    handles += [plt.Line2D([], [], marker=mark, ls="", color="0.5") for mark in MARKS]
    axes.legend(handles, methods + curves, fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))
    axes.set(xscale="log", yscale="log", xlabel="bits sent per mm", ylabel="off the curve, mm")
    axes.grid(alpha=0.3)
    save(figure, "others")


if __name__ == "__main__":
    main()
