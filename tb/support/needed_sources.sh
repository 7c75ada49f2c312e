#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# needed_sources.sh FILE SOURCE... : those of SOURCE... that FILE names, itself or through others of
# them, in their order. A source is called as what it declares. Reading all of rtl takes Yosys
# longer than most of its proofs.
set -eu
awk '
  FNR == 1 {
    unit = FILENAME
    gsub(/.*\/|\.sv$/, "", unit)
    file[unit] = FILENAME
    units[++count] = unit
  }
  {
    sub(/\/\/.*/, "")
    words = split($0, word, /[^A-Za-z0-9_]+/)
    for (i = 1; i <= words; ++i) names[unit, word[i]]
  }
  function need(unit,  i) {
    needed[unit]
    for (i = 2; i <= count; ++i)
      if (!(units[i] in needed) && (unit, units[i]) in names) need(units[i])
  }
  END {
    need(units[1])
    for (i = 2; i <= count; ++i) if (units[i] in needed) print file[units[i]]
  }' "$@"
