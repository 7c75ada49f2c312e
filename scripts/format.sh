#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Formats every C++ and SystemVerilog file in place, as the lint tests want them.
set -euo pipefail
case ${1:-} in
  "") ;;
  -h | --help)
    sed -n '3s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
  *)
    echo "format: takes no arguments" >&2
    exit 2
    ;;
esac
cd "$(dirname "$0")/.."
PATH=$PWD/.venv/bin:$PATH
find ref hls rtl sysc tb \( -name '*.hpp' -o -name '*.cpp' \) -print0 | xargs -0 -r clang-format -i
find rtl tb -name '*.sv' -print0 | xargs -0 -r -n 1 verible-verilog-format --inplace
