#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures what a person at the machine waits for: holds, resumes, overrides, words, the planner's
# time beside that of tree 70c751d, which is built in build/before when the clone has it.  Writes
# scripts/results/person.md; ten minutes.
set -euo pipefail
case ${1:-} in
  "") ;;
  -h | --help)
    sed -n '3,5s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
  *)
    echo "person: takes no arguments" >&2
    exit 2
    ;;
esac
cd "$(dirname "$0")/.."
scripts/setup.sh
PATH=$PWD/.venv/bin:$PATH
cmake --preset release >/dev/null
cmake --build --preset release -j "$(nproc)" --target curvecore axis_tables hold_tables \
  override_tables plan_cost
figures=$PWD/build/figures
mkdir -p "$figures"
before=()
if git cat-file -e 70c751d^{commit} 2>/dev/null; then
  rm -rf build/before && mkdir build/before
  git archive 70c751d | tar -x -C build/before
  cp tb/bench/plan_cost.cpp tb/bench/surface.hpp build/before/tb/bench/
  ln -s "$PWD/.venv" build/before/.venv
  (
    cd build/before
    cmake --preset release >/dev/null
    cmake --build --preset release -j "$(nproc)" --target plan_cost
  )
  before=(--before "$PWD/build/before/build/release/tb/bench/plan_cost")
fi
for bench in axis_tables hold_tables override_tables; do
  "build/release/tb/bench/$bench" -o "$figures/$bench.json"
done
python3 scripts/person_plans.py "${before[@]}"
python3 tb/oracle/time_over_optimum.py --program build/curvecore -o "$figures/slow_axis.json" \
  --axes 500,5000,1e5/50,5000,1e5/500,5000,1e5 circle25 wave
python3 tb/wire/person_runs.py build/curvecore "$figures/person_boards.json"
scripts/results.py person
