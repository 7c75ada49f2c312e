#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The front page fits on two screens, the pages of the trees are short, and every link of a page
leads to a file of this tree, and to a heading of it."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TREES = ("ref", "hls", "rtl", "sysc", "tb", "scripts")
LINES = 150  # of README.md
WORDS = 12000  # of README.md and that of each tree, together
ROOM = 1800  # words of a page within a tree


def anchors(text):
    """GitHub's names of a page's headings."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.S | re.M)
    for heading in re.findall(r"^#+ +(.*)$", text, re.M):
        yield re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def faults(page, text):
    for name, anchor in re.findall(r"\]\(([^)#\s]*)(?:#([^)\s]*))?\)", text):
        if re.match("(https?|mailto):", name):
            continue
        file = page.parent / name if name else page
        if not file.exists():
            yield f"{page.relative_to(ROOT)}: no file {name}"
        elif anchor and anchor not in anchors(file.read_text()):
            yield f"{page.relative_to(ROOT)}: no heading {name}#{anchor}"


def main():
    trees = [ROOT / "README.md", *(ROOT / tree / "README.md" for tree in TREES)]
    pages = [*ROOT.glob("*.md"), *ROOT.glob(".github/**/*.md"),
             *(page for tree in TREES for page in (ROOT / tree).rglob("*.md"))]
    text = {page: page.read_text() for page in pages}
    words = {page: len(text[page].split()) for page in pages}
    found = [fault for page in pages for fault in faults(page, text[page])]
    if text[trees[0]].count("\n") > LINES:
        found.append(f"README.md: more than {LINES} lines")
    if sum(words[page] for page in trees) > WORDS:
        found.append(f"README.md and the trees' have {sum(words[page] for page in trees)} words,"
                     f" more than {WORDS}")
    found += [f"{page.relative_to(ROOT)}: more than {ROOM} words" for page in pages
              if page.name == "README.md" and page not in trees and words[page] > ROOM]
    print(*found, sep="\n", end="\n" if found else "")
    # A link to nothing and one to no heading are seen.
    wrong = "[a](no_such.md) [b](README.md#no-such) [c](#no-such)"
    return bool(found) or len(list(faults(ROOT / "README.md", wrong))) != 3


if __name__ == "__main__":
    sys.exit(main())
