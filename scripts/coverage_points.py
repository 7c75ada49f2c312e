#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sums up coverage: C++ from gcovr's JSON (the argument), RTL from Verilator's files, whose names
come on standard input, each ended by a zero byte.  Writes build/figures/coverage.json, a row for
each folder, and build/coverage/uncovered.txt."""

import collections
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
POINT = re.compile(r"\x01(\w+)\x02([^\x01']*)")


def cpp_points(name):
    """(file, line, kind, which) -> times that it ran"""
    points = collections.Counter()
    for file in json.loads(pathlib.Path(name).read_text())["files"]:
        for line in file["lines"]:
            if line.get("gcovr/noncode") or line.get("gcovr/excluded"):
                continue
            number = line["line_number"]
            points[file["file"], number, "line", 0] += line["count"]
            for which, branch in enumerate(line["branches"]):
                points[file["file"], number, "branch", which] += branch["count"]
    return points


def rtl_points(names):
    """The same: a line or a branch of a module, in whatever instance and configuration."""
    points = collections.Counter()
    for name in names:
        for entry in pathlib.Path(name).read_text(errors="replace").splitlines():
            if not entry.startswith("C '"):
                continue
            field = dict(POINT.findall(entry))
            path = pathlib.Path(field["f"])
            if not path.is_relative_to(ROOT / "rtl"):
                continue
            kind = "branch" if field["page"].startswith("v_branch") else "line"
            key = str(path.relative_to(ROOT)), int(field["l"]), kind, field["n"] + field["o"]
            points[key] += int(entry.rsplit(" ", 1)[1])
    return points


def main():
    names = [name for name in sys.stdin.read().split("\0") if name]
    rows = collections.defaultdict(collections.Counter)
    missed = []
    for source in (cpp_points(sys.argv[1]), rtl_points(names)):
        for (file, line, kind, which), count in sorted(source.items(), key=str):
            folder = str(pathlib.Path(file).parent)
            rows[folder][kind] += 1
            rows[folder][kind + "_run"] += count > 0
            if count == 0 and kind == "line":
                missed.append((file, line))
    table = [{"folder": folder, **row} for folder, row in sorted(rows.items())]
    (ROOT / "build/figures/coverage.json").write_text(json.dumps(table, indent=1))
    text = "".join(f"{file}:{line}\n" for file, line in sorted(set(missed)))
    (ROOT / "build/coverage/uncovered.txt").write_text(text)
    for row in table:
        print(row)


main()
