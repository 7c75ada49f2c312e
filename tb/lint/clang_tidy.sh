#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# clang_tidy.sh CLANG_TIDY BUILD FOLDER : the rules of .clang-tidy on every translation unit of a
# tree, two at a time, each once however many configurations compile it.
set -euo pipefail
find "$3" -name '*.cpp' -print0 | while IFS= read -r -d '' file; do
  if grep -qF "\"$file\"" "$2/compile_commands.json"; then printf '%s\0' "$file"; fi
done | xargs -0 --no-run-if-empty -n 4 -P 2 "$1" --quiet -p "$2"
