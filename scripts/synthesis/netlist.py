# SPDX-License-Identifier: Apache-2.0
"""Netlist of core and harness by Yosys, and the cells of the core."""

import json
import os
import pathlib
import re
import shutil

from synthesis import microcode
from synthesis.cores import ROOT
from synthesis.harness import harness
from synthesis.tools import alone, error_of, run, tool, work_folder, write_whole


def number(value):
    """Converts an integer, which Yosys writes as a string of 32 bits."""
    if isinstance(value, str) and set(value) <= {"0", "1"}:
        return int(value, 2) - ((1 << len(value)) if value[0] == "1" else 0)
    return value


def explain(lines):
    """Yosys stops at a core's own refusal without its words: these stand in the source."""
    error = error_of(lines)
    refusal = re.match(r"(\S+):(\d+): ERROR: ?Can't resolve task name `\$fatal'", error)
    if refusal:
        line = (ROOT / refusal[1]).read_text().splitlines()[int(refusal[2]) - 1]
        error = f"{refusal[1]}:{refusal[2]}: " + line.split('"')[1]
    return f"synthesis failed: {error}"


class Yosys:
    """Yosys in a folder that has a copy of all it reads: names stay short, the YoWASP build sees
    no other folder, and what is changed meanwhile does no harm."""

    def __init__(self, files, family, folder):
        self.folder = folder
        self.paths = [file.relative_to(ROOT) if file.is_relative_to(ROOT)
                      else pathlib.Path(file.name) for file in files]
        for file, path in zip(files, self.paths):
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, folder / path)
        for file in family.files:
            shutil.copy(file, folder)

    def __call__(self, log, *commands):
        read = ["read_verilog -sv -defer " + " ".join(map(str, self.paths))] if self.paths else []
        run([tool("yosys"), "-p", "; ".join([*read, *commands])], log, explain, cwd=self.folder)

    def elaborate(self, core, log):
        """Elaborates the core alone; returns its ports and parameters."""
        (self.folder / "probe.v").write_text(f"module probe;\n  {core} dut ();\nendmodule\n")
        self(log, "read_verilog probe.v", "hierarchy -top probe", "proc", "write_json probe.json")
        modules = json.loads((self.folder / "probe.json").read_text())["modules"]
        module = modules[modules["probe"]["cells"]["dut"]["type"]]
        return module["ports"], module.get("parameter_default_values", {})

    def synthesise(self, family, log):
        """Writes netlist.json of harness.v; returns cells by type, of the core and of all."""
        commands = [command.format(netlist="netlist.json") for command in family.yosys]
        self(log, "read_verilog harness.v", *commands, "tee -o stat.json stat -json")
        netlist = json.loads((self.folder / "netlist.json").read_text())["modules"]
        core = netlist["harness"]["cells"]["dut"]["type"]
        found = json.loads((self.folder / "stat.json").read_text())
        name = core if core.startswith("$") else "\\" + core
        return (found["modules"][name]["num_cells_by_type"], found["design"]["num_cells_by_type"])


def synthesise(wanted, folder):
    """Writes netlist.json and cells.json of a configuration, into its folder of the store."""
    folder.mkdir(parents=True, exist_ok=True)
    with alone(folder / ".lock"), work_folder(folder / ".work") as work:
        if (folder / "netlist.json").exists():
            return
        yosys = Yosys(wanted.files(), wanted.family, work)
        settings = microcode.make(wanted.top, wanted.settings, work, folder / "microcode.log")
        values = ", ".join(f".{name}({value})" for name, value in settings.items())
        core = f"{wanted.top} #({values})"
        ports, parameters = yosys.elaborate(core, folder / "elaborate.log")
        (work / "harness.v").write_text(harness(core, ports))
        core_cells, all_cells = yosys.synthesise(wanted.family, folder / "synthesise.log")
        parameters = {name: number(value) for name, value in parameters.items()
                      if name not in microcode.FILES}
        parameters |= {name: int(value) for name, value in wanted.settings.items()}
        write_whole(folder / "cells.json", json.dumps(
            {"core": core_cells, "all": all_cells, "parameters": parameters}, indent=2))
        os.replace(work / "netlist.json", folder / "netlist.json")
