#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Of every core's table tb/configurations/*.csv: each two classes of values of two parameters that
may stand together do stand together in a row.  Says which pairs are missing.

    tb/lint/configurations.py [FOLDER]     default: tb/configurations
"""

import csv
import itertools
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "scripts"))
from synthesis.tables import parameters  # noqa: E402

PARAMETERS = parameters()
# What parameters.def leaves to the build: the core itself.
DEFAULTS = {name: one.default for name, one in PARAMETERS.items()} | {"Build": 0}


def every(*values):
    return {str(value): {value} for value in values}


def ends(name):
    """The least value, the greatest, and those between."""
    low, high = PARAMETERS[name].low, PARAMETERS[name].high
    return every(low, high) | {f"{low + 1}..{high - 1}": set(range(low + 1, high))}


def default_or_not(name):
    one = PARAMETERS[name]
    others = set(range(one.low, one.high + 1)) - {one.default}
    return every(one.default) | {f"not {one.default}": others}


WIDTHS = {name: ends(name) for name in ("CoefBits", "PositionBits", "GuardBits", "AuxAxes")}
ORDER = every(2, 12) | {"even": {4, 6, 8, 10}, "odd": {3, 5, 7, 9, 11}}
INTERVAL = every(1, 8) | {"2, 4": {2, 4}}
MODE = {"Mode": every(0, 1)}

# The classes of every column, table by table.  The whole core takes its words from the cores that
# have tables of their own: there a value that is not the default shows that it comes through.
SERIAL = {"Order": ORDER} | WIDTHS | MODE
SPLINES = {"Order": ORDER} | WIDTHS | MODE | {
    "Anchor": every(0, 1), "SampleInterval": INTERVAL, "ParameterGuard": ends("ParameterGuard")}
TABLES = {
    "spherical_interpolator": {
        "Order": every(2, 3, 12) | {"even": {4, 6, 8, 10}, "odd": {5, 7, 9, 11}}, **WIDTHS, **MODE,
        "SampleInterval": every(1, 2, 4, 8), "TurnBits": default_or_not("TurnBits")},
    "spherical_interpolator_serial": SERIAL,
    "curve_interpolator_serial": SERIAL,
    "spline_interpolator": SPLINES,
    "curve_interpolator": SPLINES,
    "motion_interpolator": {
        "Build": every(0, 1),
        **{name: default_or_not(name) for name in ("Order", "CoefBits", "PositionBits",
                                                   "GuardBits")},
        "AuxAxes": ends("AuxAxes"), "Splines": every(0, 1), **MODE, "Anchor": every(0, 1),
        "SampleInterval": INTERVAL, "ParameterGuard": default_or_not("ParameterGuard"),
        "TurnBits": default_or_not("TurnBits")},
}
# Of the core that a table is of, where no column says it.
CORES = {"spline_interpolator": {"Splines": 1}, "curve_interpolator": {"Splines": 1},
         "spherical_interpolator_serial": {"Build": 1},
         "curve_interpolator_serial": {"Build": 1, "Splines": 1}}


def legal(core):
    """As parameters.def says: what a value other than the default works with."""
    for name, one in PARAMETERS.items():
        if core[name] == one.default:
            continue
        needs = dict(need.split("=") for need in one.needs.split())
        if any(core[other] != int(value) for other, value in needs.items()):
            return False
        if one.builds == "kParallelAlone" and core["Build"] == 1:
            return False
    return True


def pairs(classes):
    return set(itertools.combinations(classes.items(), 2))


def legal_pairs(table):
    found = set()
    columns = TABLES[table]
    for names in itertools.product(*columns.values()):
        classes = dict(zip(columns, names))
        values = {column: min(columns[column][name]) for column, name in classes.items()}
        if legal(DEFAULTS | CORES.get(table, {}) | values):
            found |= pairs(classes)
    return found


def row_pairs(table, row):
    columns = TABLES[table]
    values = {column: int(value) for column, value in row.items()}
    if list(values) != list(columns):
        sys.exit(f"{table}: columns {', '.join(row)} instead of {', '.join(columns)}")
    if not legal(DEFAULTS | CORES.get(table, {}) | values):
        sys.exit(f"{table}: {','.join(row.values())} is not legal")
    return pairs({column: next(name for name, members in columns[column].items()
                               if value in members) for column, value in values.items()})


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE.parent / "configurations"
    status = 0
    if {file.stem for file in folder.glob("*.csv")} != set(TABLES):
        sys.exit(f"{folder}: tables other than {', '.join(TABLES)}")
    for table in TABLES:
        with open(folder / f"{table}.csv", encoding="ascii") as file:
            rows = list(csv.DictReader(file))
        wanted = legal_pairs(table)
        missing = wanted - set().union(*(row_pairs(table, row) for row in rows))
        print(f"{table}: {len(rows)} rows, {len(wanted) - len(missing)} of {len(wanted)} pairs")
        for (one, its), (other, others) in sorted(missing):
            print(f"  missing: {one} {its} with {other} {others}")
            status = 1
    sys.exit(status)


if __name__ == "__main__":
    main()
