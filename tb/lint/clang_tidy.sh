#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# clang_tidy.sh CLANG_TIDY BUILD FOLDER : the rules of .clang-tidy on the translation units of a
# tree, two at a time, each once however many configurations compile it. Those that the last commit
# or the work tree changed, or a header that they include; with CURVECORE_TIDY=all, or where no git
# is, all.
set -euo pipefail
commands=$(mktemp -d)
trap 'rm -r "$commands"' EXIT
python3 - "$2" "$3" "$commands" <<'PYTHON' |
import json, os, pathlib, re, subprocess, sys
build, folder, out = map(pathlib.Path, sys.argv[1:])

def git(*words):
    git = subprocess.run(["git", "-C", folder, *words], capture_output=True, text=True)
    return git.stdout.split("\n")[:-1] if git.returncode == 0 else None

def changed():
    """Paths from the top of the repository; None: nobody knows."""
    log = git("log", "--format=", "--name-only", "-1")
    status = git("status", "--porcelain", "--untracked-files=all")
    return None if log is None or status is None else {*log, *(line[3:] for line in status)}

def single(entry):
    """Entries of the files of a unit that joins several, or the entry itself."""
    if "/Unity/" not in entry["file"]:
        return [entry]
    text = pathlib.Path(entry["file"]).read_text()
    return [entry | {"file": file, "command": entry["command"].replace(entry["file"], file)}
            for file in re.findall(r'^#include "(.*)"$', text, re.M)]

entries = [one for entry in json.loads((build / "compile_commands.json").read_text())
           for one in single(entry)]
first = {e["file"]: e for e in reversed(entries) if e["file"].startswith(f"{folder}/")}
unknown = {str(file) for file in folder.rglob("*.cpp")  # but LinuxCNC's module, and what
           if file.parent.name != "linuxcnc"            # core_cache.cpp compiles
           and file.name != "compiled_board.cpp"} - set(first)
if unknown:
    sys.exit("nothing compiles " + ", ".join(sorted(unknown)))
paths = None if os.environ.get("CURVECORE_TIDY") == "all" else changed()
if paths is not None:
    top = pathlib.Path((git("rev-parse", "--show-toplevel") or [folder])[0])
    headers = [f'"{path}"' for path in paths if path.endswith(".hpp")]
    def touched(file):
        text = pathlib.Path(file).read_text()
        return str(pathlib.Path(file).relative_to(top)) in paths or any(h in text for h in headers)
    first = {file: e for file, e in first.items() if touched(file)}
for entry in first.values():  # GCC's precompiled headers are nothing to clang
    entry["command"] = re.sub(r"-include \S+/cmake_pch\.hxx ", "", entry["command"])
(out / "compile_commands.json").write_text(json.dumps(list(first.values())))
print(f"{len(first)} files", file=sys.stderr)
print(*sorted(first), sep="\0", end="\0" if first else "")
PYTHON
  xargs -0 --no-run-if-empty -n 4 -P 2 "$1" --quiet -p "$commands"
