#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Each tree's README has a table of its rooms, the highest first: a row for every folder that has
sources, a room has 4 to 16 of them, and no file includes one of a room in a row above its own.  Of
trees, sysc stands above hls, and hls above ref.  Rooms of tests are as large, and have no rows."""

import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TREES = ("sysc", "hls", "ref")
TESTS = ("tb/model", "tb/unit", "tb/formal", "tb/support")
LEAST, MOST = 4, 16
SOURCES = (".cpp", ".hpp", ".h", ".in", ".def", ".html", ".js", ".css", ".json")


def rooms(tree):
    """Returns the rooms of a README's rows `| `room/` | ...`, in order, or the tree itself."""
    rows = re.findall(r"^\| `([\w/]+)/` \|.*\|.*\S \|$", (ROOT / tree / "README.md").read_text(),
                      re.M)
    return [f"{tree}/{row}" for row in rows] or [tree]


def faults(order, includes):
    """includes: file to the files that it includes, all of them in a room of `order` or beneath."""
    floor = {room: place for place, room in enumerate(order)}

    def of(file):
        return next((str(up) for up in pathlib.PurePath(file).parents if str(up) in floor), None)

    count = collections.Counter()
    for file, others in includes.items():
        room, folder = of(file), str(pathlib.PurePath(file).parent)
        if room != folder and folder not in ("hls/top", "hls/registers", "hls/curves"):
            yield f"{file}: its folder has no row in the table of rooms"
            continue
        count[room] += 1
        for other in others:
            above = of(other)
            if above and floor[above] < floor[room]:
                yield f"{file} includes {other}, whose room {above} stands above {room}"
    del count["hls"]
    yield from crowds(count)


def crowds(count):
    for room, files in count.items():
        if not LEAST <= files <= MOST:
            yield f"{room}: {files} files, a room has {LEAST} to {MOST}"


def main():
    order = [room for tree in TREES for room in rooms(tree)]
    files = [file for tree in TREES for file in (ROOT / tree).rglob("*")
             if file.suffix in SOURCES and file.parent.name not in ("linuxcnc", "cmake")]
    includes = {str(file.relative_to(ROOT)): re.findall(r'^#include "([^"]+)"', file.read_text(),
                                                        re.M) for file in files}
    found = list(faults(order, includes))
    found += crowds(collections.Counter(
        str(file.parent.relative_to(ROOT)) for tree in TESTS for file in (ROOT / tree).rglob("*")
        if file.suffix in (".cpp", ".hpp", ".sv")
        and file.parent.name not in ("environment", "primitives")))
    print(*found, sep="\n")
    # An include that runs up, a folder without a row and a crowd are seen.
    up = {"ref/curve/a.hpp": ["ref/feed/b.hpp"]}
    crowd = {f"ref/curve/{n}.hpp": [] for n in range(MOST + 1)}
    seen = [list(faults(["ref/feed", "ref/curve"], case))
            for case in (up, {"ref/new/a.hpp": []}, crowd)]
    return bool(found) or not all(seen)


if __name__ == "__main__":
    sys.exit(main())
