#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# formula.sh CURVECORE PYTHON HLS_PY OUTPUT: a formula becomes a table, a kernel, a pipeline.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$1" curve derive "$folder/wave.net" --x '20*t' --y '8*sin(w*t)' --let w=2 --t=-2,2.5
"$2" "$3" --core "$folder/wave.net" --set Order=3 --set CoefBits=24 --samples 20000 --output "$4"
