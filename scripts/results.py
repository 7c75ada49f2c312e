#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the pages of scripts/results from what this tree's runs printed, a table each, and the
few rows of them that every README.md shows.  The scripts that measure call it for their pages.

    scripts/results.py [NAME ..]             writes what was measured (build/), or these pages alone
    scripts/results.py --check               compares what follows from this tree's files
    scripts/results.py --check --measured    and what scripts/pages.sh has measured

A page names the command that measures it and its tree: the last commit that changed ref, hls, rtl
or sysc before that.  What was not measured since keeps its table and its tree.  A README's rows
stand between `<!-- begin: NAME -->` and `<!-- end: NAME -->`.
"""

import argparse
import re
import subprocess
import sys
import textwrap

from accuracy_tables import errors
from claim_tables import others_rows
from parameter_table import parameter_rows
from placed_tables import boards, sizes
from result_list import TABLES
from result_table import PAGES, RESULTS, ROOT, excerpt, git, sources

ROWS = {
    "errors": errors,
    "sizes": sizes,
    "parameters": parameter_rows,
    "boards": boards,
    "others_rows": others_rows,
    "oracle_rows": lambda: excerpt("oracle", (0, 2, 3, 4, 5), (
        ("line100", "500"), ("circle25", "500"), ("wave", "500"), ("sine", "500"),
        ("random1", "500"))),
}

PAGE = re.compile(r".*?^(?:Measured by|Follows from) `[^`]+`(?:, tree (?P<tree>\w+))?\.\n"
                  r"\n(?P<body>.*)", re.S | re.M)
PLACE = re.compile(r"<!-- begin: (?P<name>\w+) -->\n(?P<body>.*?)<!-- end: (?P=name) -->", re.S)

# Of a table, in a sentence, or in a cell.
TREE = re.compile(r"(?:\b(?:tree|version|commit) |\| (?=\d*[a-f]))([0-9a-f]{7,40})\b")


def page_of(table, body, tree):
    by = (f"Measured by `{table.command}`, tree {tree}." if table.measured
          else f"Follows from `{table.command}`.")
    note = textwrap.fill(table.note, 120, break_on_hyphens=False, break_long_words=False)
    return "\n\n".join(filter(None, (f"# {table.title}", note, by, body.strip()))) + "\n"


def write(names):
    for name in names:
        table = TABLES[name]
        file = RESULTS / f"{name}.md"
        body, tree = table.make(), sources()[0]
        kept = body is None
        if kept and file.exists():
            last = PAGE.fullmatch(file.read_text())
            body, tree = last["body"], last["tree"]
        print(f"{name}: {'not measured on this tree, kept' if kept else 'written'}")
        if body is not None:
            file.write_text(page_of(table, body, tree))
    for page in PAGES:
        text = page.read_text()
        new = PLACE.sub(lambda place: f"<!-- begin: {place['name']} -->\n{ROWS[place['name']]()}\n"
                                      f"<!-- end: {place['name']} -->", text)
        if new != text:
            page.write_text(new)


def known(tree):
    if not (ROOT / ".git").exists() or git("rev-parse", "--is-shallow-repository") == "true":
        return True
    return subprocess.run(["git", "-C", ROOT, "merge-base", "--is-ancestor", tree, "HEAD"],
                          capture_output=True).returncode == 0


def page_faults(name, table, measured_too):
    """Returns the fault of a page of scripts/results."""
    file = RESULTS / f"{name}.md"
    if not file.exists():
        return [f"is not there: run {table.command}, then scripts/results.py"]
    text = file.read_text()
    page = PAGE.fullmatch(text)
    if not page or table.measured and not page["tree"]:
        return ["names no command or no tree"]
    if text != page_of(table, page["body"], page["tree"]):
        return ["has another head: run scripts/results.py"]
    if not table.measured or (table.exact and measured_too):
        body = table.make()
        if body is None:
            return [f"was not measured on this tree: run {table.command}"]
        if body.strip() != page["body"].strip():
            return ["is not what this tree makes of it: run scripts/results.py"]
    return []


def readme_faults(page):
    """Returns the fault of the rows that a README shows."""
    text = page.read_text()
    places = list(PLACE.finditer(text))
    if len(places) != len(re.findall("<!-- (?:begin|end):", text)) / 2:
        yield "rows have a begin or an end that is not as it should be"
    for place in places:
        make = ROWS.get(place["name"])
        if make is None:
            yield f"{place['name']}: there are no such rows"
        elif make() + "\n" != place["body"]:
            yield f"{place['name']}: run scripts/results.py"


def check(measured_too):
    text = {page: page.read_text() for page in [*PAGES, *RESULTS.glob("*.md")]}
    bad = [f"scripts/results/{name}.md: {fault}" for name, table in TABLES.items()
           for fault in page_faults(name, table, measured_too)]
    bad += [f"{page.relative_to(ROOT)}: {fault}" for page in PAGES for fault in readme_faults(page)]
    bad += [f"{page.relative_to(ROOT)}: no commit {tree} is behind this one"
            for page in text for tree in sorted(set(TREE.findall(text[page]))) if not known(tree)]
    bad += [f"scripts/results/{name}.md: no README.md leads to it" for name in TABLES
            if not any(f"/{name}.md)" in text[page] for page in PAGES)]
    bad += [f"{page.relative_to(ROOT)}: no script writes it"
            for page in RESULTS.glob("*.md") if page.stem not in TABLES]
    sys.exit("\n".join(bad) or 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="compare only")
    parser.add_argument("--measured", action="store_true",
                        help="compare what was measured and is the same on every machine, too")
    parser.add_argument("names", nargs="*", metavar="NAME", help="a page, all when left out")
    given = parser.parse_args()
    unknown = [name for name in given.names if name not in TABLES]
    if unknown:
        parser.error(f"unknown page '{unknown[0]}': one of {', '.join(TABLES)}")
    if given.check:
        check(given.measured)
    write(given.names or TABLES)


if __name__ == "__main__":
    main()
