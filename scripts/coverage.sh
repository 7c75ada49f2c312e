#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Line and branch coverage of ref, hls, rtl and sysc by the tests of models, units and commands, to
# build/figures/coverage.json and, line by line, build/coverage/uncovered.txt. Half an hour or so.
#
#   scripts/coverage.sh
set -euo pipefail
case ${1:-} in
  "") ;;
  -h | --help)
    sed -n '3,6s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
  *)
    echo "coverage: takes no arguments" >&2
    exit 2
    ;;
esac
cd "$(dirname "$0")/.."
scripts/setup.sh
PATH=$PWD/.venv/bin:$PATH
build=build/coverage
cmake --preset coverage >/dev/null
cmake --build --preset coverage -j "$(nproc)" --target label_model label_unit label_cli
find "$build" \( -name '*.gcda' -o -name 'coverage.*.dat' \) -delete
# Few samples show the same lines as many. What fails here fails in scripts/test.sh too, or takes
# longer than its test allows.
CURVECORE_SAMPLES=5000 ctest --preset coverage -L 'model|unit|cli' -LE '^long$' >$build/tests.log ||
  sed -n '/tests passed/,$p' $build/tests.log
mkdir -p build/figures
python3 scripts/coverage_points.py
scripts/results.py coverage
