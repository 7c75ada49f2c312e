#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""fork_test.py: fork_bench.py under Icarus, on the RTL as it is and with a sign changed."""

import os
import pathlib
import shutil
import sys
import tempfile

import curvecore
from cocotb_tools.check_results import get_results
from cocotb_tools.runner import get_runner

HERE = pathlib.Path(__file__).resolve().parent
PART = "G21 G90 F900\nG1 X1\nG3 X2 Y1 I0 J1\nG5 X4 Y3 I1 J0 P-1 Q0\nM2\n"


def failed(sources, folder):
    """Tests of the bench, and those that fail."""
    runner = get_runner("icarus")
    runner.build(sources=sources, hdl_toplevel="motion_interpolator", build_dir=folder,
                 always=True, build_args=["-g2012"], timescale=("1ns", "1ps"),
                 parameters={"Order": 2, "CoefBits": 18, "Splines": 1})
    results = runner.test(hdl_toplevel="motion_interpolator", test_module="fork_bench",
                          build_dir=folder, test_dir=HERE, results_xml=f"{folder}/results.xml",
                          extra_env={"PART": str(folder / "part.ngc"),
                                     "PYTHONPATH": os.pathsep.join([*sys.path, str(HERE)])})
    return get_results(pathlib.Path(results))


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "part.ngc").write_text(PART, encoding="ascii")
        sources = curvecore.rtl_files()
        if failed(sources, folder) != (2, 0):
            sys.exit("the RTL is not what the kernel is")
        fork = folder / "fine_scale.sv"
        at = next(n for n, file in enumerate(sources) if file.name == fork.name)
        shutil.copy(sources[at], fork)
        text = fork.read_text()
        fork.write_text(text.replace("{d_i, ", "{-d_i, "))
        if failed([*sources[:at], fork, *sources[at + 1:]], folder) != (2, 2):
            sys.exit("a changed sign is not seen")
    print("a fork is held to the kernel")


if __name__ == "__main__":
    main()
