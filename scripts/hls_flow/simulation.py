# SPDX-License-Identifier: Apache-2.0
"""The Verilog in Verilator, against the native kernel: tb/hls."""

import json
import shutil
import subprocess

from synthesis.cores import ROOT
from synthesis.refused import Refused
from synthesis.tools import error_of, run, tool


class Differs(Exception):
    """The Verilog differs from the kernel."""

    def __init__(self, where):
        super().__init__(f"the Verilog is not what the kernel is: {where}")


def simulate(made, wanted, samples, folder):
    """Returns samples, words, differing words (0), latency in clocks, clocks of the RTL for a call;
    raises Differs."""
    bench = ROOT / "tb/hls" / f"{wanted.kernel.top}_bench.cpp"
    # -MP: a header that is gone since the folder's last build is no reason to stop.
    flags = ["-std=c++17", "-MP", "-I" + str(ROOT), *wanted.definitions()]
    if wanted.kernel.header:
        flags.append("-DCURVECORE_CHECKED")  # random words show which keep their ranges
    cache = ["OBJCACHE=ccache"] if shutil.which("ccache") else []
    run([tool("verilator"), "--cc", "--exe", "--build", "-j", "2", "-O3", "-Wno-lint",
         "--x-assign", "fast", "--x-initial", "unique", "--prefix", "Vhls", "--top-module",
         made.module, "--Mdir", str(folder / "model"), "-o", "bench", "-CFLAGS", " ".join(flags),
         "-MAKEFLAGS", " ".join(["OPT_FAST=-O1", "OPT_SLOW=-O0", "OPT_GLOBAL=-O1", *cache]),
         str(made.file), str(bench)],
        folder / "verilator.log", lambda lines: f"the bench does not build: {error_of(lines)}")
    done = subprocess.run([folder / "model" / "bench", str(samples)], capture_output=True,
                          text=True)
    if done.returncode not in (0, 1):
        raise Refused(f"the bench ended with status {done.returncode}: {done.stderr.strip()}")
    if done.returncode == 1:
        raise Differs((done.stderr.strip() or done.stdout.strip()).splitlines()[0])
    return json.loads(done.stdout)
