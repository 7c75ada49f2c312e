#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Formats every C++ and SystemVerilog file in place, as the lint tests want them.
set -euo pipefail
cd "$(dirname "$0")/.."
PATH=$PWD/.venv/bin:$PATH
find ref hls tb \( -name '*.hpp' -o -name '*.cpp' \) -print0 | xargs -0 -r clang-format -i
find rtl tb -name '*.sv' -print0 | xargs -0 -r -n 1 verible-verilog-format --inplace
