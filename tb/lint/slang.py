#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every module of rtl/ as its own top, and every configuration of the short form, through slang,
which holds to IEEE 1800-2017 where the other tools here are lenient (declared before it is used,
no sign or process changed without a word), as the vendors' front ends do.

    slang.py CELLS.v...     the devices' cells, which slang is to know
"""

import csv
import pathlib
import sys
import tempfile

from pyslang import driver

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
RTL = ROOT / "rtl"


def sources():
    """All of rtl/, packages first."""
    return [RTL / line for line in (RTL / "curvecore.f").read_text().split()
            if line.endswith(".sv")]


def parsed(top, parameters, files, cells=()):
    """slang's driver with `files` read, and whether all of them could be."""
    slang = driver.Driver()
    slang.addStandardArgs()
    words = ["slang", "-Werror", "--timescale", "1ns/1ps", "--top", top]
    words += [f"-G{name}={value}" for name, value in parameters.items()]
    words += [word for cell in cells for word in ("-v", cell)]
    # DSP cells have many open ports; Verilator reports those of our own modules.
    words += ["-Wno-unconnected-input-port", "-Wno-unconnected-output-port"]
    words += ["-DNO_ICE40_DEFAULT_ASSIGNMENTS", *map(str, files)]
    if not (slang.parseCommandLine(" ".join(words)) and slang.processOptions()):
        sys.exit("slang: these options are not taken: " + " ".join(words))
    return slang, slang.parseAllSources()


def clean(top, parameters, files, cells=()):
    """Returns whether `top` elaborates without an error or a warning; slang prints its findings."""
    slang, whole = parsed(top, parameters, files, cells)
    compilation = slang.createCompilation()
    slang.reportCompilation(compilation, True)
    slang.runAnalysis(compilation)
    return slang.reportDiagnostics(True) and whole


def configurations(modules):
    """(top, parameters): the defaults of each module, and the rows of the short form."""
    yield from ((module, {}) for module in modules)
    with open(ROOT / "tb/configurations.csv", newline="") as table:
        for row in csv.DictReader(table):
            bench, form = row.pop("Bench"), row.pop("Form")
            if form == "short" and bench in modules:
                yield bench, {name: value for name, value in row.items() if value != "-"}


def sees_faults():
    """Returns whether a use before the declaration and a changed sign are found."""
    faults = ["module fault; wire a = b; logic b; assign b = 0; endmodule",
              "module taker(input logic signed [3:0] a); endmodule\n"
              "module fault; logic [3:0] a; taker u(.a); endmodule"]
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, "fault.sv")
        for fault in faults:
            source.write_text(fault + "\n")
            if clean("fault", {}, [source]):
                print(f"slang: no word about: {fault}")
                return False
    return True


def main(cells):
    files = sources()
    modules = [source.stem for source in files if not source.stem.endswith("_pkg")]
    red = [f"{top} {parameters or ''}" for top, parameters in configurations(modules)
           if not clean(top, parameters, files, cells)]
    for one in red:
        print("slang refuses", one)
    return bool(red) or not sees_faults()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
