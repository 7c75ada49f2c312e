#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The benchmarks, one run: the kernel beside the same loop by hand, arcs and the demo part through
# the RTL at 100,000 samples a second, the papers' tables. Prints rows and writes build/bench.json.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
PATH=$PWD/.venv/bin:$PATH
cmake --preset release >/dev/null
cmake --build --preset release -j "$(nproc)"
mkdir -p build/bench build/figures
for bench in kernel spline; do
  "build/release/tb/bench/${bench}_bench" --benchmark_repetitions=3 \
    --benchmark_report_aggregates_only=true \
    --benchmark_out="build/bench/$bench.json" --benchmark_out_format=json
done
build/release/tb/bench/paper_table -o build/figures/paper_table.json >/dev/null
build/release/tb/bench/spline_tables -o build/figures/spline_tables.json >/dev/null
build/release/tb/bench/other_interpolators -o build/figures/others.json
python3 scripts/others_figure.py
for part in arcs demo; do
  for build in parallel serial; do
    rm -rf "build/bench/$part-$build"
    build/curvecore run "tb/data/$part.ngc" -o "build/bench/$part-$build" --build "$build" \
      --sample-period 10us -q
  done
done
python3 scripts/bench_rows.py
