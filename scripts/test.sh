#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds everything, runs every test but those of label long, which
# scripts/campaign.sh runs; names the slowest ten at the end.
# With a label: builds what its tests need, and runs those.
#
#   scripts/test.sh [-L LABEL] [-R REGEX] [--preset release|debug|asan|coverage]
#
# Labels: model unit system formal lint cli hls.  Other options go to ctest as they are.
set -euo pipefail
cd "$(dirname "$0")/.."
preset=release
targets=()
options=()
while [ $# -gt 0 ]; do
  case $1 in
    --preset)
      preset=$2
      shift
      ;;
    -L)
      case ${2:-} in
        model | unit | system | formal | lint | cli | hls) targets+=("label_$2") ;;
        *)
          echo "test: '${2:-}' is no label: model, unit, system, formal, lint, cli or hls" >&2
          exit 2
          ;;
      esac
      options+=(-L "$2")
      shift
      ;;
    -h | --help)
      sed -n '3,9s/^# \{0,1\}//p' "$0"
      exit 0
      ;;
    *) options+=("$1") ;;
  esac
  shift
done

scripts/setup.sh
PATH=$PWD/.venv/bin:$PATH
cmake --preset "$preset"
cmake --build --preset "$preset" -j "$(nproc)" --target "${targets[@]:-all}"

# Failures are shown as they come; passed tests are counted only.
log=build/$preset/tests.log
status=0
ctest --preset "$preset" -LE "^long$" "${options[@]}" 2>&1 | tee "$log" |
  awk '/tests passed/ {end = 1} !end && !/^ *Start +[0-9]+:|\.+ +Passed /' || status=$?
echo "Slowest tests:"
sed -nE 's|^ *[0-9]+/[0-9]+ +Test +#[0-9]+: +([^ ]+) .* ([0-9.]+) sec.*|\2 s  \1|p' "$log" |
  sort -rn | sed -n 1,10p
echo
sed -n '/tests passed/,$p' "$log"
exit $status
