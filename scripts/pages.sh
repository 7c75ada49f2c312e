#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes every figure of the pages that is the same on every machine, and fails if a page says
# something else. Half an hour; CI runs it beside the tests.
#
#   scripts/pages.sh [--write]     --write: writes them into the pages instead
set -euo pipefail
mode=(--check --measured)
case ${1:-} in
  "") ;;
  --write) mode=() ;;
  -h | --help)
    sed -n '3,6s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
  *)
    echo "pages: unknown option '$1': --write is there" >&2
    exit 2
    ;;
esac
cd "$(dirname "$0")/.."
scripts/setup.sh
PATH=$PWD/.venv/bin:$PATH
cmake --preset release >/dev/null
cmake --build --preset release -j "$(nproc)" --target curvecore benches
mkdir -p build/figures
for bench in paper_table spline_tables cam_tables form_tables hold_tables idle_tables \
  search_tables; do
  "build/release/tb/bench/$bench" -o "build/figures/$bench.json" >/dev/null
done
build/release/tb/bench/other_interpolators -o build/figures/others.json >/dev/null
rm -rf build/demo
build/curvecore run tb/data/demo.ngc -o build/demo -q
mkdir -p build/figures/choose
build/curvecore choose --error 1um --radius 300mm --feed 10m/min --device up5k \
  --sample-rate 1MHz >build/figures/choose/impossible.txt || [ $? = 3 ]
build/curvecore choose --error 1nm --radius 1m --feed 60m/min --device ecp5-25 \
  -q -o build/figures/choose/ecp5
build/curvecore choose --error 1nm --length 10mm --feed 1m/min --device ecp5-25 \
  --build parallel -q -o build/figures/choose/splines
build/curvecore compare --curves splines --set Order=4 --set CoefBits=24:36:4 --set Mode=1 \
  --set ParameterGuard=0,4,8 --segments 1000 -q -o build/figures/parameter_guard
if [ ${#mode[@]} = 0 ]; then
  python3 scripts/others_figure.py
  python3 scripts/demo_figure.py
fi
scripts/results.py "${mode[@]}"
