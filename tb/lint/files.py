#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every source file names its licence, is ASCII, has at most 100 columns and 400 lines, and no
table in a comment whose rows run together.  What runs inside LinuxCNC has LinuxCNC's licence.

    files.py ROOT
"""

import pathlib
import re
import sys

TREES = ("ref", "hls", "rtl", "sysc", "tb", "scripts")
KINDS = (".cpp", ".hpp", ".sv", ".sh", ".py", ".pyi", ".cmake", ".comp")
JOINED = re.compile(r" *//+ +(\| \| |\|.*[a-z] \| \| [a-z])")


def sources(root):
    yield root / "CMakeLists.txt"
    for tree in TREES:
        for file in (root / tree).rglob("*"):
            if (file.suffix in KINDS or file.name == "CMakeLists.txt"
                    or (file.suffix in (".c", ".h") and file.parent.name == "linuxcnc")):
                yield file


def faults(text, licence):
    lines = text.splitlines()
    if not any(f"SPDX-License-Identifier: {licence}" in line for line in lines[:2]):
        yield "no SPDX line"
    if len(lines) > 400:
        yield "more than 400 lines"
    for number, line in enumerate(lines, 1):
        if not line.isascii():
            yield f"{number}: not ASCII"
        if len(line) > 100:
            yield f"{number}: more than 100 columns"
        if JOINED.match(line):
            yield f"{number}: rows of a table in a comment run together"


def main(root):
    red = 0
    for file in sources(root):
        gpl = file.is_relative_to(root / "sysc/linuxcnc")
        for fault in faults(file.read_text(), "GPL-2.0-or-later" if gpl else "Apache-2.0"):
            red += 1
            print(f"{file.relative_to(root)}: {fault}")
    head = "// SPDX-License-Identifier: Apache-2.0\n"
    broken = ("int a;\n", head + "\n" * 400, head + "// \u00b5m\n", head + "/" * 101 + "\n",
              head + "// | a | b | | c | d |\n")
    return red or sum(not list(faults(text, "Apache-2.0")) for text in broken)


if __name__ == "__main__":
    sys.exit(bool(main(pathlib.Path(sys.argv[1]))))
