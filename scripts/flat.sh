#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A core as one file of Verilog-2005, without a hierarchy, for tools that read nothing else.
#
#   scripts/flat.sh TOP [Name=Value ...] [-o FILE.v] [--vhdl]     else build/flat/TOP.v
#
# --vhdl: its component for VHDL besides, FILE.vhd, in the package TOP_component.
# TOP is a module of rtl/, Name a parameter of it: whole numbers. With MultiplierForm 1 or 2 the
# multipliers are the device's own cells, which its tools know. With Build=2, said or by default,
# the engine's programs are in the file.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
usage() { sed -n '3,10s/^# \{0,1\}//p' "$0"; }
refuse() {
  echo "flat: $*" >&2
  exit 2
}
top=
file=
vhdl=
parameters=()
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help)
      usage
      exit 0
      ;;
    -o)
      file=${2:-}
      [ -n "$file" ] || refuse "-o needs a file"
      shift
      ;;
    --vhdl) vhdl=1 ;;
    -*) refuse "unknown option '$1'" ;;
    *=*)
      [[ $1 =~ ^[A-Za-z0-9]+=[0-9]+$ ]] || refuse "'$1' must be Name=Value, a whole number"
      parameters+=("$1")
      ;;
    *)
      [ -z "$top" ] || refuse "one module at a time: $top or $1"
      top=$1
      ;;
  esac
  shift
done
[ -n "$top" ] || {
  usage >&2
  exit 2
}
source=$(grep "^\(.*/\)\?$top\.sv$" "$root/rtl/curvecore.f") || refuse "rtl/ has no module '$top'"
for parameter in "${parameters[@]}"; do
  grep -q "^ *parameter int ${parameter%=*} " "$root/rtl/$source" ||
    refuse "$top has no parameter ${parameter%=*}"
done
command -v yosys >/dev/null || "$root/scripts/setup.sh" >&2

[ -n "$file" ] || {
  file=$root/build/flat/$top.v
  echo "$(realpath --relative-to=. "$file")"
}
file=$(realpath -m "$file")
mkdir -p "$(dirname "$file")"
made=$(mktemp "$file.XXXXXX")
trap 'rm -rf "$made" "$made".*' EXIT
cd "$root/rtl"
set=${parameters:+$(printf ' -set %s' "${parameters[@]/=/ }")}
build=$(sed -nE 's/^ *parameter int Build +=  *([0-9]+),.*/Build=\1/p' "$source")
[[ " ${parameters[*]}" = *" Build="* ]] && build=
if [[ " ${parameters[*]} $build " = *" Build=2 "* ]]; then
  mkdir "$made.engine"
  "$root/scripts/microcode.sh" "$made.engine" "$top" "${parameters[@]}" || exit 1
  set+=" -set Program \"$made.engine/program.hex\" -set Data \"$made.engine/data.hex\""
fi
yosys -q -w "Replacing memory" -p "
  read_verilog -sv -defer $(grep '\.sv$' curvecore.f | tr '\n' ' ')
  read_verilog -lib +/ecp5/cells_bb.v +/ice40/cells_sim.v
  ${set:+chparam$set $top;} hierarchy -check -top $top
  proc; flatten; opt_expr; opt_clean; write_verilog $made" >&2 || {
  echo "flat: $top cannot be made${parameters:+ with ${parameters[*]}}" >&2
  exit 1
}
# Of the attributes those stay that say something to other tools. Copies of registers that synthesis
# must not merge stay modules: their names become plain, and the core's own.
said='keep_hierarchy|async_reg|ram_style|no_rw_check|fsm_encoding|parallel_case'
{
  echo "// SPDX-License-Identifier: Apache-2.0"
  echo "// $top of curvecore${parameters:+, ${parameters[*]}}: made by scripts/flat.sh from rtl/."
  sed -E -e 1d -e "/^ *\(\* ($said) /b" -e '/^ *\(\*.*\*\)$/d' -e 's/\(\* \w+ = [^*]* \*\) //g' \
    -e "s/\\\\\\\$paramod\\\\(\w+)\\\\Bits=s32'0*([01]+) /${top}_\1_\2 /" "$made"
} >"$made.v"
if [ -n "$vhdl" ]; then
  component=${file%.v}.vhd
  yosys -q -p "read_verilog -lib $made; write_json $made.json"
  "$root/scripts/vhdl_component.py" "$top" <"$made.json" >"$made.vhd"
  mv "$made.vhd" "$component"
fi
mv "$made.v" "$file"
