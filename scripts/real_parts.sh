#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs long parts that no one here wrote through the RTL: sample programs of Debian's
# linuxcnc-uspace package (GPL), fetched into build/real_parts and never committed.
#
#   scripts/real_parts.sh [CURVECORE [OPTION ...]]   options of run; exit status 77: the package
#                                                    cannot be fetched here
set -euo pipefail
case ${1:-} in
  -h | --help)
    sed -n '3,7s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
esac
cd "$(dirname "$0")/.."
curvecore=$(realpath "${1:-build/curvecore}")
options=("${@:2}")
folder=$PWD/build/real_parts
examples=usr/share/doc/linuxcnc/examples/sample-configs/sim/gmoccapy
examples+=/non_trivial_kinematics/table-rotary-tilting/examples
parts=(
  usr/share/linuxcnc/ncfiles/arcspiral.ngc
  "$examples/impeller-7bl-xyzac.ngc"
  systems.ngc
)

mkdir -p "$folder"
if ! [ -e "$folder/usr" ]; then
  (cd "$folder" && apt-get download -qq linuxcnc-uspace 2>/dev/null) || exit 77
  dpkg-deb --extract "$folder"/linuxcnc-uspace_*.deb "$folder"
  rm "$folder"/linuxcnc-uspace_*.deb
fi

# A text in splines (G5.1), whose numbers are expressions: those are worked out first.
python3 - "$folder/usr/share/linuxcnc/ncfiles/systems.ngc" >"$folder/systems.ngc" <<'PYTHON'
import re
import sys

values = {}


def number(text):
    text = re.sub(r"#(\d+)", lambda name: repr(values[int(name[1])]), text)
    return eval(text.replace("[", "(").replace("]", ")"), {"__builtins__": {}})


for line in open(sys.argv[1], errors="replace"):
    line = re.sub(r"\([^)]*\)|;.*", "", line).strip()
    assignment = re.match(r"#(\d+)\s*=\s*(.*)", line)
    if assignment:
        values[int(assignment[1])] = number(assignment[2])
        line = ""
    print(re.sub(r"\[[^\]]*\]|#\d+", lambda word: f"{number(word[0]):.6f}", line))
PYTHON

for part in "${parts[@]}"; do
  out=$folder/$(basename "$part" .ngc)
  rm -rf "$out"
  echo "== $part"
  "$curvecore" run "$folder/$part" -o "$out" -q "${options[@]}"
  python3 - "$out/report.json" <<'PYTHON'
import json
import sys

report = json.load(open(sys.argv[1]))
print(f"{report['moves']} moves, {report['segments']} segments, {report['samples']} samples, "
      f"worst error {max(report['error']['max_lsb'].values()):.3f} units, "
      f"words that differ {report['rtl_equals_kernel']}, landing {report['landing_lsb']}")
PYTHON
done
