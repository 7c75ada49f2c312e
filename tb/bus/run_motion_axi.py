#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A short program by `curvecore words`, through motion_axi under Icarus:

    run_motion_axi.py CURVECORE REGISTERS_JSON FOLDER [SOURCE]

SOURCE replaces the file of rtl with its name.
"""

import pathlib
import subprocess
import sys

from cocotb_tools.check_results import get_results
from cocotb_tools.runner import get_runner

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "scripts"))
from synthesis.cores import sources  # noqa: E402

END = (0.02, 0.01, -0.01)
PROGRAM = f"G21 G90 G61 F1800\nG3 X0.01 Y0.01 I0 J0.01\nG1 X{END[0]} Y{END[1]} Z{END[2]}\nM2\n"


def main():
    curvecore, registers, folder = sys.argv[1:4]
    part = pathlib.Path(folder) / "part.ngc"
    part.write_text(PROGRAM, encoding="ascii")
    words = pathlib.Path(folder) / "words"
    subprocess.run([curvecore, "words", part, "-q", "-o", words, "--set",
                    "Splines=1", "--set", "Mode=1", "--set", "SampleInterval=8", "--clock",
                    "2.56MHz", "--segment-queue", "1024", "--profile-queue", "512"], check=True)
    other = [pathlib.Path(file) for file in sys.argv[4:]]
    files = [file for file in sources("motion_axi") if file.name not in {o.name for o in other}]
    runner = get_runner("icarus")
    runner.build(sources=[*files, *other, HERE / "motion_axi_bench.sv"],
                 hdl_toplevel="motion_axi_bench", build_dir=folder, always=True,
                 build_args=["-g2012"], timescale=("1ns", "1ps"))
    results = runner.test(hdl_toplevel="motion_axi_bench", test_module="test_motion_axi",
                          build_dir=folder, test_dir=HERE, results_xml=f"{folder}/results.xml",
                          extra_env={"REGISTERS_JSON": registers, "WORDS": str(words),
                                     "END": " ".join(map(str, END)), "PYTHONPATH": str(HERE)})
    tests, failed = get_results(pathlib.Path(results))
    sys.exit(0 if tests > 0 and failed == 0 else 1)


if __name__ == "__main__":
    main()
