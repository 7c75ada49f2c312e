# SPDX-License-Identifier: Apache-2.0
"""A kernel of hls/ through clang and XLS to Verilog, which is simulated against the kernel.

    scripts/hls.sh --core spherical --set Order=4 --set CoefBits=18           the Verilog, simulated
    scripts/hls.sh --core spherical --set CoefBits=18 --device ecp5-45        placed, too
    scripts/hls.sh --core clothoid --set Order=4               the curve of a table in ref/curves
    scripts/hls.sh --core wave.net --set Order=4               .. of your own (curvecore curve)
    scripts/hls.sh --sweep scripts/sweeps/hls.csv                             a table of them

One writes build/hls/<core>.json and .v, with the parameters in the name where these are not the
default: a pipeline that takes a call at every clock (hls/README.md).
A table is done on its devices, with the RTL of the same kernel and configuration beside it, and
becomes build/hls/<table>.csv; what fails has the reason there, and the others are done. What has
0 seeds is only counted.

Exit status: 0, 1 where a word differs or something cannot be placed, 2 where the input is wrong, a
tool is missing or the kernel cannot be taken.
"""

import argparse
import json
import os
import signal
import sys
from pathlib import Path

from hls_flow.kernels import KERNELS, wanted
from hls_flow.placing import check_device, of_verilog, placed
from hls_flow.simulation import Differs, simulate
from hls_flow.sweep import KERNEL_TABLE, sweep
from hls_flow.verilog import make
from synthesis.command_line import Parser, number, number_of_seeds, settings
from synthesis.cores import ROOT
from synthesis.devices import DEVICES
from synthesis.refused import Refused
from synthesis.result import cells_of, sentence
from synthesis.sweep_table import read_table
from synthesis.tools import alone, write_whole


def arguments():
    parser = Parser(prog="hls.sh", description=__doc__,
                    formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--core", metavar="CORE", help=", ".join(KERNELS) +
                        "; a table of ref/curves by its name, or FILE.net")
    parser.add_argument("--set", action="append", default=[], metavar="Name=Value",
                        help="a parameter of the core")
    parser.add_argument("--steps", metavar="N", help="integration steps from the start"
                        " (0; 1 of splines)")
    parser.add_argument("--stages", metavar="N", help="of the pipeline (20; 60 of splines)")
    parser.add_argument("--samples", default="1000000", metavar="N",
                        help="calls to simulate (1000000)")
    parser.add_argument("--device", metavar="DEVICE", help=", ".join(DEVICES))
    parser.add_argument("--seeds", default="3", metavar="N", help="the best of N (3)")
    parser.add_argument("--sweep", metavar="FILE", help="a table of kernels (.csv)")
    parser.add_argument("--minutes", type=float, default=180, metavar="N",
                        help="give up a placement after so long (180)")
    parser.add_argument("--output", metavar="DIR", default=ROOT / "build" / "hls",
                        help="folder of results (build/hls)")
    return parser.parse_args()


def say(text):
    """Shows the present step, on a terminal."""
    if sys.stderr.isatty():
        print(f"hls: {text}", file=sys.stderr, flush=True)


def done(one, samples, device, seeds, minutes, output):
    """Returns all results for a kernel; writes them and its Verilog."""
    folder = output / "work" / one.name
    folder.mkdir(parents=True, exist_ok=True)
    with alone(folder / ".lock"):
        say(f"{one.name}: clang and XLS")
        made = make(one, folder)
        say(f"{one.name}: {samples} samples in Verilator")
        found = {
            "core": one.kernel.name,
            "parameters": one.parameters,
            "steps": one.steps,
            "stages": one.stages,
            "module": made.module,
            "products": made.products,
            "inputs": [vars(port) for port in made.inputs],
            "outputs": [vars(port) for port in made.outputs],
            "tools": made.tools,
            "simulation": simulate(made, one, samples, folder),
        }
        if device:
            say(f"{one.name}: {device}")
            found["placed"] = placed(of_verilog(one, made, device), seeds, output / "store",
                                     minutes)
        write_whole(output / f"{one.name}.v", made.file.read_text())
        write_whole(output / f"{one.name}.json", json.dumps(found, indent=2) + "\n")
    return found


def report(one, found, output):
    """Returns the exit status."""
    bench = found["simulation"]
    path = os.path.relpath(output / f"{one.name}.json")
    print(f"{one.name}: {bench['samples']} samples, {bench['words']} words, 0 differ; "
          f"latency {bench['latency']}, a sample per clock; {path}")
    place = found.get("placed", {})
    if "refused" in place:
        print(f"hls: {one.name}: {place['refused']}", file=sys.stderr)
        return 1
    if place:
        print(f"{place['device']}: {sentence(place) if 'fmax_mhz' in place else cells_of(place)}")
    return 0


def table(given, samples, seeds, output):
    """Returns the exit status."""
    if given.core or given.set or given.steps or given.stages or given.device:
        raise Refused("--sweep takes its kernels from the table: leave out --core, --set, --steps,"
                      " --stages and --device")
    try:
        rows = read_table(given.sweep, seeds, KERNEL_TABLE)
    except Refused as error:
        print(error, file=sys.stderr)  # has file and line
        return 2

    def do(row):
        found = done(row.wanted, samples, row.device, row.seeds, given.minutes, output)
        report(row.wanted, found, output)
        sys.stdout.flush()
        return found

    file = output / f"{Path(given.sweep).stem}.csv"
    failed = sweep(given.sweep, rows, file, do, given.minutes, output / "store")
    print(f"{len(rows) - failed} of {len(rows)} kernels, {failed} failed; {file}")
    return 1 if failed else 0


def main():
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        given = arguments()
        output = Path(given.output).resolve()
        samples = number("--samples", given.samples, 1, 10**10)
        seeds = number_of_seeds("--seeds", given.seeds)
        if given.sweep:
            return table(given, samples, seeds, output)
        if not given.core:
            raise Refused(f"--core is missing: one of {', '.join(KERNELS)}, or a table")
        one = wanted(given.core, settings(given.set), given.steps, given.stages)
        if given.device:
            check_device(given.device)
        return report(one, done(one, samples, given.device, seeds, given.minutes, output), output)
    except Refused as error:
        print(f"hls: {error}", file=sys.stderr)
        return 2
    except Differs as error:
        print(f"hls: {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"hls: {error.filename}: {error.strerror}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("hls: interrupted", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main())
