#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# prove.sh prove|cover|control WRAPPER NAME SOURCE... : an unbounded proof with Yosys and ABC.
#   prove    every assertion of WRAPPER holds in every reachable state, from any start before reset;
#            in the configuration NAME, `// configuration: NAME Parameter=Value ...`, unless it is -
#   cover    every cover statement of WRAPPER is reached
#   control  with the defect NAME built in, the proof fails: a test of the proof itself.  WRAPPER
#            declares it in a line `// control: NAME` (NAME is defined for the preprocessor), or
#            `// control: NAME s/old/new/` (a change of the module under proof), or
#            `// control: NAME MODULE s/old/new/` (of another one).
# What lines `// cut: SELECTION ...` select, as Yosys does, may have any value.
# WRAPPER is tb/formal/<room>/<module>_formal.sv and assumes the reset in its first cycle.
# With lines `// forget: REGISTER ... unless GUARD`, rules of tb/formal/search, that program
# (STATE_SEARCH) goes through all reachable states, in place of ABC.
set -euo pipefail
mode=$1 wrapper=$2 name=$3
shift 3
top=$(basename "$wrapper" .sv)
module=${top%_formal}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

sources=()
changed=$module
change=$(sed -n "s|^// control: $name ||p" "$wrapper")
if [[ "$change" =~ ^([a-z0-9_]{2,})\ (.*) ]]; then
  changed=${BASH_REMATCH[1]}
  change=${BASH_REMATCH[2]}
fi
for source in "$@"; do
  if [ "$mode" = control ] && [ -n "$change" ] && [ "$(basename "$source")" = "$changed.sv" ]; then
    sed "$change" "$source" >"$work/$changed.sv"
    if cmp -s "$source" "$work/$changed.sv"; then
      echo "control $name changes nothing in $source"
      exit 1
    fi
    source=$work/$changed.sv
  fi
  sources+=("$source")
done
here=$(dirname "$0")
mapfile -t sources < <("$here/../support/needed_sources.sh" "$wrapper" "${sources[@]}" \
  "$here"/environment/*.sv)

# Covers become assertions that they never happen; in the other modes they are dropped.
case $mode in
  cover) select="chformal -assert -remove; techmap -map $here/cover_to_assert.v" ;;
  *) select="chformal -cover -remove" ;;
esac
define=$([ "$mode" = control ] && echo "-D$name" || true)
parameters=$(sed -n "s/^\/\/ configuration: $name //p" "$wrapper" |
  sed -E 's/([A-Za-z]+)=([0-9]+)/-chparam \1 \2/g')
cuts=$(sed -n 's|^// cut: ||p' "$wrapper" | tr ' ' '\n' |
  sed 's|.*|cutpoint &;|' | tr '\n' ' ')
forget=()
while IFS= read -r rule; do
  forget+=(--forget "$rule")
done < <(sed -n 's|^// forget: ||p' "$wrapper")
if [ ${#forget[@]} -gt 0 ]; then
  # Three values: what is unknown stays so, in plain gates; registers keep their names.
  unknown=-anyconst
  gates="setundef $unknown; aigmap; opt_clean; write_aiger -I -B -symbols $work/model.aig"
else
  unknown=-anyseq
  gates="abc -g AND -fast; opt_clean; write_aiger -I -B -zinit $work/model.aig"
fi

yosys -q -w "Replacing memory" -p "
  read_verilog -sv -formal -DFORMAL $define -defer ${sources[*]}
  read_verilog -sv -formal -DFORMAL $define $wrapper
  hierarchy -top $top $parameters; proc; $cuts prep -top $top -flatten
  setattr -mod -unset keep_hierarchy; flatten; opt_clean
  memory_map -formal; async2sync
  chformal -early; $select; tee -o $work/count select -count t:\$assert
  setundef -undriven $unknown; setattr -unset keep; delete -output
  opt -full; techmap; opt -fast; dffunmap; $gates"
count=$(grep -oE '^[0-9]+' "$work/count" | tail -n 1)
if [ "$count" = 0 ]; then
  echo "$top: nothing to $mode"
  exit 1
fi

if [ ${#forget[@]} -gt 0 ]; then
  "$STATE_SEARCH" "$mode" "$work/model.aig" "${forget[@]}"
elif [ "$mode" = cover ]; then
  (ulimit -t 120; yosys-abc -c "read_aiger $work/model.aig; fold; strash; bmc3 -a -F 200") \
    >"$work/log" || true
  reached=$(grep -c 'was asserted in frame' "$work/log" || true)
  echo "$top: $reached of $count covers reached"
  [ "$reached" = "$count" ]
else
  (ulimit -t 300; yosys-abc -c "read_aiger $work/model.aig; fold; strash; scorr; pdr") \
    >"$work/log" || true
  tail -n 3 "$work/log"
  case $mode in
    prove) grep -q '^Property proved' "$work/log" && echo "$top: $count assertions proved" ;;
    control) grep -q 'was asserted in frame' "$work/log" && echo "$top: $name is caught" ;;
  esac
fi
