# SPDX-License-Identifier: Apache-2.0
"""Tables of configurations: a sweep's input, and its table of results."""

import csv
import dataclasses
import io
from collections.abc import Callable
from pathlib import Path

from synthesis.command_line import number_of_seeds
from synthesis.configuration import Configuration, configuration
from synthesis.cores import TOPS, parameters
from synthesis.refused import Refused
from synthesis.tools import write_whole

NEEDED = ("core", "build", "device")
OTHERS = ("speed", "seeds", "note")
FACTS = ("fmax_mhz", "lut4", "ff", "dsp", "bram")


@dataclasses.dataclass
class Row:
    line: int
    core: str
    build: str
    seeds: int
    note: str
    wanted: Configuration


@dataclasses.dataclass(frozen=True)
class Kind:
    """A kind of tables: its columns, which may be parameters, too, and what a row becomes."""

    needed: tuple
    others: tuple  # that may be left out
    parameters: Callable  # names
    row: Callable  # of line, cells by name, parameters that are set, seeds
    fewest_seeds: int = 1

    def check_header(self, header):
        known = set(self.parameters())
        for name in self.needed:
            if name not in header:
                raise Refused(f"there is no column '{name}'")
        for name in header:
            if name not in known.union(self.needed, self.others):
                raise Refused(f"unknown column '{name}': {', '.join(self.needed + self.others)} or"
                              f" a parameter ({', '.join(sorted(known))})")
            if header.count(name) > 1:
                raise Refused(f"two columns '{name}'")

    def read_row(self, header, cells, line, seeds):
        if len(cells) != len(header):
            raise Refused(f"{len(cells)} cells, the header has {len(header)}")
        cell = dict(zip(header, cells))
        given = {name: value for name, value in cell.items()
                 if name not in self.needed + self.others and value != ""}
        if cell.get("seeds"):
            seeds = number_of_seeds("seeds", cell["seeds"], self.fewest_seeds)
        return self.row(line, cell, given, seeds)


def read_row(line, cell, given, seeds):
    wanted = configuration(cell["core"], cell["build"], cell["device"], cell.get("speed"), given)
    return Row(line, cell["core"], cell["build"], seeds, cell.get("note", ""), wanted)


CONFIGURATIONS = Kind(NEEDED, OTHERS,
                      lambda: [name for top, _ in TOPS.values() for name in parameters(top)],
                      read_row)


def read_table(file, seeds, kind=CONFIGURATIONS):
    """Rows of a table; `seeds` where it has none.  Raises Refused with a line for every error.

    An empty cell means the default; lines that begin with # and empty lines are comments.
    """
    try:
        text = Path(file).read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "not a text in UTF-8"
        raise Refused(f"{file}: error: {reason}") from None
    header, rows, errors, lines = None, [], [], {}
    for line, one in enumerate(text.splitlines(), start=1):
        if not one.strip() or one.startswith("#"):
            continue
        cells = [cell.strip() for cell in next(csv.reader([one]))]
        try:
            if header is None:
                kind.check_header(cells)
                header = cells
                continue
            row = kind.read_row(header, cells, line, seeds)
            if row.wanted.name in lines:
                raise Refused(f"the same configuration as line {lines[row.wanted.name]}")
            lines[row.wanted.name] = line
            rows.append(row)
        except Refused as error:
            errors.append(f"{file}:{line}: error: {error}")
            if header is None:
                break
    if not errors and not rows:
        errors.append(f"{file}:1: error: no configuration in it")
    if errors:
        raise Refused("\n".join(errors))
    return rows


def failure(file, row, reason):
    """Returns the text of a row without a result."""
    return f"{file}:{row.line}: failed: {row.wanted.name}: {reason}"


def write_lines(file, lines):
    """Writes a table; its columns are the names of the lines, a missing value is an empty cell."""
    text = io.StringIO()
    names = dict.fromkeys(name for line in lines for name in line)
    table = csv.DictWriter(text, names, restval="", lineterminator="\n")
    table.writeheader()
    table.writerows(lines)
    write_whole(file, text.getvalue())


def write_results(file, rows, results, reasons):
    """Returns a line for every row: its result, or the reason why there is none.  `results`,
    `reasons`: by name."""
    named = list(dict.fromkeys(name for row in rows
                               for name in {**parameters(row.wanted.top), **row.wanted.settings}))
    lines = []
    for row in rows:
        name = row.wanted.name
        found = results.get(name)
        settings = found["parameters"] if found else row.wanted.settings
        values = parameters(row.wanted.top) | settings
        asked = (name, row.core, row.build, row.wanted.device, row.wanted.speed, row.seeds,
                 row.note)
        line = dict(zip(("name", *NEEDED, *OTHERS), asked))
        line |= {name: values.get(name, "") for name in named}
        line |= {fact: found[fact] if found else "" for fact in (*FACTS, "fmax_mhz_by_seed",
                                                                  "seconds", "tools")}
        if found:
            line["fmax_mhz_by_seed"] = " ".join(map(str, found["fmax_mhz_by_seed"]))
            line["tools"] = "; ".join(found["tools"])
        lines.append(line | {"failed": reasons.get(name, "")})
    write_lines(file, lines)
