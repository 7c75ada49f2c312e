# SPDX-License-Identifier: Apache-2.0
"""The figure of ref/feed/README.md of cycle times over the optimum: build/figures/oracle.json ->
scripts/figures/time_over_optimum.png."""

import json

from demo_figure import plt, save
from result_table import BUILD

FEED = 500.0  # mm/s, the machine's highest


def main():
    rows = json.loads((BUILD / "figures/oracle.json").read_text())["rows"]
    rows = [row for row in rows if row["feed_mm_s"] == FEED]
    figure, axes = plt.subplots(figsize=(8, 3.4), dpi=110, layout="constrained")
    for number, effort in enumerate(("rules", "optimum")):
        places = [place + 0.4 * number for place in range(len(rows))]
        bars = axes.bar(places, [row[f"{effort}_s"] / row["oracle_s"] for row in rows], 0.38,
                        label=f"--effort {effort}")
        axes.bar_label(bars, fmt="%.2f", fontsize=6)
    axes.axhline(1, color="0.3", lw=1)
    axes.set_xticks([place + 0.2 for place in range(len(rows))], [row["path"] for row in rows],
                    rotation=30, ha="right")
    axes.set(ylim=(0.9, None), ylabel=f"time / shortest possible, {FEED:.0f} mm/s")
    axes.legend(fontsize=8)
    save(figure, "time_over_optimum")


if __name__ == "__main__":
    main()
