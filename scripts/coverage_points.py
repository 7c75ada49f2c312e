# SPDX-License-Identifier: Apache-2.0
"""Sums up the coverage by the tests of build/coverage: C++ by GCC, RTL by Verilator.
Writes build/figures/coverage.json, a row for each folder, and build/coverage/uncovered.txt."""

import collections
import concurrent.futures
import itertools
import json
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build/coverage"
POINT = re.compile(r"\x01(\w+)\x02([^\x01']*)")


def gcov(data):
    """Counts of GCC in an object, file by file."""
    done = subprocess.run(["gcov", "-b", "-j", "-t", data], capture_output=True, check=True,
                          cwd=BUILD)
    return json.loads(done.stdout)["files"]


def cpp_points():
    """Map (file, line, kind, which) -> number of runs."""
    points = collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        files = itertools.chain.from_iterable(pool.map(gcov, BUILD.rglob("*.gcda")))
        for file in files:
            path = (BUILD / file["file"]).resolve()
            if not any(path.is_relative_to(ROOT / tree) for tree in ("ref", "hls", "sysc")):
                continue
            name = str(path.relative_to(ROOT))
            for line in file["lines"]:
                number = line["line_number"]
                points[name, number, "line", 0] += line["count"]
                branches = [branch for branch in line["branches"] if not branch["throw"]]
                for which, branch in enumerate(branches):
                    points[name, number, "branch", which] += branch["count"]
    return points


def rtl_points():
    """Runs of a line or a branch of a module, in any instance and configuration."""
    points = collections.Counter()
    for name in BUILD.rglob("coverage.*.dat"):
        for entry in name.read_text(errors="replace").splitlines():
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
    rows = collections.defaultdict(collections.Counter)
    missed = []
    for source in (cpp_points(), rtl_points()):
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
    total = sum(rows.values(), collections.Counter())
    shares = [f"{total[kind + '_run'] / total[kind]:.1%} of {total[kind]} {name}"
              for kind, name in (("line", "lines"), ("branch", "branches"))]
    print(f"all folders: {', '.join(shares)}")


main()
