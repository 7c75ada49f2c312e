#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# makes_core.sh BUILD PART : installs the program and the cores' sources, and runs PART on a core
# that is not built in: made from what was installed, kept in the user's cache, and made anew when
# a source has changed.
set -eu
build=$1
part=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for component in program rtl; do
  cmake --install "$build" --prefix "$folder" --component $component >/dev/null
done
unset CURVECORE_CORES
export XDG_CACHE_HOME="$folder/cache"
run() {
  "$folder/bin/curvecore" run "$part" -o "$folder/out" --build engine --set Order=3 \
    --set CoefBits=24 --set GuardBits=6 --unit 1um | grep -o 'every check held$'
  echo "kept: $(ls -d "$XDG_CACHE_HOME"/curvecore/engine-*/core.so | wc -l)"
}
run
run
echo '// changed' >>"$folder/share/curvecore/rtl/motion_interpolator.sv"
run
