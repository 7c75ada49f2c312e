# SPDX-License-Identifier: Apache-2.0
"""Tables of configurations: what a sweep reads, and the table of results that it writes."""

import csv
import dataclasses
import io
from pathlib import Path

from synthesis.configuration import Configuration, configuration
from synthesis.cores import CORES, TOPS, parameters
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


def number_of_seeds(text):
    if not text.isdecimal() or not 1 <= int(text) <= 100:
        raise Refused(f"seeds '{text}' must be in [1, 100]")
    return int(text)


def check_header(header):
    known = {name for core in CORES for (other, _), (top, _) in TOPS.items() if other == core
             for name in parameters(top)}
    for name in NEEDED:
        if name not in header:
            raise Refused(f"there is no column '{name}'")
    for name in header:
        if name not in known.union(NEEDED, OTHERS):
            raise Refused(f"unknown column '{name}': {', '.join(NEEDED + OTHERS)} or a parameter"
                          f" ({', '.join(sorted(known))})")
        if header.count(name) > 1:
            raise Refused(f"two columns '{name}'")


def read_row(header, cells, line, seeds):
    if len(cells) != len(header):
        raise Refused(f"{len(cells)} cells, the header has {len(header)}")
    cell = dict(zip(header, cells))
    given = {name: value for name, value in cell.items()
             if name not in NEEDED + OTHERS and value != ""}
    wanted = configuration(cell["core"], cell["build"], cell["device"], cell.get("speed"), given)
    return Row(line, cell["core"], cell["build"],
               number_of_seeds(cell["seeds"]) if cell.get("seeds") else seeds,
               cell.get("note", ""), wanted)


def read_table(file, seeds, check_header=check_header, read_row=read_row):
    """Rows of a table; `seeds` where it has none.  Raises Refused with a line for every error.
    Another kind of table has a `check_header` and a `read_row` of its own.

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
                check_header(cells)
                header = cells
                continue
            row = read_row(header, cells, line, seeds)
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


def write_results(file, rows, results, reasons):
    """A line for every row: what was found, or why there is nothing.  `results`, `reasons`: by
    name."""
    named = list(dict.fromkeys(name for row in rows
                               for name in {**parameters(row.wanted.top), **row.wanted.settings}))
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["name", *NEEDED, *OTHERS, *named, *FACTS, "fmax_mhz_by_seed", "seconds",
                    "tools", "failed"])
    for row in rows:
        name = row.wanted.name
        found = results.get(name)
        settings = found["parameters"] if found else row.wanted.settings
        values = parameters(row.wanted.top) | settings
        facts = [found[fact] for fact in FACTS] + [
            " ".join(map(str, found["fmax_mhz_by_seed"])), found["seconds"],
            "; ".join(found["tools"])] if found else [""] * (len(FACTS) + 3)
        table.writerow([name, row.core, row.build, row.wanted.device, row.wanted.speed, row.seeds,
                        row.note, *(values.get(name, "") for name in named), *facts,
                        reasons.get(name, "")])
    write_whole(file, text.getvalue())
