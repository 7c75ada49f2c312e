#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A bus port under Icarus, driven by a master from another project:

    run_bus.py BUS ACCESSES REGISTERS_JSON FOLDER [PORT_SOURCE]

BUS is one of FILES. PORT_SOURCE replaces the file of its bus.
"""

import pathlib
import re
import sys

from cocotb_tools.check_results import get_results
from cocotb_tools.runner import get_runner

HERE = pathlib.Path(__file__).resolve().parent
RTL = HERE.parent.parent / "rtl"
PACKAGES = ["queue/words_pkg.sv", "bus/registers_pkg.sv", "line/slip_pkg.sv"]
SYNCHRONISER = "pulse/synchroniser.sv"
FRAMES = ["line/serial_crc.sv", "line/slip_receiver.sv", "line/slip_sender.sv",
          "line/frame_buffer.sv", "line/frame_port.sv"]
FILES = {
    "axi_lite": ["bus/axi_lite_port.sv"],
    "axi_stream": ["bus/word_sources.sv"],
    "wishbone": ["bus/wishbone_port.sv"],
    "spi": ["bus/spi_port.sv", SYNCHRONISER],
    "uart": ["line/frame_reader.sv", *FRAMES, "line/uart_line.sv", SYNCHRONISER],
    "spi_line": ["line/spi_line.sv", *FRAMES, "line/frame_reader.sv", SYNCHRONISER],
}


def main():
    bus, number, registers, folder = sys.argv[1:5]
    first = FILES[bus][0]
    port = sys.argv[5] if len(sys.argv) > 5 else RTL / first
    frames = FRAMES[0] in FILES[bus]
    packages = [RTL / file for file in PACKAGES]
    version = re.search(r"int Version = (\d+)", packages[0].read_text())[1]
    runner = get_runner("icarus")
    benches = ["bench_registers", *(["bench_frames"] if frames else []), f"{bus}_bench"]
    runner.build(sources=[*packages, *(RTL / file for file in FILES[bus][1:]),
                          port, RTL / "bus/register_file.sv",
                          *(HERE / f"{bench}.sv" for bench in benches)],
                 hdl_toplevel=f"{bus}_bench", build_dir=folder, always=True,
                 build_args=["-g2012"], timescale=("1ns", "1ps"))
    results = runner.test(hdl_toplevel=f"{bus}_bench",
                          test_module="test_frames" if frames else f"test_{bus}",
                          build_dir=folder, test_dir=HERE,
                          results_xml=f"{folder}/results.xml",
                          extra_env={"ACCESSES": number, "REGISTERS_JSON": registers,
                                     "WORDS_VERSION": version, "PYTHONPATH": str(HERE)})
    tests, failed = get_results(pathlib.Path(results))
    sys.exit(0 if tests > 0 and failed == 0 else 1)


if __name__ == "__main__":
    main()
