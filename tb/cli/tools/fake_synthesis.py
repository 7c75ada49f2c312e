#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Stand-in for Yosys and nextpnr in the tests of scripts/synth.py, and for clang and Verilator in
those of scripts/hls.py: quick, and fails on demand.

    fake_synthesis.py NAME ARGUMENTS..     writes what the tool NAME would write

FAKE_LOG: a file that gets a line for every run but --version.  FAKE_GATE: a file; the placement of
a core of Order 5 waits until it is there.  sbatch runs what it is given.  A core of Order 8 refuses
its parameters, one of 9 is not synthesised, one of 10 cannot be routed, one of 11 has a million
LUTs, one of 12 is too much for nextpnr.  Of kernels, clang does not take one of Order 7, and
Verilator's model of one of Order 3 is wrong.
"""

import json
import os
import re
import subprocess
import sys
import time
from pathlib import Path


def order_of(text):
    return int((re.search(r"\.Order\((\d+)\)", text) or ["", "6"])[1])


def board_netlist():
    """Stands in for the tools of synth.sh --board."""
    Path("netlist.json").write_text(json.dumps({"order": order_of(Path("top.v").read_text())}))
    Path("stat.json").write_text(json.dumps({"design": {"num_cells_by_type": {
        "LUT4": 600, "TRELLIS_FF": 50}}}))


def yosys(arguments):
    script = arguments[1]
    if Path("top.v").exists():
        return board_netlist()
    if "probe.json" in script and ".Order(8)" in Path("probe.v").read_text():
        file = "rtl/curve_interpolator_serial.sv"
        line = next(number for number, text in enumerate(Path(file).read_text().splitlines(), 1)
                    if "Order must be" in text)
        sys.exit(f"{file}:{line}: ERROR: Can't resolve task name `$fatal'.")
    if "probe.json" in script:
        ports = {"clk_i": "input", "data_i": "input", "data_o": "output"}
        module = {"ports": {name: {"direction": way, "bits": [2]} for name, way in ports.items()},
                  "parameter_default_values": {
                      "Order": f"{order_of(Path('probe.v').read_text()):032b}"}}
        cells = {"cells": {"dut": {"type": "core"}}}
        Path("probe.json").write_text(json.dumps({"modules": {"probe": cells, "core": module}}))
        return
    order = order_of(Path("harness.v").read_text())
    if order == 9:
        sys.exit("ERROR: syntax error, unexpected TOK_ID")
    luts = 1_000_000 if order == 11 else 100 * order
    cells = {"LUT4": luts, "TRELLIS_FF": 50, "MULT18X18D": 4, "DP16KD": 2}
    Path("netlist.json").write_text(json.dumps(
        {"modules": {"harness": {"cells": {"dut": {"type": "core"}}}}, "order": order}))
    Path("stat.json").write_text(json.dumps(
        {"modules": {"\\core": {"num_cells_by_type": cells}}, "design": {
            "num_cells_by_type": cells}}))


def nextpnr(arguments):
    order = json.loads(Path("netlist.json").read_text())["order"]
    Path("report.json").write_text("{")
    while order == 5 and not Path(os.environ["FAKE_GATE"]).exists():
        time.sleep(0.05)
    if order == 10:
        print("Info: \t GND: 1/1 100%\nInfo: \t TRELLIS_COMB: 24000/24288 98%", flush=True)
        sys.exit("ERROR: Routing design failed.\n0 warnings, 1 error")
    if order == 12:
        print("Info: Device utilisation:\nInfo: \t TRELLIS_IO: 13/197 6%\n"
              "Info: \t TRELLIS_COMB: 30000/24288 123%")
        sys.exit("ERROR: Unable to place cell 'dut.x', no Bels remaining of type 'TRELLIS_COMB'\n"
                 "ERROR: Placing design failed.\n0 warnings, 2 errors")
    seed = int(arguments[arguments.index("--seed") + 1])
    asked = float(arguments[arguments.index("--freq") + 1])
    if name == "nextpnr-ecp5" and Path("pll.v").exists():
        asked = float(Path("pll.v").read_text())
    reached = (200 if name.endswith("gowin") else 100) + seed
    Path("report.json").write_text(json.dumps(
        {"fmax": {"clk": {"achieved": reached, "constraint": asked}}}))


def pack(arguments):
    named = arguments.index("-o") + 1 if "-o" in arguments else -1
    Path(arguments[named]).write_text("bits")


def ecppll(arguments):
    """Rounds to multiples of 2.5 MHz."""
    Path(arguments[-1]).write_text(str(float(arguments[arguments.index("-o") + 1]) // 2.5 * 2.5))


def other_pll(arguments):
    made = float(arguments[arguments.index("-o") + 1]) // 0.5 * 0.5
    Path(arguments[-1]).write_text(f" * Achieved output frequency:        {made:.3f} MHz\n")


def clang(arguments):
    source, result = arguments[-3], Path(arguments[-1])
    if "-DCFG_Order=7" in arguments:
        sys.exit(f"{source}:1:1: error: no number")
    result.write_text("define void @sine_cosine_hls(i18* %a, i18* %b) #0 {\n"
                      "  %1 = load i18, i18* %a\n  store i18 %1, i18* %b\n"
                      "  ret void\n}\n")


def verilator(arguments):
    wrong = any("-DCFG_Order=3 " in flags for flags in arguments)
    bench = Path(arguments[arguments.index("--Mdir") + 1]) / "bench"
    bench.parent.mkdir(exist_ok=True)
    found = json.dumps({"samples": 5, "words": 9, "latency": 2, "rtl_clocks": 7})
    bench.write_text("#!/bin/sh\necho sample 0: word 0 is 1 >&2\nexit 1\n" if wrong else
                     f"#!/bin/sh\necho '{found}'\n")
    bench.chmod(0o755)


name, arguments = sys.argv[1], sys.argv[2:]
if arguments == ["--version"]:
    print("Yosys 0.1" if name == "yosys" else "nextpnr-0.1")
else:
    with open(os.environ["FAKE_LOG"], "a") as log:
        log.write(f"{name}\n")
    if name == "sbatch":
        sys.exit(subprocess.run(["/bin/sh", arguments[-1]]).returncode)
    tools = {"yosys": yosys, "ecppack": pack, "icepack": pack,
             "gowin_pack": pack, "ecppll": ecppll, "icepll": other_pll, "gowin_pll": other_pll,
             "clang++-14": clang, "verilator": verilator}
    tools.get(name, nextpnr)(arguments)
