#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The benchmarks, one run: the kernel beside the same loop by hand, the planner, arcs and the demo
# part through the RTL at 100,000 samples a second, what choose answers and a placement of it.
# Prints rows and writes build/bench.json.  Figures that are the same on every machine:
# scripts/pages.sh.
set -euo pipefail
case ${1:-} in
  "") ;;
  -h | --help)
    sed -n '3,6s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
  *)
    echo "bench: takes no arguments" >&2
    exit 2
    ;;
esac
cd "$(dirname "$0")/.."
scripts/setup.sh
PATH=$PWD/.venv/bin:$PATH
cmake --preset release >/dev/null
cmake --build --preset release -j "$(nproc)" --target curvecore benches
mkdir -p build/bench build/figures
for bench in kernel spline; do
  "build/release/tb/bench/${bench}_bench" --benchmark_repetitions=3 \
    --benchmark_report_aggregates_only=true \
    --benchmark_out="build/bench/$bench.json" --benchmark_out_format=json
done
build/release/tb/bench/planner_speed -o build/figures/planner.json
build/curvecore choose --error 1um --radius 300mm --feed 10m/min --device up5k \
  --confirm -q -o build/figures/choose/up5k
for part in arcs demo; do
  for way in "parallel 10us" "engine 1ms"; do
    read -r build period <<<"$way"
    rm -rf "build/bench/$part-$build"
    build/curvecore run "tb/data/$part.ngc" -o "build/bench/$part-$build" --build "$build" \
      --sample-period "$period" -q
  done
done
python3 scripts/system_rates.py
python3 scripts/bench_rows.py
scripts/results.py choose_up5k throughput system_rates planner_effort planner_threads
