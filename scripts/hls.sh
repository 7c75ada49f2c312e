#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A kernel through clang and XLS to Verilog; scripts/hls.sh --help.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
case ${1:-} in
  -h | --help) ;;
  *) "$root/scripts/setup.sh" ;;
esac
PATH=$root/.venv/bin:$PATH exec python3 "$root/scripts/hls.py" "$@"
