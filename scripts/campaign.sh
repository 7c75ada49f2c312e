#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The long form of what the tests do in short, in parts. A part that ended well on this tree is not
# run again, nor a test that ctest runs for a part and that passed on this commit, so a campaign
# that was stopped goes on. Four hours or so; build/campaign has each part's log and, once it held,
# its results.
#
#   scripts/campaign.sh [--samples N] [PART ...]    all parts, or these; N: 1000000000 when left out
#   scripts/campaign.sh --list                      says which parts there are, and which are done
#
#   tidy         clang-tidy of every file
#   units        unit tests of every configuration, with all their random cases
#   long         tests of label long
#   overrides    every program at overrides of 1..200 %, at some in the system and on the engine
#   models       tests of models with all their random cases, 10^4 cubics at slow clocks
#   equality     N samples of the RTL against the kernel, in every configuration
#   microcode    N words of the engine's twin, and 10^5 samples of its RTL, in every configuration
#   steps        10^8 steps under the monitors of the pins
#   program      the demo part from words to pins: core, system
#   buses        20,000 accesses on every bus, 2,000 on lines, 40,000 datagrams
#   curves       errors of arcs and splines
#   ranges       ranges of words, drift over 10^7 segments
#   limits       pairs of machines that differ in one limit
#   asanmodels   tests of models with the sanitizers, 10^5 mutations
#   asanunits    unit tests with the sanitizers
#   asancommands tests of commands with the sanitizers, 10^5 mutations
#   coverage     lines and branches that tests run
#   pages        figures of the pages that are the same on every machine
set -euo pipefail
cd "$(dirname "$0")/.."
mapfile -t known < <(sed -nE 's/^#   ([a-z]+) +[a-z0-9N].*/\1/p' "$0")
samples=1000000000
parts=()
list=false
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help)
      sed -n '3,29s/^# \{0,1\}//p' "$0"
      exit 0
      ;;
    --list) list=true ;;
    --samples)
      case ${2:-} in
        "" | *[!0-9]* | 0*)
          echo "campaign: --samples '${2:-}' is no number: digits only, such as 1000000" >&2
          exit 2
          ;;
      esac
      samples=$2
      shift
      ;;
    *)
      if [[ " ${known[*]} " != *" $1 "* ]]; then
        echo "campaign: '$1' is no part: one of ${known[*]}" >&2
        exit 2
      fi
      parts+=("$1")
      ;;
  esac
  shift
done

# The last commit of what is tried; changes that are in no commit are nobody's tree.
tried=(ref hls rtl sysc tb ":(exclude)*.md")
tree=$(git log -1 --format=%h -- "${tried[@]}")
[ -z "$(git status --porcelain -- "${tried[@]}")" ] || tree=$tree-changed
out=build/campaign
mkdir -p $out build/figures
asked() { [[ $1 != equality && $1 != microcode ]] || echo "$samples samples"; }
is_done() {
  [[ $tree != *-changed ]] &&
    grep -qs "\"tree\": \"$tree\", \"asked\": \"$(asked "$1")\"" "$out/$1.json"
}
if $list; then
  for part in "${known[@]}"; do
    echo "$part$(is_done "$part" && echo ": done on $tree")"
  done
  exit 0
fi
scripts/setup.sh
PATH=$PWD/.venv/bin:$PATH
tb=build/release/tb

configure() { cmake --preset release -DCURVECORE_FULL_CAMPAIGN=ON; }

build() {
  configure
  cmake --build --preset release -j "$(nproc)" --target "$@"
}

# Targets whose whole name an extended regular expression matches.
targets() { cmake --build --preset release --target help | sed -nE "s/^($1): phony/\1/p"; }

# What a part pipes into `result` is its outcome; a part that found nothing to say has failed.
result() { grep . >>"$out/$part.results"; }

# Runs tests, as a preset and ctest's options say which. Those that have passed on this commit in a
# run before this one are not run again.
run_tests() {
  local preset=$1 log=$out/$part-$(git log -1 --format=%h).run asked rest
  shift
  [[ $tree != *-changed ]] || rm -f "$log"
  touch "$log"
  asked=$(ctest --preset "$preset" -N "$@" | sed -nE 's/^ *Test +#[0-9]+: +//p')
  left() {  # ctest's -I counts among the tests that its other options choose
    awk 'FILENAME == ARGV[1] {
        if (/^ *[0-9]+\/[0-9]+ +Test .*( Passed |\*\*\*Skipped )/) done[$4]
        next
      }
      !($1 in done) {printf ",%d", FNR}' "$log" <(echo "$asked")
  }
  rest=$(left)
  [ -z "$rest" ] || ctest --preset "$preset" --timeout 20000 "$@" -I "0,0,0$rest" 2>&1 |
    tee -a "$log"
  rest=$(left)
  [ -z "$rest" ]
  echo "$(wc -l <<<"$asked") tests, none failed" | result
}

tidy() {
  build label_lint
  CURVECORE_TIDY=all run_tests release -R "^lint\\..*\\.tidy$"
}

units() {
  build label_unit
  CURVECORE_LONG=1 run_tests release -L "^unit$" -LE "^long$"
}

long() {
  build all label_long
  CURVECORE_LONG=1 run_tests release -L "^long$" -E LongOverride
}

overrides() {
  build curvecore cli_tests
  run_tests release -R LongOverride
}

models() {
  build label_model
  CURVECORE_LONG=1 CURVECORE_CUBICS=10000 run_tests release -L "^model$"
}

equality() {
  # Every configuration of every core but those of DSP primitives, whose models are slow. The more
  # clocks a sample takes, the fewer samples. What a run before this one has done on this tree is
  # not done again.
  configure
  mapfile -t benches < <(targets "(spherical|spline|curve)_interpolator_[a-z0-9_]+" |
    grep -vE "_ecp5|_up5k")
  build "${benches[@]}"
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
  export logs=$out/equality-$tree-$samples
  [[ $tree != *-changed ]] || rm -rf "$logs"
  mkdir -p "$logs"
  for bench in "${benches[@]}"; do
    echo "$bench" $(((samples * $(share "$bench") + shares - 1) / shares))
  done | xargs -P "$(nproc)" -L 1 sh -c \
    'log=$logs/$0.log
     grep -qs "words differ" "$log" && exit
     CURVECORE_SAMPLES=$1 build/release/tb/$0 --gtest_filter=*.EqualsKernelOverManySamples \
       >"$log" 2>&1 || {
       mv "$log" "$log.failed"
       echo "FAILED: $log.failed"
       exit 1
     }
     grep -H "words differ" "$log"'
  sum=$(
    python3 - <<'PYTHON'
import glob
import json
import os
import re
import sys

line = re.compile(r"(\d+) samples of .* (\d+) words differ")
found = [line.search(open(log).read()) for log in glob.glob(os.environ["logs"] + "/*.log")]
samples = sum(int(m[1]) for m in found if m)
differ = sum(int(m[2]) for m in found if m)
equality = {"configurations": len(found), "samples": samples, "differ": differ}
json.dump(equality, open("build/figures/equality.json", "w"))
print(f"{samples:,} samples in {len(found)} configurations, {differ} words differ")
sys.exit(not all(found) or differ > 0)
PYTHON
  )
  echo "$sum" | result
}

microcode() {
  # Configurations that a run before this one has done on this tree are not done again.
  configure
  mapfile -t benches < <(targets "motion_interpolator_b2_[a-z0-9_]+")
  build microcode_campaign "${benches[@]}"
  lines=$out/microcode-$tree
  [[ $tree != *-changed ]] || rm -f "$lines".*
  seq "$(nproc)" | CURVECORE_LONG=1 xargs -P "$(nproc)" -I N $tb/campaign/microcode_campaign \
    --words "$samples" --part N --parts "$(nproc)" -o "$lines.N" | tee $out/microcode.run
  awk '{words += $1; n += $4; differ += $6}
    END {print words " words of the twin in " n " configurations, " differ " differ"}' \
    $out/microcode.run | result
  for bench in "${benches[@]}"; do
    CURVECORE_SAMPLES=100000 $tb/$bench --gtest_filter=*.EqualsKernelsOverManySamples |
      tee $out/microcode.run
    grep "words differ" $out/microcode.run | sed "s/^/$bench: /" | result
  done
}

steps() {
  configure
  mapfile -t benches < <(targets "step_pins_[a-z0-9_]+")
  build "${benches[@]}"
  rm -f $out/steps.run
  for bench in "${benches[@]}"; do
    CURVECORE_STEPS=20000000 $tb/$bench | tee -a $out/steps.run
  done
  awk '/ steps, .* turns,/ {steps += $1; ++number}
    END {if (number) print steps " steps of " number " generators, every one in the first clock " \
      "allowed"}' $out/steps.run | result
}

program() {
  build motion_steps_parallel motion_system_parallel
  CURVECORE_PART=demo.ngc $tb/motion_steps_parallel | tee $out/program.run
  grep "steps$" $out/program.run | sed "s/$/ from words to pins/" | result
  # The engine's bench has a queue that does not cover this part's stops.
  CURVECORE_PART=demo.ngc $tb/motion_system_parallel --gtest_filter="*.Draws*" |
    tee $out/program.run
  grep "clocks$" $out/program.run | sort -u | sed "s/$/ on the system/" | result
}

buses() {
  scripts/buses.sh
  echo "every access as described" | result
}

curves() {
  build accuracy_campaign splines_campaign
  $tb/campaign/accuracy_campaign --curves 5000 -o build/figures/accuracy.json
  $tb/campaign/splines_campaign --curves 2000 -o build/figures/splines.json
  echo "5000 moves of each family of arcs, 2000 of each of splines: errors within their bounds" |
    result
}

ranges() {
  build ranges_campaign drift_campaign
  $tb/campaign/ranges_campaign --cubics 1000 -o build/figures/ranges.json | tee $out/ranges.run
  $tb/campaign/drift_campaign --segments 10000000 -o build/figures/drift.json |
    tee -a $out/ranges.run
  grep -E "^[0-9]+ cubics" $out/ranges.run | result
  grep -E "^(arcs|splines):" $out/ranges.run | sed "s/^/drift of /" | result
}

limits() {
  build limits_campaign
  $tb/campaign/limits_campaign --pairs 500 -o build/figures/limits.json | tee $out/limits.run
  tail -1 $out/limits.run | result
}

# Runs the tests of a label with the sanitizers.
sanitized() {
  cmake --preset asan
  cmake --build --preset asan -j "$(nproc)" --target "label_$1"
  CURVECORE_MUTATIONS=100000 run_tests asan -L "^$1$" -LE "^long$"
}
asanmodels() { sanitized model; }
asanunits() { sanitized unit; }
asancommands() { sanitized cli; }

coverage() {
  scripts/coverage.sh | tee $out/coverage.run
  sed -n 's/^all folders: //p' $out/coverage.run | result
}

pages() {
  scripts/pages.sh
  echo "every page is what this tree gives" | result
}

TIMEFORMAT="%U %S"  # seconds of CPU
failed=()
for part in "${parts[@]:-${known[@]}}"; do
  if is_done "$part"; then
    echo "$part: done on $tree"
    continue
  fi
  echo "$part: begun at $(date +%H:%M), its log is $out/$part.log"
  rm -f "$out/$part.json" "$out/$part.results"
  "$part" >"$out/$part.log" 2>&1 &  # a shell of its own, which ends at the first error
  if { time wait $!; } 2>"$out/$part.cpu"; then
    python3 -c 'import json, pathlib, sys
stamp, tree, asked = sys.argv[1:]
file = pathlib.Path(stamp)
text = file.with_suffix(".results").read_text().strip().split("\n")
cpu = sum(map(float, file.with_suffix(".cpu").read_text().split()))
file.write_text(json.dumps({"tree": tree, "asked": asked, "cpu_seconds": cpu, "results": text}))
print(*text, sep="\n")' "$out/$part.json" "$tree" "$(asked "$part")"
  else
    failed+=("$part")
    echo "$part: failed:"
    tail -5 "$out/$part.log"
  fi
done
scripts/results.py accuracy splines equality campaign
[ ${#failed[@]} = 0 ] || {
  echo "campaign: failed: ${failed[*]}" >&2
  exit 1
}
