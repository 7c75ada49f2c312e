#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# licence_breaches.sh ROOT : licences.sh finds each way in which the two sides could come to share
# source.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0
# breach FILE LINE : a tree with this line in this file is refused.
breach() {
  rm -rf "$folder"/*
  mkdir "$folder/ref" "$folder/hls" "$folder/rtl" "$folder/sysc" "$folder/tb" "$folder/scripts"
  cp -r "$root/sysc/linuxcnc" "$folder/sysc"
  cp -r "$root/hls/registers" "$folder/hls"
  "$root/tb/lint/licences.sh" "$folder" >"$folder/out" || {
    echo "a tree without breach is refused: $(cat "$folder/out")"
    status=1
  }
  echo "$2" >>"$folder/$1"
  "$root/tb/lint/licences.sh" "$folder" >"$folder/out" && {
    echo "not found: $1: $2"
    status=1
  }
}
root=$(realpath "$1")
breach ref/a.cpp '#include "sysc/linuxcnc/canon_recorder.cpp"'
breach sysc/a.hpp '#include <canon.hh>'
breach scripts/a.py 'import gcode'
breach tb/a.py 'from interpret import Ini'
breach sysc/CMakeLists.txt 'add_library(recorder MODULE linuxcnc/canon_recorder.cpp)'
breach sysc/CMakeLists.txt 'target_link_libraries(curvecore_host PRIVATE rs274)'
breach sysc/linuxcnc/canon_recorder.cpp '#include "ref/moves/move.hpp"'
breach sysc/linuxcnc/udp_link.h '#include "hls/words.hpp"'
breach sysc/linuxcnc/curvecore.comp 'include "../../hls/words.hpp";'
breach sysc/linuxcnc/other.h 'int x;'
breach hls/registers/board_link.h '#include "hls/words.hpp"'
breach hls/registers/other.h 'int x;'
breach sysc/linuxcnc/other.py 'print()'
exit $status
