# SPDX-License-Identifier: Apache-2.0
"""Parts that every page of scripts/results is made with."""

import dataclasses
import functools
import json
import math
import pathlib
import re
import subprocess
from collections.abc import Callable

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"
RESULTS = ROOT / "scripts/results"
TREES = ("ref", "hls", "rtl", "sysc", "tb", "scripts")
PAGES = [ROOT / "README.md",
         *sorted(page for tree in TREES for page in (ROOT / tree).rglob("README.md"))]


@dataclasses.dataclass(frozen=True)
class Table:
    title: str
    make: Callable  # its text; None: no data
    command: str  # what measures it, or the file that it follows from
    note: str = ""  # explanation for readers
    measured: bool = True  # else it follows from files of this tree
    exact: bool = False  # measured, and the same on every machine


def git(*arguments):
    return subprocess.run(["git", "-C", ROOT, *arguments], check=True, text=True,
                          capture_output=True).stdout.strip()


@functools.cache
def sources():
    """The tree: the last commit of what is measured, and when it was made."""
    if not (ROOT / ".git").exists():
        return "unknown", math.inf  # so nothing counts as measured
    commit, time = git("log", "-1", "--format=%h %ct", "--", "ref", "hls", "rtl", "sysc",
                       ":(exclude)*.md").split()
    return commit, float(time)


def measured(path):
    """A file of the build folder, if it was written after the sources were."""
    file = BUILD / path
    return file if file.exists() and file.stat().st_mtime > sources()[1] else None


def load(path):
    file = measured(path)
    return json.loads(file.read_text()) if file else None


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines)


def cells(name):
    """Head and rows of the first table of scripts/results/NAME.md."""
    first = re.search(r"(?:^\|.*\n)+", (RESULTS / f"{name}.md").read_text(), re.M)[0]
    head, _, *rows = [[cell.strip() for cell in line.split("|")[1:-1]]
                      for line in first.splitlines()]
    return head, rows


def excerpt(name, columns, keys):
    """Columns of scripts/results/NAME.md, by their places, of the rows that begin with a key."""
    head, rows = cells(name)
    found = [next(row for row in rows if tuple(row[:len(key)]) == key) for key in keys]
    return table([head[c] for c in columns], [[row[c] for c in columns] for row in found])


def short(value):
    return f"{value:.3g}"
