# SPDX-License-Identifier: Apache-2.0
"""The figure of tb/README.md: build/figures/others.json -> scripts/figures/others.svg."""

import json
import pathlib

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "curvecore"  # the same figures, the same file
import matplotlib.pyplot as plt  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent
MARKS = ["o", "s", "^", "D"]


def main():
    rows = json.loads((ROOT / "build/figures/others.json").read_text())["rows"]
    curves = list(dict.fromkeys(row["curve"] for row in rows))
    methods = list(dict.fromkeys(row["method"] for row in rows))
    figure, axes = plt.subplots(figsize=(8, 4.2))
    for number, method in enumerate(methods):
        for mark, curve in zip(MARKS, curves, strict=True):
            row = next(r for r in rows if (r["curve"], r["method"]) == (curve, method))
            axes.plot(row["bits_per_mm"], row["off_mm"], mark, color=f"C{number}", markersize=8)
    handles = [plt.Line2D([], [], marker="s", ls="", color=f"C{n}") for n in range(len(methods))]
    handles += [plt.Line2D([], [], marker=mark, ls="", color="0.5") for mark in MARKS]
    axes.legend(handles, methods + curves, fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))
    axes.set(xscale="log", yscale="log", xlabel="bits sent per mm", ylabel="off the curve, mm")
    axes.grid(alpha=0.3)
    figure.savefig(ROOT / "scripts/figures/others.svg", bbox_inches="tight",
                   metadata={"Date": None})


if __name__ == "__main__":
    main()
