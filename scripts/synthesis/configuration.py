# SPDX-License-Identifier: Apache-2.0
"""A configuration to place and route, and the names under which its parts are stored.

A name ends in a digest of all inputs of the part (sources, settings, tools): the store is never
stale, and work on other sources removes nothing from it.
"""

import dataclasses
import hashlib
import json

from synthesis import microcode
from synthesis.cores import FORMS, check_parameters, parameters, sources, top_of
from synthesis.devices import DEVICES, HERE, device_named, speed_of
from synthesis.tools import tool, version


def digest(*parts):
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()[:10]


def digest_of(paths):
    return digest([(path.name, hashlib.sha256(path.read_bytes()).hexdigest()) for path in paths])


@dataclasses.dataclass
class Configuration:
    label: str  # core-build, or the module
    top: str
    device: str
    speed: int | None
    given: dict  # parameters as the user set them
    settings: dict  # with those of the build and the device

    @property
    def family(self):
        return DEVICES[self.device].family

    def files(self):
        return sources(self.top)

    @property
    def name(self):
        default = next(iter(DEVICES[self.device].speeds), None)
        speed = [] if self.speed == default else [f"speed{self.speed}"]
        values = [f"{name}{value}" for name, value in sorted(self.given.items())]
        return "-".join([self.label, self.device, *speed, *values])

    def netlist_name(self):
        """Folder in the store.  Raises Refused where a tool is missing."""
        made = digest(self.top, self.settings, self.family.yosys,
                      digest_of([*self.files(), *microcode.sources(self.top, self.settings),
                                 HERE / "harness.py", *self.family.files]),
                      version(tool("yosys")))
        return f"{self.label}-{self.family.name}-{made}"

    def placement_name(self, seed):
        """File in the folder, without .json."""
        if not self.family.nextpnr:
            return f"{self.device}-cells-seed{seed}"  # its netlist is all there is
        pins = DEVICES[self.device].pins
        made = digest(self.nextpnr_flags(), version(tool(self.family.nextpnr)),
                      digest_of([pins] if pins else []))
        speed = f"-{self.speed}" if self.speed else ""
        return f"{self.device}{speed}-{made}-seed{seed}"

    def nextpnr_flags(self):
        device = DEVICES[self.device]
        pins = device.pins and device.pins.name
        flags = [flag.format(speed=self.speed, pins=pins) for flag in device.flags]
        return [*flags, "--freq", str(device.family.freq)]


def configuration(core, build, device, speed, given, top=None):
    """Checks all that can be known before a tool runs; raises Refused."""
    label, (module, settings) = (top, (top, {})) if top else (
        f"{core}-{build}", top_of(core, build))
    form = device_named(device).form
    speed = speed_of(device, speed)
    settings = settings | given
    for name in FORMS:
        if name in parameters(module):
            settings = {name: str(form)} | settings
    check_parameters(module, settings)
    return Configuration(label, module, device, speed, dict(given), settings)
