# SPDX-License-Identifier: Apache-2.0
"""What every table of a README.md is made with."""

import dataclasses
import functools
import json
import math
import pathlib
import subprocess
from collections.abc import Callable

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"


@dataclasses.dataclass(frozen=True)
class Table:
    make: Callable  # its text; None: there is nothing to make it of
    command: str  # what measures it
    measured: bool = True  # else it follows from files of this tree
    exact: bool = False  # measured, and the same on every machine


PAGES = [ROOT / "README.md", *sorted(ROOT.glob("*/README.md"))]


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


def short(value):
    return f"{value:.3g}"
