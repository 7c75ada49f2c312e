#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the Python package: a wheel with the program, the kernel and the RTL's sources, for any
# Linux whose C library is as new as this one's, and its sources.
#
#   scripts/wheel.sh     build/wheel/curvecore-VERSION-*.whl, build/wheel/curvecore-VERSION.tar.gz
set -euo pipefail
case ${1:-} in
  "") ;;
  -h | --help)
    sed -n '3,6s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
  *)
    echo "wheel: '$1' is not known: it takes no option" >&2
    exit 2
    ;;
esac
cd "$(dirname "$0")/.."
scripts/setup.sh
PATH=$PWD/.venv/bin:$PATH
to=$PWD/build/wheel
tree=$to/tree
rm -rf "$tree"
mkdir -p "$tree" "$to/made"
# With their times, so that what was built is not built again.
cp -rp rtl hls ref sysc scripts CMakeLists.txt LICENSE README.md sysc/python/pyproject.toml "$tree"
rm -f "$to"/*.whl "$to"/*.tar.gz "$to"/made/*
cd "$tree"
echo "wheel: compiling, some minutes at first"
python3 -c "
from scikit_build_core.build import build_sdist, build_wheel
build_sdist('$to')
build_wheel('$to/made', {'build-dir': '$to/build', 'cmake.define.CMAKE_CXX_COMPILER': 'clang++-14'})
" >"$to/wheel.log" 2>&1 || {
  tail -20 "$to/wheel.log" >&2
  echo "wheel: it cannot be built; all of it: $to/wheel.log" >&2
  exit 1
}
auditwheel repair --plat auto -w "$to" "$to"/made/*.whl >>"$to/wheel.log" 2>&1 || {
  tail -20 "$to/wheel.log" >&2
  exit 1
}
ls -s "$to"/*.whl "$to"/*.tar.gz
