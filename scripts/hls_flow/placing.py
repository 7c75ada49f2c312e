# SPDX-License-Identifier: Apache-2.0
"""The Verilog on a device, and the RTL of the same kernel and configuration beside it."""

import dataclasses
import json

from synthesis.configuration import Configuration, configuration
from synthesis.devices import DEVICES, counts, device_named, speed_of
from synthesis.netlist import synthesise
from synthesis.placement import best
from synthesis.refused import Refused, TooLarge
from synthesis.result import reports
from synthesis.tools import tool


@dataclasses.dataclass
class FileConfiguration(Configuration):
    """A module in a separate Verilog file."""

    file: object = None

    def files(self):
        return [self.file]


def check_device(device):
    """Refuses an unknown device, and the lack of its tools."""
    tool("yosys")
    nextpnr = device_named(device).family.nextpnr
    if nextpnr:
        tool(nextpnr)


def of_verilog(wanted, made, device):
    return FileConfiguration(wanted.name, made.module, device, speed_of(device, None), {}, {},
                             made.file)


def of_rtl(wanted, device):
    return configuration(wanted.kernel.name, "parallel", device, None, wanted.given,
                         wanted.kernel.module)


def counted(config, store):
    """Numbers of cells of a netlist."""
    folder = reports(config, 1, store)[0].parent
    if not (folder / "cells.json").exists():
        synthesise(config, folder)
    cells = json.loads((folder / "cells.json").read_text())
    return {"device": config.device, **counts(DEVICES[config.device].family, cells["core"])}


def placed(config, seeds, store, minutes):
    """Returns frequency and numbers of cells; without seeds, the numbers alone; if placement fails,
    the numbers, `refused`, and whether it has more cells than the device, in which case nextpnr
    is not run."""
    cells = counted(config, store)
    if seeds == 0:
        return cells
    try:
        return best(config, seeds, store, minutes)
    except Refused as error:
        return {"refused": str(error), "too_large": isinstance(error, TooLarge), **cells}
