#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Gathers build/bench/ into build/bench.json: rows of measurements, each with its figure."""

import json
import pathlib

BENCH = pathlib.Path(__file__).resolve().parent.parent / "build" / "bench"


def kernel_rates():
    """Median samples per second of each loop."""
    runs = [
        run
        for bench in ("kernel", "spline")
        for run in json.loads((BENCH / f"{bench}.json").read_text())["benchmarks"]
    ]
    return {
        run["run_name"]: run["items_per_second"]
        for run in runs
        if run["aggregate_name"] == "median"
    }


def main():
    rate = kernel_rates()
    ratio = rate["kernel/samples_per_step/64"] / rate["by_hand/samples_per_step/64"]
    rows = [("kernel, arcs / the same loop by hand, 64 samples per step", f"{ratio:.2f}")]
    loops = (
        ("arcs", "kernel"),
        ("splines, polynomial mode", "spline_polynomial"),
        ("splines, series mode", "spline_series"),
    )
    for curves, loop in loops:
        for samples in (64, 1):
            measured = rate[f"{loop}/samples_per_step/{samples}"] / 1e6
            rows.append(
                (
                    f"kernel, {curves}, one core, samples per step: {samples}",
                    f"{measured:.1f} M samples/s",
                )
            )
    parts = (("arcs", "arcs"), ("demo", "demo part, with splines"))
    for build in ("parallel", "engine"):
        for part, name in parts:
            report = json.loads((BENCH / f"{part}-{build}" / "report.json").read_text())
            clocks = report["simulation_clocks_per_second"]
            per_sample = report["clocks_per_sample"]
            rows += [
                (f"{build}: clocks per sample, {name}", f"{per_sample:.3f}"),
                (
                    f"{build}: `curvecore run`, every check on, {name}",
                    f"{clocks / per_sample / 1e6:.2f} M samples/s",
                ),
                (f"{build}: simulation, {name}", f"{clocks / 1e6:.1f} M clocks/s"),
            ]
    (BENCH.parent / "bench.json").write_text(
        json.dumps(
            {"rows": [{"what": what, "measured": measured} for what, measured in rows]}, indent=1
        )
        + "\n"
    )
    for what, measured in rows:
        print(f"{what:45s} {measured}")


if __name__ == "__main__":
    main()
