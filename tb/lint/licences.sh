#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# licences.sh ROOT : what runs inside LinuxCNC stands in sysc/linuxcnc under LinuxCNC's licence, and
# shares no source with the rest, which talks to it through pipes and sockets. Both read the headers
# of registers, which have both licences.
set -u
cd "$1" || exit 1
inside=sysc/linuxcnc
status=0
complain() {
  echo "$*"
  status=1
}
head -n 2 $inside/COPYING | grep -q 'GNU GENERAL PUBLIC LICENSE' || complain "$inside: no licence"
for header in hls/registers/*.h; do
  head -n 1 "$header" | grep -q 'Apache-2.0 OR GPL-2.0-or-later' ||
    complain "$header: not under both"
done
grep -nE '#include' hls/registers/*.h |
  grep -vE '#include (<stdint.h>|"(registers|board_[a-z]+).h")' && complain "a header uses the rest"
for file in $inside/*.py $inside/*.cpp $inside/*.[ch] $inside/*.comp; do
  head -n 2 "$file" | grep -q 'SPDX-License-Identifier: GPL-2.0-or-later' ||
    complain "$file: not under LinuxCNC's licence"
done
# The LinuxCNC side includes nothing of the rest
grep -nE '^ *#?include *"|import .*curvecore|from (ref|hls|sysc|tb|scripts)' \
  $inside/*.py $inside/*.cpp $inside/*.[ch] $inside/*.comp |
  grep -vE '#include "../../hls/registers/(registers|board_link).h"' |
  grep -vE 'include "(udp_link|canon_lines|sample_line).h"' &&
  complain "$inside uses the rest"
# The rest includes nothing of the LinuxCNC side
grep -rnE --include='*.[ch]pp' --exclude-dir=linuxcnc \
  '#include.*(sysc/linuxcnc/|<(linuxcnc|canon\.hh|emc|rs274|interp_))' \
  ref hls rtl sysc tb scripts && complain "the rest includes it"
grep -rnE --include='*.py' '^ *(import|from) +(linuxcnc|gcode|rs274|interpret|callbacks)\b' \
  hls tb scripts && complain "the rest imports it"
grep -rnE --include=CMakeLists.txt --include='*.cmake' \
  '(add_|target_sources|target_link_libraries).*(linuxcnc|canon_recorder|rs274)' \
  ref hls rtl sysc && complain "the rest builds or links it"
exit $status
