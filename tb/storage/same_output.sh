#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# same_output.sh A B: both programs print the same lines, and at least 100,000 of them.
set -euo pipefail
lines=$("$1" | wc -l)
[ "$lines" -ge 100000 ] || { echo "only $lines lines"; exit 1; }
cmp <("$1") <("$2") && echo "$lines lines are equal"
