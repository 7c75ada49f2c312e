#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs what the program needs and this machine lacks, builds it, runs a part through the RTL.
#
#   scripts/demo.sh [FILE] [OPTIONS]     default: tb/data/demo.ngc
#
# OPTIONS go to `curvecore run` (build/curvecore run --help).
set -euo pipefail
case ${1:-} in
  -h | --help)
    sed -n '3,7s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
esac
root=$(cd "$(dirname "$0")/.." && pwd)
file=$root/tb/data/demo.ngc
case ${1:-} in
  "" | -*) ;;
  *)
    file=$1
    shift
    ;;
esac
here=$PWD
cd "$root"
scripts/setup.sh run
# The tests need more tools: only a tree that has been configured for them is kept so.
tests=$(sed -n 's/^CURVECORE_TESTS:BOOL=//p' build/release/CMakeCache.txt 2>/dev/null) || true
cmake --preset release --no-warn-unused-cli -DCURVECORE_TESTS="${tests:-OFF}" >/dev/null
cmake --build --preset release -j "$(nproc)" --target curvecore
cd "$here" # in which FILE and those of OPTIONS are
out=$root/build/demo
status=0
"$root/build/curvecore" run "$file" -o "$out" "$@" || status=$?
[ $status = 2 ] && exit 2
echo
echo "report and pictures  $out/report.html"
echo "figures              $out/report.json"
echo "samples              $out/samples.csv"
[ -e "$out/waves.fst" ] && echo "waveform             gtkwave $out/waves.gtkw"
exit $status
