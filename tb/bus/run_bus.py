#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A bus port under Icarus, driven by a master that is not of this project:

    run_bus.py axi_lite|wishbone ACCESSES REGISTERS_JSON FOLDER [PORT_SOURCE]

PORT_SOURCE takes the place of rtl/bus/<bus>_port.sv.
"""

import pathlib
import re
import sys

from cocotb_tools.check_results import get_results
from cocotb_tools.runner import get_runner

HERE = pathlib.Path(__file__).resolve().parent
RTL = HERE.parent.parent / "rtl"


def main():
    bus, number, registers, folder = sys.argv[1:5]
    port = sys.argv[5] if len(sys.argv) > 5 else RTL / f"bus/{bus}_port.sv"
    packages = [RTL / "queue/words_pkg.sv", RTL / "bus/registers_pkg.sv"]
    version = re.search(r"int Version = (\d+)", packages[0].read_text())[1]
    runner = get_runner("icarus")
    runner.build(sources=[*packages, RTL / "bus/register_file.sv", port,
                          RTL / "pulse/synchroniser.sv",
                          HERE / "bench_registers.sv", HERE / f"{bus}_bench.sv"],
                 hdl_toplevel=f"{bus}_bench", build_dir=folder, always=True,
                 build_args=["-g2012"], timescale=("1ns", "1ps"))
    results = runner.test(hdl_toplevel=f"{bus}_bench", test_module=f"test_{bus}",
                          build_dir=folder, test_dir=HERE,
                          results_xml=f"{folder}/results.xml",
                          extra_env={"ACCESSES": number, "REGISTERS_JSON": registers,
                                     "WORDS_VERSION": version, "PYTHONPATH": str(HERE)})
    tests, failed = get_results(pathlib.Path(results))
    sys.exit(0 if tests > 0 and failed == 0 else 1)


if __name__ == "__main__":
    main()
