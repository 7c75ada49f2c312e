# SPDX-License-Identifier: Apache-2.0
"""Place and route of a netlist: a device, a speed grade, a seed; the best of several."""

import json
import os
import re
import shutil
import time
from concurrent.futures import ThreadPoolExecutor

from synthesis.devices import DEVICES, check_fit
from synthesis.netlist import synthesise
from synthesis.refused import Refused
from synthesis.result import reports, result
from synthesis.tools import (alone, end_all, error_of, run, tool, version, work_folder,
                             write_whole)


def explain(lines):
    """Names the user's remedy: another device, or another seed."""
    error = error_of(lines)
    if re.search(r"no bels|[Uu]nable to (find|place)|[Ff]ailed to place|too many", error, re.I):
        return f"does not fit: {error}"
    if re.search(r"\brout", error, re.I):
        return f"unroutable: {error}"
    return f"nextpnr failed: {error}"


def frequency(family, report, log):
    """Returns MHz of the slowest path that nextpnr times; the lower of before and after routing if
    it leaves out nets after routing."""
    reached = [clock["achieved"] for clock in report["fmax"].values()]
    if not family.routed_timing:
        reached += [float(mhz) for mhz in re.findall(r"Max frequency for clock .*: ([\d.]+) MHz",
                                                     log.read_text(errors="replace"))]
    if not reached:
        raise Refused(f"nextpnr timed no path, see {log}")
    return max(reached) if family.routed_timing else min(reached)


def run_nextpnr(wanted, seed, work, log, minutes):
    """Places work/netlist.json; its clock and what it takes of the device."""
    pins = DEVICES[wanted.device].pins
    if pins:
        shutil.copy(pins, work)
    run([tool(wanted.family.nextpnr), "--json", "netlist.json", *wanted.nextpnr_flags(),
         "--timing-allow-fail", "--seed", str(seed), "--report", "report.json"], log, explain,
        minutes=minutes, cwd=work)
    report = json.loads((work / "report.json").read_text())
    return {"fmax_mhz": frequency(wanted.family, report, log),
            "utilization": report.get("utilization", {})}


def place(wanted, seed, folder, minutes):
    """Writes the report of a placement, including all that is needed of the netlist.

    The netlist must exist; an existing report is kept.  Without place and route for the device
    its cells are counted alone.
    """
    name = wanted.placement_name(seed)
    with alone(folder / f".{name}.lock"), work_folder(folder / f".{name}.work") as work:
        if (folder / f"{name}.json").exists():
            return
        cells = json.loads((folder / "cells.json").read_text())
        check_fit(wanted.device, cells["all"])
        yosys = version(tool("yosys"))
        begin = time.monotonic()
        if wanted.family.nextpnr:
            (work / "netlist.json").hardlink_to(folder / "netlist.json")
            found = run_nextpnr(wanted, seed, work, folder / f"{name}.log", minutes)
            tools = [yosys, version(tool(wanted.family.nextpnr))]
        else:
            found, tools = {"fmax_mhz": None, "utilization": {}}, [yosys]
        write_whole(folder / f"{name}.json", json.dumps({
            **found,
            "seconds": round(time.monotonic() - begin, 1),
            "cells": cells,
            "tools": tools,
        }, indent=2) + "\n")


def best(wanted, seeds, store, minutes):
    """Returns the result of some seeds; placements in the store are not repeated."""
    paths = reports(wanted, seeds, store)
    found = result(wanted, paths)
    if found:
        return found
    folder = paths[0].parent
    synthesise(wanted, folder)
    with ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        jobs = [pool.submit(place, wanted, seed, folder, minutes) for seed in range(1, seeds + 1)]
        try:
            for job in jobs:
                job.result()
        except KeyboardInterrupt:
            end_all()
            raise
    (folder / "netlist.json").unlink(missing_ok=True)
    return result(wanted, paths)
