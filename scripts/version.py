#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The version of this tree: project(VERSION) of CMakeLists.txt, from which the program, the wheel,
the site's demo and the installed package take theirs.

    scripts/version.py                     prints it, once the files that repeat it agree
    scripts/version.py X.Y.Z               sets it in all of them, dated today: a release's commit
    scripts/version.py --program PROGRAM   checks what PROGRAM says of itself, too

The files that repeat it: the FuseSoC core, .github/CITATION.cff, and CHANGELOG.md, whose newest
numbered section is this version's. Boards tell no release: VERSION of their registers has the
versions of registers (registers.rdl) and of words (hls/words.hpp), which a host compares.

Exit status: 0, 1 where something disagrees, 2 where the command line is wrong.
"""

import argparse
import datetime
import pathlib
import re
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = "CMakeLists.txt"
CITATION, CORE, CHANGES = ".github/CITATION.cff", "rtl/curvecore.core", "CHANGELOG.md"
NUMBER = r"\d+\.\d+\.\d+"
DATE = r"\d{4}-\d\d-\d\d"
STATED = {  # what stands before the version in a file that repeats it
    SOURCE: r"^project\(curvecore VERSION ",
    CITATION: r"^version: ",
    CORE: r'^name: "curvecore:motion:curvecore:',
}
SECTION = re.compile(rf"^## \[({NUMBER})\] - ({DATE})$", re.M)
UNRELEASED = "## [Unreleased]\n"


def text(name):
    return (ROOT / name).read_text(encoding="utf-8")


def stated(name):
    found = re.search(f"({STATED[name]})({NUMBER})(?![.\\d])", text(name), re.M)
    return found[2] if found else None


def of_wheel():
    """Returns what the wheel's build finds, by the expression of its pyproject.toml."""
    ask = tomllib.loads(text("sysc/python/pyproject.toml"))["tool"]["scikit-build"]["metadata"]
    found = re.search(ask["version"]["regex"], text(ask["version"]["input"]))
    return found["value"] if found else None


def disagreements(version, program=""):
    for name in (CITATION, CORE):
        if stated(name) != version:
            yield f"{name}: has version {stated(name)}"
    newest = SECTION.search(text(CHANGES))
    dated = re.search(rf"^date-released: ({DATE})$", text(CITATION), re.M)
    if not newest or newest[1] != version:
        yield f"{CHANGES}: the newest section is of version {newest[1] if newest else None}"
    elif not dated or dated[1] != newest[2]:
        yield f"{CITATION}: date-released is not {newest[2]}, that of the section in {CHANGES}"
    if of_wheel() != version:
        yield f"sysc/python/pyproject.toml: its expression finds version {of_wheel()}"
    if program:
        said = subprocess.run([program, "--version"], capture_output=True, text=True).stdout
        if said != f"curvecore {version}\n":
            yield f"{program}: says '{said.strip()}'"


def put(name, pattern, new):
    """Puts one text in place of the first that matches."""
    changed, times = re.subn(pattern, lambda found: new, text(name), count=1, flags=re.M)
    if not times:
        raise SystemExit(f"version: {name}: has no text {pattern}")
    (ROOT / name).write_text(changed, encoding="utf-8")


def write(version):
    today = datetime.date.today().isoformat()
    for name in STATED:
        before = re.search(STATED[name], text(name), re.M)[0]
        put(name, STATED[name] + NUMBER, before + version)
    put(CITATION, f"^date-released: {DATE}$", f"date-released: {today}")
    put(CHANGES, re.escape(UNRELEASED), f"{UNRELEASED}\n## [{version}] - {today}\n")


def refuse(reason):
    print(f"version: {reason}", file=sys.stderr)
    return 2


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("version", nargs="?", metavar="X.Y.Z")
    parser.add_argument("--program", default="", metavar="PROGRAM")
    given = parser.parse_args()
    version = stated(SOURCE)
    if not version:
        print(f"version: {SOURCE}: has no project(curvecore VERSION X.Y.Z ..", file=sys.stderr)
        return 1
    if given.version:
        if not re.fullmatch(NUMBER, given.version):
            return refuse(f"'{given.version}' is no version: three numbers, such as 0.2.0")
        if tuple(map(int, given.version.split("."))) <= tuple(map(int, version.split("."))):
            return refuse(f"{given.version} does not follow {version}")
    found = list(disagreements(version, given.program))
    for fault in found:
        print(f"version: {fault}; {SOURCE} has {version}", file=sys.stderr)
    if found:
        return 1
    if given.version:
        write(given.version)
    print(given.version or version)
    return 0


if __name__ == "__main__":
    sys.exit(main())
