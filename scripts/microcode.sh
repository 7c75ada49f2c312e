#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The engine's programs for a module of rtl/ with Build=2: program.hex and data.hex for $readmemh.
#
#   scripts/microcode.sh FOLDER TOP [Name=Value ...]
#
# motion.lst there is their listing. What makes them is compiled when it is first asked for, in two
# minutes; MICROCODE_GENERATOR in the environment names one that is there.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
[ $# -ge 2 ] || {
  sed -n '3,8s/^# \{0,1\}//p' "$0" >&2
  exit 2
}
folder=$1
shift
generator=${MICROCODE_GENERATOR:-$root/build/release/rtl/microcode_generator}
[ -n "${MICROCODE_GENERATOR:-}" ] || (
  log=$(realpath "$folder")/microcode.log
  cd "$root"
  {
    [ -e build/release/build.ninja ] || cmake --preset release
    cmake --build --preset release --target microcode_generator
  } >"$log" 2>&1 || {
    echo "microcode: what makes it cannot be compiled: see $log" >&2
    exit 1
  }
  rm "$log"
)
"$generator" "$root" "$folder" "$@"
