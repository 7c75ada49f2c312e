# SPDX-License-Identifier: Apache-2.0
"""The jobs of a sweep, for the Snakefile and its jobs."""

import dataclasses
import json
from pathlib import Path

from synthesis.configuration import Configuration
from synthesis.result import reports


def targets(row, store):
    """Names of the row's jobs: of its netlist, and of the placement of each seed."""
    netlist = row.wanted.netlist_name()
    return netlist, [f"{netlist}/{path.stem}" for path in reports(row.wanted, row.seeds, store)]


def write_plan(file, rows, store, minutes):
    """Returns each target with its configuration."""
    plan = {"minutes": minutes, "netlists": {}, "placements": {}}
    for row in rows:
        wanted = dataclasses.asdict(row.wanted)
        netlist, placements = targets(row, store)
        plan["netlists"][netlist] = {"configuration": wanted}
        for seed, placement in enumerate(placements, start=1):
            plan["placements"][placement] = {"configuration": wanted, "seed": seed}
    Path(file).write_text(json.dumps(plan, indent=2))


def configuration_from(fields):
    return Configuration(**fields)


def reason_file(store, target):
    return Path(store) / f"{target}.reason"
