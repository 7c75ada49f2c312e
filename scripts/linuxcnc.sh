#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Programs on LinuxCNC's own motion in simulation and by curvecore's plans: a table, and
# build/figures/linuxcnc.json. A quarter of an hour: LinuxCNC runs in real time.
#
#   scripts/linuxcnc.sh [--install]    --install: LinuxCNC's packages too, by apt
set -euo pipefail
case ${1:-} in
  "" | --install) ;;
  -h | --help)
    sed -n '3,6s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
  *)
    echo "linuxcnc: takes --install only" >&2
    exit 2
    ;;
esac
cd "$(dirname "$0")/.."
packages=(linuxcnc-uspace linuxcnc-uspace-dev)
if [ "${1:-}" = --install ]; then
  root=()
  [ "$(id -u)" = 0 ] || root=(sudo)
  "${root[@]}" apt-get install -y --no-install-recommends "${packages[@]}"
elif ! [ -x /usr/bin/linuxcnc ]; then
  echo "linuxcnc: not installed; scripts/linuxcnc.sh --install installs ${packages[*]}" >&2
  exit 2
fi
scripts/setup.sh
PATH=$PWD/.venv/bin:$PATH
cmake --preset release >/dev/null
cmake --build --preset release -j "$(nproc)" --target curvecore
mkdir -p build/figures
python3 tb/linuxcnc/motion_over_linuxcnc.py --program build/curvecore -o build/figures/linuxcnc.json
scripts/results.py linuxcnc
