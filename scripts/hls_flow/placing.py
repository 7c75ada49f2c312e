# SPDX-License-Identifier: Apache-2.0
"""The Verilog on a device, and the RTL of the same kernel and configuration beside it."""

import dataclasses
import json
import os
from concurrent.futures import ThreadPoolExecutor

from synthesis.configuration import Configuration, configuration
from synthesis.devices import DEVICES, counts, device_named, speed_of
from synthesis.netlist import synthesise
from synthesis.placement import place
from synthesis.refused import Refused
from synthesis.result import reports, result
from synthesis.tools import end_all, tool


@dataclasses.dataclass
class FileConfiguration(Configuration):
    """A module of a Verilog file of its own."""

    file: object = None

    def files(self):
        return [self.file]


def check_device(device):
    """Refuses a device that there is not, and the lack of its tools."""
    tool("yosys")
    tool(device_named(device).family.nextpnr)


def of_verilog(wanted, made, device):
    return FileConfiguration(wanted.name, made.module, device, speed_of(device, None), {}, {},
                             made.file)


def of_rtl(wanted, device):
    return configuration(wanted.kernel.name, "parallel", device, None, wanted.given,
                         wanted.kernel.module)


def counted(config, store):
    """Numbers of cells of a netlist."""
    folder = reports(config, 1, store)[0].parent
    synthesise(config, folder)
    cells = json.loads((folder / "cells.json").read_text())
    return {"device": config.device, **counts(DEVICES[config.device].family, cells["core"])}


def placed(config, seeds, store, minutes):
    """Frequency and numbers of cells; where it does not fit, the numbers and `refused`."""
    paths = reports(config, seeds, store)
    found = result(config, paths)
    if found:
        return found
    folder = paths[0].parent
    cells = counted(config, store)
    try:
        with ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
            jobs = [pool.submit(place, config, seed, folder, minutes)
                    for seed in range(1, seeds + 1)]
            try:
                for job in jobs:
                    job.result()
            except KeyboardInterrupt:
                end_all()
                raise
    except Refused as error:
        return {"refused": str(error), **cells}
    (folder / "netlist.json").unlink(missing_ok=True)
    return result(config, paths)
