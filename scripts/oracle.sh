#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# How far the planner is from the time optimum of an independent oracle: pages of scripts/results,
# build/figures/oracle.json, drawn.json, and a figure. Some minutes.
set -euo pipefail
case ${1:-} in
  -h | --help)
    sed -n '3,4s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
esac
cd "$(dirname "$0")/.."
scripts/setup.sh
PATH=$PWD/.venv/bin:$PATH
cmake --preset release >/dev/null
cmake --build --preset release -j "$(nproc)" --target curvecore
mkdir -p build/figures
python3 tb/oracle/time_over_optimum.py --program build/curvecore -o build/figures/oracle.json
python3 tb/oracle/drawn_over_optimum.py --program build/curvecore -o build/figures/drawn.json
python3 scripts/time_figure.py
scripts/results.py oracle drawn
