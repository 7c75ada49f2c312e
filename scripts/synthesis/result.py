# SPDX-License-Identifier: Apache-2.0
"""Result of a configuration: the best of its seeds."""

import json
from pathlib import Path

from synthesis.devices import DEVICES, counts


def reports(wanted, seeds, store):
    """Returns the path of each seed's report, which need not exist; one if nothing is placed."""
    folder = Path(store) / wanted.netlist_name()
    if not wanted.family.nextpnr:
        return [folder / f"{wanted.placement_name(1)}.json"]
    return [folder / f"{wanted.placement_name(seed)}.json" for seed in range(1, seeds + 1)]


def result(wanted, paths):
    """Makes the result from the reports of some seeds; None if one is missing."""
    if not all(path.exists() for path in paths):
        return None
    found = [json.loads(path.read_text()) for path in paths]
    reached = [round(report["fmax_mhz"], 1) for report in found if report["fmax_mhz"]]
    cells = found[0]["cells"]
    number = counts(wanted.family, cells["core"])
    limit = DEVICES[wanted.device].dsp_limit
    best = max(reached, default=None)
    return {
        "fmax_mhz": min(best, limit) if number["dsp"] and limit else best,
        **number,
        "seeds": len(reached),
        "fmax_mhz_by_seed": reached,
        "device": wanted.device,
        "speed": wanted.speed,
        "parameters": cells["parameters"],
        "cells": cells["core"],
        "seconds": round(sum(report["seconds"] for report in found), 1),
        "tools": found[0]["tools"],
    }


def sentence(found):
    if not found["fmax_mhz"]:
        return f"not placed, {cells_of(found)}"
    return f"{found['fmax_mhz']} MHz (best of {found['seeds']}), {cells_of(found)}"


def cells_of(found):
    device = DEVICES.get(found.get("device"))  # a board's are all of LUT4
    lut = device.family.lut_name if device else "LUT4"
    return f"{found['lut4']} {lut}, {found['ff']} FF, {found['dsp']} DSP, {found['bram']} RAM"
