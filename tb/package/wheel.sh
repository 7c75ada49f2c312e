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
# pytest finds the plugin.
venv/bin/python -c "
from importlib.metadata import entry_points
plugin, = [one for one in entry_points(group='pytest11') if one.name == 'curvecore']
assert plugin.value == 'curvecore.pytest_plugin', plugin"
venv/bin/curvecore run "$root/tb/data/lines.ngc" -q -o run
tar -tzf "$root"/build/wheel/curvecore-*.tar.gz | grep "/hls/words.hpp$" >/dev/null
