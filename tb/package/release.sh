#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# release.sh ROOT: a release of this tree as it is, without what takes hours: in a clone with a
# version of its own, by the tools of ROOT.
set -euo pipefail
root=$1
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cd "$root"
git ls-files -z --cached --others --exclude-standard |
  tar --null --ignore-failed-read -cf - -T - | tar -xf - -C "$tree"
cd "$tree"
ln -s "$root/.venv" .
git init --quiet
scripts/version.py 99.0.0
commit() { git -c user.name=a -c user.email=a@b commit --quiet --all --message "$1"; }
git add --all
commit "release: 99.0.0"
scripts/release.sh --without bitstreams,site
cd build/release_files/v99.0.0
sha256sum --check --quiet SHA256SUMS
ls wheel/curvecore-99.0.0-*.whl wheel/curvecore-99.0.0.tar.gz
iverilog -g2005 -tnull verilog/curve_interpolator/curve_interpolator.v
grep -l "package motion_board_component is" verilog/motion_board/motion_board.vhd
python3 -m venv "$tree/venv"
"$tree/venv/bin/pip" install --quiet wheel/*.whl
[ "$("$tree/venv/bin/curvecore" --version)" = "curvecore 99.0.0" ]
