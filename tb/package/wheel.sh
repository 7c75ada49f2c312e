#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# wheel.sh ROOT CURVECORE: makes the wheel, installs it where nothing else is, and tries it there.
set -euo pipefail
root=$1 program=$2
"$root/scripts/wheel.sh"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet "$root"/build/wheel/curvecore-*.whl
cd "$folder"
venv/bin/python "$root/tb/package/python_test.py" "$program" "$root/tb/data"
venv/bin/curvecore --version
venv/bin/curvecore run "$root/tb/data/lines.ngc" -q -o run
tar -tzf "$root"/build/wheel/curvecore-*.tar.gz | grep "/hls/words.hpp$" >/dev/null
