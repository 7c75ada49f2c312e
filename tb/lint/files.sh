#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# files.sh ROOT : every source file names its licence, is ASCII, has at most 100 columns and 400
# lines, and no table in a comment whose rows run together. What runs inside
# LinuxCNC has LinuxCNC's licence: licences.sh.
set -u
cd "$1" || exit 1
status=0
complain() {
  echo "$*"
  status=1
}
for file in $(find CMakeLists.txt ref hls rtl sysc tb scripts -type f \
    \( -name '*.[ch]pp' -o -name '*.sv' -o -name '*.sh' -o -name '*.py' -o -name '*.cmake' \
    -o -name CMakeLists.txt -o -name '*.c' -o -path 'sysc/linuxcnc/*.h' -o -name 'board_*.h' \
    -o -name '*.comp' \)); do
  licence=Apache-2.0
  case $file in sysc/linuxcnc/*) licence=GPL-2.0-or-later ;; esac
  head -n 2 "$file" | grep -q "SPDX-License-Identifier: $licence" ||
    complain "$file: no SPDX line"
  LC_ALL=C grep -nP '[^\x00-\x7F]' "$file" && complain "$file: not ASCII"
  grep -nE '^.{101}' "$file" && complain "$file: more than 100 columns"
  grep -nE '^ *//+ +(\| \| |\|.*[a-z] \| \| [a-z])' "$file" &&
    complain "$file: rows of a table in a comment run together"
  [ "$(wc -l <"$file")" -le 400 ] || complain "$file: more than 400 lines"
done
exit $status
