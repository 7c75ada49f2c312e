#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Gathers build/bench/ into build/bench.json: rows of what was measured, each with its figure."""

import json
import pathlib

BENCH = pathlib.Path(__file__).resolve().parent.parent / "build" / "bench"


def kernel_rates():
    """Median samples per second of each loop."""
    runs = json.loads((BENCH / "kernel.json").read_text())["benchmarks"]
    return {
        run["run_name"]: run["items_per_second"]
        for run in runs
        if run["aggregate_name"] == "median"
    }


def main():
    rate = kernel_rates()
    dense, sparse = rate["kernel/samples_per_step/64"], rate["kernel/samples_per_step/1"]
    rows = [
        ("kernel, one core, 64 samples per step", f"{dense / 1e6:.1f} M samples/s"),
        ("kernel / the same loop by hand", f"{dense / rate['by_hand/samples_per_step/64']:.2f}"),
        ("kernel, one core, 1 sample per step", f"{sparse / 1e6:.1f} M samples/s"),
    ]
    for build in ("parallel", "serial"):
        report = json.loads((BENCH / build / "report.json").read_text())
        clocks = report["simulation_clocks_per_second"]
        per_sample = report["clocks_per_sample"]
        rows += [
            (f"{build}: clocks per sample, demo part", f"{per_sample:.3f}"),
            (
                f"{build}: `curvecore run`, every check on",
                f"{clocks / per_sample / 1e6:.2f} M samples/s",
            ),
            (f"{build}: simulation", f"{clocks / 1e6:.1f} M clocks/s"),
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
