#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The benchmarks, one run: the kernel beside the same loop by hand, arcs and the demo part through
# the RTL at 100,000 samples a second, the papers' tables, others' methods, what choose answers.
# Prints rows and writes build/bench.json.
set -euo pipefail
case ${1:-} in
  "") ;;
  -h | --help)
    sed -n '3,5s/^# \{0,1\}//p' "$0"
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
cmake --build --preset release -j "$(nproc)" --target all benches
mkdir -p build/bench build/figures
for bench in kernel spline; do
  "build/release/tb/bench/${bench}_bench" --benchmark_repetitions=3 \
    --benchmark_report_aggregates_only=true \
    --benchmark_out="build/bench/$bench.json" --benchmark_out_format=json
done
build/release/tb/bench/paper_table -o build/figures/paper_table.json >/dev/null
build/release/tb/bench/spline_tables -o build/figures/spline_tables.json >/dev/null
build/release/tb/bench/cam_tables -o build/figures/cam_tables.json >/dev/null
build/release/tb/bench/form_tables -o build/figures/form_tables.json >/dev/null
build/release/tb/bench/hold_tables -o build/figures/hold_tables.json >/dev/null
build/release/tb/bench/idle_tables -o build/figures/idle_tables.json >/dev/null
build/release/tb/bench/search_tables -o build/figures/search_tables.json >/dev/null
build/release/tb/bench/planner_speed
build/release/tb/bench/other_interpolators -o build/figures/others.json
python3 scripts/others_figure.py
rm -rf build/demo
build/curvecore run tb/data/demo.ngc -o build/demo -q
python3 scripts/demo_figure.py
build/release/tb/bench/order_words -o build/figures/order_words.json >/dev/null
build/curvecore choose --error 1um --radius 300mm --feed 10m/min --device up5k \
  --confirm -q -o build/figures/choose/up5k
build/curvecore choose --error 1nm --radius 1m --feed 60m/min --device ecp5-25 \
  -q -o build/figures/choose/ecp5
build/curvecore choose --error 1nm --length 10mm --feed 1m/min --device ecp5-25 \
  --build parallel -q -o build/figures/choose/splines
build/curvecore choose --error 1um --radius 300mm --feed 10m/min --device up5k \
  --sample-rate 1MHz >build/figures/choose/impossible.txt || [ $? = 3 ]
build/curvecore compare --curves splines --set Order=4 --set CoefBits=24:36:4 --set Mode=1 \
  --set ParameterGuard=0,4,8 --segments 1000 -q -o build/figures/parameter_guard
for part in arcs demo; do
  for build in parallel serial; do
    rm -rf "build/bench/$part-$build"
    build/curvecore run "tb/data/$part.ngc" -o "build/bench/$part-$build" --build "$build" \
      --sample-period 10us -q
  done
done
python3 scripts/system_rates.py
python3 scripts/bench_rows.py
