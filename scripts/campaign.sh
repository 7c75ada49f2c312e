#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The long form of what the tests do in short: every proof, unit tests of every configuration and of
# broken cores, clang-tidy of every file, 10^9 samples of the RTL against the kernel, accuracy over
# many more curves, drift over 10^7 segments; then the tests of models, units and commands under the
# sanitizers, and coverage. Four hours or so.
#
#   scripts/campaign.sh [SAMPLES]      samples in all, default 10^9; logs in build/campaign
set -euo pipefail
total=${1:-1000000000}
case $total in
  -h | --help)
    sed -n '3,8s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
  "" | *[!0-9]* | 0*)
    echo "campaign: '$total' is no number of samples: digits only, such as 1000000" >&2
    exit 2
    ;;
esac
cd "$(dirname "$0")/.."
scripts/setup.sh
PATH=$PWD/.venv/bin:$PATH
cmake --preset release -DCURVECORE_FULL_CAMPAIGN=ON >/dev/null
cmake --build --preset release -j "$(nproc)" --target all label_long
CURVECORE_TIDY=all ctest --preset release -R "^lint\\..*\\.tidy$"
ctest --preset release -L "^(unit|long)$"
rm -rf build/campaign
mkdir -p build/campaign build/figures

# Every configuration of every core but those of DSP primitives, whose models are slow.
mapfile -t benches < <(find build/release/tb -maxdepth 1 -type f -executable \
  -regex '.*/\(spherical\|spline\|curve\)_interpolator_.*' ! -name '*_ecp5*' ! -name '*_up5k*' |
  sort)
# The more clocks a sample takes, the fewer samples.
share() {
  case $1 in
    *serial*) echo 1 ;;
    *_si8*) echo 5 ;;
    *_si4*) echo 10 ;;
    *_si2*) echo 20 ;;
    *) echo 32 ;;
  esac
}
shares=0
for bench in "${benches[@]}"; do shares=$((shares + $(share "$bench"))); done
echo "${#benches[@]} configurations, $total samples"
for bench in "${benches[@]}"; do
  echo "$bench" $(((total * $(share "$bench") + shares - 1) / shares))
done | xargs -P "$(nproc)" -L 1 sh -c \
  'log=build/campaign/$(basename $0).log
   CURVECORE_SAMPLES=$1 $0 --gtest_filter=*.EqualsKernelOverManySamples >$log 2>&1 ||
     echo "FAILED: $0"
   grep -H "words differ" $log'
# 10^8 steps of the step generator under the monitors of its pins, 2 10^7 in each configuration.
for bench in build/release/tb/step_pins_*; do
  CURVECORE_STEPS=20000000 "$bench" | grep -H --label="$(basename "$bench")" "steps,"
done
CURVECORE_PART=demo.ngc build/release/tb/motion_steps_serial | grep "steps$"
for form in serial flat; do
  CURVECORE_PART=demo.ngc build/release/tb/motion_system_$form --gtest_filter=*.Draws* |
    grep "clocks$"
done
CURVECORE_CUBICS=10000 build/release/tb/model_tests --gtest_filter=SlowClock.* | grep "curves:"
scripts/buses.sh
build/release/tb/campaign/accuracy_campaign --curves 5000 -o build/figures/accuracy.json
build/release/tb/campaign/splines_campaign --curves 2000 -o build/figures/splines.json
build/release/tb/campaign/ranges_campaign --cubics 1000 -o build/figures/ranges.json
build/release/tb/campaign/drift_campaign --segments 10000000 -o build/figures/drift.json
build/release/tb/campaign/limits_campaign --pairs 500 -o build/figures/limits.json ||
  echo "limits: these pairs miss what is asked (ref/feed/README.md, Effort)"

python3 - <<'PYTHON'
import glob
import json
import re
import sys

line = re.compile(r"(\d+) samples of .* (\d+) words differ")
found = [line.search(open(log).read()) for log in glob.glob("build/campaign/*.log")]
samples = sum(int(m[1]) for m in found if m)
differ = sum(int(m[2]) for m in found if m)
equality = {"configurations": len(found), "samples": samples, "differ": differ}
json.dump(equality, open("build/figures/equality.json", "w"))
print(f"{samples} samples in {len(found)} configurations, {differ} words differ")
sys.exit(not all(found) or differ > 0)
PYTHON
scripts/results.py accuracy splines equality
export CURVECORE_MUTATIONS=100000
for label in model unit cli; do scripts/test.sh --preset asan -L "$label"; done
scripts/coverage.sh
scripts/pages.sh
