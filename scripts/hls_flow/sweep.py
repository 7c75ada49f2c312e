# SPDX-License-Identifier: Apache-2.0
"""Tables of kernels: each through HLS and on its device, and the RTL of the same beside it, which
is only counted where the other does not fit.  Both are only counted where the seeds are 0."""

import dataclasses
import sys

from hls_flow.kernels import KERNELS, Wanted, parameters_of, wanted
from hls_flow.placing import check_device, counted, of_rtl, placed
from hls_flow.simulation import Differs
from synthesis.refused import Refused
from synthesis.sweep_table import FACTS, Kind, failure, write_lines


@dataclasses.dataclass
class Row:
    line: int
    wanted: Wanted
    device: str
    seeds: int


def read_row(line, cell, given, seeds):
    one = wanted(cell["core"], given, cell.get("steps"), cell.get("stages"))
    if one.kernel.header:
        raise Refused(f"core '{one.kernel.name}': a table has no RTL of its own to stand beside")
    check_device(cell["device"])
    return Row(line, one, cell["device"], seeds)


KERNEL_TABLE = Kind(("core", "device"), ("seeds", "steps", "stages"),
                    lambda: [name for one in KERNELS.values() for name in parameters_of(one)],
                    read_row, fewest_seeds=0)


def asked(row):
    one = row.wanted
    return {"core": one.kernel.name, "device": row.device, "steps": one.steps,
            "stages": one.stages, "seeds": row.seeds, **one.parameters, "failed": ""}


def check_placed(found):
    """Raises Refused if the placement failed for another reason than the size."""
    if "refused" in found and not found["too_large"]:
        raise Refused(found["refused"])


def both(row, do, minutes, store):
    """Results for the pipeline and the RTL."""
    found = do(row)
    pipeline = found["placed"]
    check_placed(pipeline)
    twin = of_rtl(row.wanted, row.device)
    rtl = (counted(twin, store) if "refused" in pipeline else
           placed(twin, row.seeds, store, minutes))
    check_placed(rtl)
    values = dict(found["simulation"])
    for form, facts in (("hls", pipeline), ("rtl", rtl)):
        values |= {f"{form}_{fact}": facts.get(fact, "") for fact in (*FACTS, "refused")}
    return values


def sweep(file, rows, table, do, minutes, store):
    """Runs a table; `do(row)` is the work of scripts/hls.sh for one row. The results, in `table`,
    grow row by row; a failed row has the reason. Returns the number of failed rows."""
    lines, failed = [], 0
    for row in rows:
        try:
            lines.append(asked(row) | both(row, do, minutes, store))
        except (Refused, Differs) as error:
            failed += 1
            lines.append(asked(row) | {"failed": str(error)})
            print(failure(file, row, error), file=sys.stderr, flush=True)
        write_lines(table, lines)
    return failed
