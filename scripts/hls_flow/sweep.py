# SPDX-License-Identifier: Apache-2.0
"""Tables of kernels: each through HLS and on its device, and the RTL of the same beside it, which
is only counted where the other does not fit."""

import csv
import dataclasses
import io

from hls_flow.kernels import KERNELS, Wanted, parameters_of, wanted
from hls_flow.placing import check_device, counted, of_rtl, placed
from synthesis.refused import Refused
from synthesis.sweep_table import FACTS, number_of_seeds
from synthesis.tools import write_whole

NEEDED = ("core", "device")
OTHERS = ("seeds", "steps", "stages")


@dataclasses.dataclass
class Row:
    line: int
    wanted: Wanted
    device: str
    seeds: int


def check_header(header):
    known = {name for kernel in KERNELS.values() for name in parameters_of(kernel)}
    for name in NEEDED:
        if name not in header:
            raise Refused(f"there is no column '{name}'")
    for name in header:
        if name not in known.union(NEEDED, OTHERS):
            raise Refused(f"unknown column '{name}': {', '.join(NEEDED + OTHERS)} or a parameter"
                          f" ({', '.join(sorted(known))})")


def read_row(header, cells, line, seeds):
    if len(cells) != len(header):
        raise Refused(f"{len(cells)} cells, the header has {len(header)}")
    cell = dict(zip(header, cells))
    given = {name: value for name, value in cell.items()
             if name not in NEEDED + OTHERS and value != ""}
    one = wanted(cell["core"], given, cell.get("steps"), cell.get("stages"))
    check_device(cell["device"])
    return Row(line, one, cell["device"],
               number_of_seeds(cell["seeds"]) if cell.get("seeds") else seeds)


def line_of(row, found, rtl):
    """A line of the results: what was asked for, the pipeline, the RTL."""
    one = row.wanted
    values = {"core": one.kernel.name, "device": row.device, "steps": one.steps,
              "stages": one.stages, "seeds": row.seeds, **one.parameters, **found["simulation"],
              "rtl_clocks": one.kernel.rtl_clocks(one.parameters)}
    for form, facts in (("hls", found["placed"]), ("rtl", rtl)):
        values |= {f"{form}_{fact}": facts.get(fact, "") for fact in (*FACTS, "refused")}
    return values


def write_results(file, lines):
    names = list(dict.fromkeys(name for line in lines for name in line))
    text = io.StringIO()
    table = csv.DictWriter(text, names, restval="", lineterminator="\n")
    table.writeheader()
    table.writerows(lines)
    write_whole(file, text.getvalue())


def sweep(rows, file, do, minutes, store):
    """`do(row)` is what scripts/hls.sh does for one.  The results grow line by line."""
    lines = []
    for row in rows:
        found = do(row)
        twin = of_rtl(row.wanted, row.device)
        rtl = (counted(twin, store) if "refused" in found["placed"] else
               placed(twin, row.seeds, store, minutes))
        lines.append(line_of(row, found, rtl))
        write_results(file, lines)
