#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every bench in tb/configurations.csv: each class of a parameter's values is in a row of the short
form, and each two legal classes of two parameters are together in a row of the short form or of
the pairs.  Prints the missing ones.

    tb/lint/configurations.py [FILE]     default: tb/configurations.csv
"""

import collections
import csv
import itertools
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "scripts"))
from synthesis.tables import parameters  # noqa: E402

PARAMETERS = parameters()
# The parameter that parameters.def leaves to the build: the core itself.
DEFAULTS = {name: one.default for name, one in PARAMETERS.items()} | {"Build": 0}


def every(*values):
    return {str(value): {value} for value in values}


def ends(name):
    """Returns the least value, the greatest, and those between."""
    low, high = PARAMETERS[name].low, PARAMETERS[name].high
    if high == low + 1:
        return every(low, high)
    return every(low, high) | {f"{low + 1}..{high - 1}": set(range(low + 1, high))}


def default_or_not(name):
    one = PARAMETERS[name]
    others = set(range(one.low, one.high + 1)) - {one.default}
    return every(one.default) | {f"not {one.default}": others}


INTERVAL = every(1, 8) | {"2, 4": {2, 4}}
EVEN_AND_ODD = every(2, 12) | {"even": {4, 6, 8, 10}, "odd": {3, 5, 7, 9, 11}}
# Classes other than ends().  The whole core takes its words from the cores that have rows of their
# own: there a value that is not the default shows that it comes through.
CLASSES = {bench: {"Order": EVEN_AND_ODD, "SampleInterval": INTERVAL} for bench in (
    "spherical_interpolator_serial", "curve_interpolator_serial", "spline_interpolator",
    "curve_interpolator")} | {
    "spherical_interpolator": {
        "Order": every(2, 3, 12) | {"even": {4, 6, 8, 10}, "odd": {5, 7, 9, 11}},
        "SampleInterval": every(1, 2, 4, 8)},
    "motion_interpolator": {
        "Build": every(0, 2), "SampleInterval": INTERVAL,
        **{name: default_or_not(name) for name in ("Order", "CoefBits", "PositionBits",
                                                   "GuardBits", "ParameterGuard")}},
}
# Core of a bench, if no column gives it.
CORES = {"spline_interpolator": {"Splines": 1}, "curve_interpolator": {"Splines": 1},
         "spherical_interpolator_serial": {"Build": 1},
         "curve_interpolator_serial": {"Build": 1, "Splines": 1}}


def legal(core):
    """Returns the values with which a non-default value works, by parameters.def."""
    for name, one in PARAMETERS.items():
        if core[name] == one.default:
            continue
        needs = dict(need.split("=") for need in one.needs.split())
        if any(core[other] != int(value) for other, value in needs.items()):
            return False
        if one.builds == "kParallelAlone" and core["Build"] != 0:
            return False
        if name == "SampleInterval" and core["Build"] == 2:  # it means nothing there
            return False
    return True


def pairs(classes):
    return set(itertools.combinations(classes.items(), 2))


def legal_pairs(bench, columns):
    found = set()
    for names in itertools.product(*columns.values()):
        classes = dict(zip(columns, names))
        values = {column: min(columns[column][name]) for column, name in classes.items()}
        if legal(DEFAULTS | CORES.get(bench, {}) | values):
            found |= pairs(classes)
    return found


def row_pairs(bench, columns, row):
    values = {column: int(value) for column, value in row.items() if value != "-"}
    if list(values) != list(columns):
        sys.exit(f"{bench}: a row has {', '.join(values)} instead of {', '.join(columns)}")
    if not legal(DEFAULTS | CORES.get(bench, {}) | values):
        sys.exit(f"{bench}: {','.join(row.values())} is not legal")
    return pairs({column: next(name for name, members in columns[column].items()
                               if value in members) for column, value in values.items()})


def main():
    file = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE.parent / "configurations.csv"
    rows = collections.defaultdict(list)
    with open(file, encoding="ascii") as table:
        for row in csv.DictReader(table):
            bench = row.pop("Bench")
            if row["Form"] in ("short", "pairs"):
                rows[bench].append(row)
    if set(rows) != set(CLASSES):
        sys.exit(f"{file}: benches other than {', '.join(CLASSES)}")
    status = 0
    for bench, its_rows in rows.items():
        forms = [row.pop("Form") for row in its_rows]
        columns = {column: CLASSES[bench].get(column) or ends(column)
                   for column, value in its_rows[0].items() if value != "-"}
        found = [row_pairs(bench, columns, row) for row in its_rows]
        short = set().union(*(its for its, form in zip(found, forms) if form == "short"))
        wanted = legal_pairs(bench, columns)
        missing = wanted - set().union(*found)
        print(f"{bench}: {len(its_rows)} rows, {len(wanted) - len(missing)} of {len(wanted)} pairs")
        for (one, its), (other, others) in sorted(missing):
            print(f"  missing: {one} {its} with {other} {others}")
            status = 1
        one_of = itertools.chain.from_iterable  # the pairs' classes, one by one
        for column, its in sorted(set(one_of(wanted)) - set(one_of(short))):
            print(f"  missing in the short form: {column} {its}")
            status = 1
    sys.exit(status)


if __name__ == "__main__":
    main()
