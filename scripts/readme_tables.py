#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the tables of every README.md from what this tree's runs printed.

    scripts/readme_tables.py                       writes what was measured (build/)
    scripts/readme_tables.py --check               compares what follows from this tree's files
    scripts/readme_tables.py --check --measured    and what scripts/pages.sh has measured

A table stands between `<!-- begin: NAME: COMMAND, tree COMMIT -->` and `<!-- end: NAME -->`.
COMMAND measures it; COMMIT is the last one that changed ref, hls, rtl or sysc before it did.  What
was not measured since keeps its text and its COMMIT.  A table without one follows from files of
this tree alone.
"""

import argparse
import functools
import re
import subprocess
import sys

from accuracy_tables import (accuracy, coverage, demo, equality, errors, splines, system_rates,
                             throughput)
from choose_tables import choose, choose_impossible, order_words, parameter_guard
from claim_tables import (bench_table, claims, drawn, minimal_orders, oracle, others,
                          paper_table)
from parameter_table import parameter_rows
from linuxcnc_table import linuxcnc
from placed_tables import (boards, cost_model, hls, networks, order_words_placed,
                           parameter_guard_placed, sizes, synthesis)
from readme_table import PAGES, ROOT, Table, git, sources

BENCH = "scripts/bench.sh"
EXACT = "scripts/pages.sh"
CAMPAIGN = "scripts/campaign.sh"
SWEEP = "scripts/synth.sh --sweep scripts/sweeps/"

bench = functools.partial(functools.partial, bench_table)

# exact: the same on every machine, so --check compares what this tree's runs have left
TABLES = {
    "errors": Table(errors, "tables of tb/README.md", measured=False),
    "sizes": Table(sizes, "table of rtl/README.md", measured=False),
    "parameters": Table(parameter_rows, "ref/format/parameters.def", measured=False),
    "cost_model": Table(cost_model, "scripts/fit_cost_model.py", measured=False),
    "demo": Table(demo, EXACT, exact=True),
    "choose_up5k": Table(functools.partial(choose, "up5k"), BENCH),
    "choose_ecp5": Table(functools.partial(choose, "ecp5"), EXACT, exact=True),
    "choose_splines": Table(functools.partial(choose, "splines"), EXACT, exact=True),
    "choose_impossible": Table(choose_impossible, EXACT, exact=True),
    "parameter_guard": Table(parameter_guard, EXACT, exact=True),
    "order_words": Table(order_words, EXACT, exact=True),
    "order_words_placed": Table(order_words_placed, SWEEP + "order_words.csv"),
    "parameter_guard_placed": Table(parameter_guard_placed, SWEEP + "parameter_guard.csv"),
    "synthesis": Table(synthesis, SWEEP + "readme.csv"),
    "networks": Table(networks, SWEEP + "networks.csv"),
    "boards": Table(boards, "scripts/synth.sh --board NAME --record", measured=False),
    "hls": Table(hls, "scripts/hls.sh --sweep scripts/sweeps/hls.csv"),
    "accuracy": Table(accuracy, CAMPAIGN),
    "splines": Table(splines, CAMPAIGN),
    "equality": Table(equality, CAMPAIGN),
    "coverage": Table(coverage, "scripts/coverage.sh"),
    "throughput": Table(throughput, BENCH),
    "system_rates": Table(system_rates, "scripts/system_rates.py"),
    "claims": Table(claims, EXACT, exact=True),
    "paper_table": Table(paper_table, EXACT, exact=True),
    "minimal_orders": Table(minimal_orders, EXACT, exact=True),
    "oracle": Table(oracle, "scripts/oracle.sh"),
    "drawn": Table(drawn, "scripts/oracle.sh"),
    "linuxcnc": Table(linuxcnc, "scripts/linuxcnc.sh"),
    "forms": Table(bench("form_tables", "forms"), EXACT, exact=True),
    "holds": Table(bench("hold_tables", "holds"), EXACT, exact=True),
    "spline_tick": Table(bench("spline_tables", "spline_tick"), EXACT, exact=True),
    "spline_period": Table(bench("spline_tables", "spline_period"), EXACT, exact=True),
    "cam_pieces": Table(bench("cam_tables", "cam_pieces"), EXACT, exact=True),
    "cam_surfaces": Table(bench("cam_tables", "cam_surfaces"), EXACT, exact=True),
    "cam_input": Table(bench("cam_tables", "cam_input"), EXACT, exact=True),
    "search_stops": Table(bench("search_tables", "search_stops"), EXACT, exact=True),
    "search_ticks": Table(bench("search_tables", "search_ticks"), EXACT, exact=True),
    "search_words": Table(bench("search_tables", "search_words"), EXACT, exact=True),
    "others": Table(others, EXACT, exact=True),
}

PLACE = re.compile(r"<!-- begin: (?P<name>\w+): (?P<command>[^,]*?)(?:, tree (?P<tree>\w+))? -->\n"
                   r"(?P<body>.*?)<!-- end: (?P=name) -->", re.S)

# Of a table, in a sentence, or in a cell.
TREE = re.compile(r"(?:\b(?:tree|version|commit) |\| (?=\d*[a-f]))([0-9a-f]{7,40})\b")


def written(place):
    """The place anew, and what became of it."""
    name = place["name"]
    table = TABLES[name]
    body = table.make()
    if body is None:
        return place[0], "not measured on this tree, kept"
    tree = f", tree {sources()[0]}" if table.measured else ""
    begin = f"<!-- begin: {name}: {table.command}{tree} -->"
    return f"{begin}\n{body}\n<!-- end: {name} -->", "written"


def faults(place, measured_too):
    """What is wrong with a place."""
    table = TABLES.get(place["name"])
    if table is None:
        return ["there is no such table"]
    found = []
    if place["command"] != table.command:
        found.append(f"is made by: {table.command}")
    if table.measured and not place["tree"]:
        found.append("names no tree")
    if not table.measured or (table.exact and measured_too):
        body = table.make()
        if body is None:
            found.append(f"was not measured on this tree: run {table.command}")
        elif body + "\n" != place["body"]:
            found.append("is not what this tree makes of it: run scripts/readme_tables.py")
    return found


def known(tree):
    if not (ROOT / ".git").exists() or git("rev-parse", "--is-shallow-repository") == "true":
        return True
    return subprocess.run(["git", "-C", ROOT, "merge-base", "--is-ancestor", tree, "HEAD"],
                          capture_output=True).returncode == 0


def check(measured_too):
    bad = []
    seen = []
    for page in PAGES:
        text = page.read_text()
        places = list(PLACE.finditer(text))
        if len(places) != len(re.findall("<!-- (?:begin|end):", text)) / 2:
            bad.append(f"{page.relative_to(ROOT)}: a table's begin or end is not as it should be")
        seen += [place["name"] for place in places]
        bad += [f"{page.relative_to(ROOT)}: {place['name']}: {fault}"
                for place in places for fault in faults(place, measured_too)]
        bad += [f"{page.relative_to(ROOT)}: no commit {tree} is behind this one"
                for tree in sorted(set(TREE.findall(text))) if not known(tree)]
    bad += [f"{name}: is in no README.md" for name in TABLES if name not in seen]
    sys.exit("\n".join(bad) or 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="compare only")
    parser.add_argument("--measured", action="store_true",
                        help="compare what was measured and is the same on every machine, too")
    given = parser.parse_args()
    if given.check:
        check(given.measured)
    for page in PAGES:
        def replace(place):
            text, what = written(place)
            print(f"{page.relative_to(ROOT)}: {place['name']}: {what}")
            return text

        page.write_text(PLACE.sub(replace, page.read_text()))


if __name__ == "__main__":
    main()
