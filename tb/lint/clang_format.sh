#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# clang_format.sh CLANG_FORMAT FOLDER : every C++ file is formatted; `scripts/format.sh` mends it.
set -eu
find "$2" \( -name '*.hpp' -o -name '*.cpp' \) -print0 |
  xargs -0 --no-run-if-empty "$1" --dry-run -Werror
