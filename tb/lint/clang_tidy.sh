#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# clang_tidy.sh CLANG_TIDY BUILD FOLDER : the rules of .clang-tidy on every translation unit of a
# tree, two at a time, each once however many configurations compile it.
set -euo pipefail
commands=$(mktemp -d)
trap 'rm -r "$commands"' EXIT
python3 - "$2" "$3" "$commands" <<'PYTHON' |
import json, pathlib, sys
build, folder, out = map(pathlib.Path, sys.argv[1:])
entries = json.loads((build / "compile_commands.json").read_text())
first = {e["file"]: e for e in reversed(entries) if e["file"].startswith(f"{folder}/")}
(out / "compile_commands.json").write_text(json.dumps(list(first.values())))
print(*sorted(first), sep="\0", end="\0" if first else "")
PYTHON
  xargs -0 --no-run-if-empty -n 4 -P 2 "$1" --quiet -p "$commands"
