# SPDX-License-Identifier: Apache-2.0
"""Place and route of a core: prints a row and writes build/synth/<core>-<build>-<device>.json.

The core gets a harness that feeds its inputs from one shift register and reads its outputs through
another, so that it needs five pins; LUTs, flip-flops, DSP and RAM blocks are counted in the core
alone.  The frequency is the best of several seeds, over all paths, the harness' included.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

from synth_harness import harness

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOPS = {  # module, parameters
    ("spherical", "parallel"): ("spherical_interpolator", {}),
    ("spline", "parallel"): ("spline_interpolator", {}),
    ("curve", "parallel"): ("curve_interpolator", {}),
    ("spherical", "serial"): ("curve_interpolator_serial", {}),
    ("curve", "serial"): ("curve_interpolator_serial", {"Splines": 1, "Mode": 1}),
}


class Device:
    """A target: its tools, the multiplier form that fits it, and how its cells count."""

    def __init__(self, family, flags, form, freq, dsp_limit):
        self.family = family
        self.flags = flags
        self.form = form  # parameter Form of rtl/arithmetic/multiplier.sv
        self.freq = freq  # MHz asked for, above what is reached
        self.dsp_limit = dsp_limit  # MHz: nextpnr does not time the inside of a DSP block


def ecp5(size):
    flags = [f"--{size}", "--package", "CABGA381", "--speed", "6", "--lpf-allow-unconstrained"]
    return Device("ecp5", flags, 1, 250, 294)


DEVICES = {
    "ecp5-25": ecp5("25k"),
    "ecp5-45": ecp5("45k"),
    "ecp5-85": ecp5("85k"),
    "up5k": Device("ice40", ["--up5k", "--package", "sg48"], 2, 60, 110),
    "hx8k": Device("ice40", ["--hx8k", "--package", "ct256"], 0, 120, None),
}

# LUTs that a cell occupies; a distributed RAM takes four for the data and two for its write port.
LUTS = {"LUT4": 1, "CCU2C": 2, "TRELLIS_DPR16X4": 6, "SB_LUT4": 1}


def tool(name):
    for candidate in ("yowasp-" + name, name):
        if shutil.which(candidate):
            return candidate
    sys.exit(f"synth: neither yowasp-{name} nor {name} is installed: run scripts/setup.sh")


def run(command, log):
    with open(log, "w") as stream:
        status = subprocess.run(command, stdout=stream, stderr=subprocess.STDOUT).returncode
    if status != 0:
        tail = pathlib.Path(log).read_text(errors="replace").splitlines()[-12:]
        sys.exit("\n".join(tail) + f"\nsynth: {command[0]} failed, see {log}")


def version(name):
    words = subprocess.run([name, "--version"], capture_output=True, text=True)
    found = re.search(r"(Yosys |nextpnr-)\d[\w.+-]*", words.stdout + words.stderr)
    return f"{name}: {found[0] if found else 'version unknown'}"


def read_sources():
    packages = sorted(ROOT.glob("rtl/*_pkg.sv"))
    modules = sorted(set(ROOT.glob("rtl/**/*.sv")) - set(packages))
    return "read_verilog -sv -defer " + " ".join(
        str(path.relative_to(ROOT)) for path in packages + modules)


def elaborate(yosys, core, work):
    """Elaborates the core alone; returns its ports and parameters."""
    (work / "probe.v").write_text(f"module probe;\n  {core} dut ();\nendmodule\n")
    run([yosys, "-q", "-p", f"{read_sources()}; read_verilog {work}/probe.v; hierarchy -top probe;"
         f" proc; write_json {work}/probe.json"], work / "elaborate.log")
    modules = json.loads((work / "probe.json").read_text())["modules"]
    module = modules[modules["probe"]["cells"]["dut"]["type"]]
    return module["ports"], module.get("parameter_default_values", {})


def number(value):
    """Yosys writes integers as strings of 32 bits."""
    if isinstance(value, str) and set(value) <= {"0", "1"}:
        return int(value, 2) - ((1 << len(value)) if value[0] == "1" else 0)
    return value


def synthesise(yosys, device, work):
    """Netlist of core and harness; returns the cells of the core by type."""
    run([yosys, "-p", f"{read_sources()}; read_verilog {work}/harness.v;"
         f" synth_{device.family} -top harness -json {work}/netlist.json;"
         f" tee -o {work}/stat.json stat -json"], work / "synthesise.log")
    netlist = json.loads((work / "netlist.json").read_text())["modules"]
    core = netlist["harness"]["cells"]["dut"]["type"]
    modules = json.loads((work / "stat.json").read_text())["modules"]
    return modules[core if core.startswith("$") else "\\" + core]["num_cells_by_type"]


def place(nextpnr, device, work, seed):
    """One place and route; returns its report."""
    report = work / f"report{seed}.json"
    run([nextpnr, "--json", f"{work}/netlist.json", *device.flags, "--freq", str(device.freq),
         "--timing-allow-fail", "--seed", str(seed), "--report", str(report)],
        work / f"place{seed}.log")
    return json.loads(report.read_text())


def fmax(report):
    return max(clock["achieved"] for clock in report["fmax"].values())


def count(cells, *prefixes):
    return sum(n for name, n in cells.items() if name.startswith(prefixes))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--core", choices=["spherical", "spline", "curve"],
                        default="spherical")
    parser.add_argument("--build", choices=["parallel", "serial"], default="parallel")
    parser.add_argument("--device", choices=DEVICES, default="ecp5-25")
    parser.add_argument("--set", action="append", default=[], metavar="Name=Value")
    parser.add_argument("--seeds", type=int, default=3, metavar="N", help="the best of N (3)")
    parser.add_argument("--at-least", type=float, default=0, metavar="MHZ",
                        help="fail below this frequency")
    parser.add_argument("--top", metavar="MODULE", help="another module instead of a core")
    arguments = parser.parse_args()

    device = DEVICES[arguments.device]
    build = (arguments.core, arguments.build)
    if not arguments.top and build not in TOPS:
        parser.error(f"there is no {arguments.build} build of {arguments.core}")
    top, settings = (arguments.top, {}) if arguments.top else TOPS[build]
    row = top if arguments.top else f"{arguments.core}-{arguments.build}"
    name = f"{row}-{arguments.device}"
    os.chdir(ROOT)
    work = pathlib.Path("build/synth") / name
    work.mkdir(parents=True, exist_ok=True)
    yosys = tool("yosys")
    nextpnr = tool("nextpnr-" + device.family)

    settings = settings | dict(item.split("=", 1) for item in arguments.set)
    for form in {"Form", "MultiplierForm"} & elaborate(yosys, top, work)[1].keys():
        settings.setdefault(form, device.form)
    values = ", ".join(f".{parameter}({value})" for parameter, value in settings.items())
    core = f"{top} #({values})"
    ports, parameters = elaborate(yosys, core, work)
    (work / "harness.v").write_text(harness(core, ports))
    cells = synthesise(yosys, device, work)

    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        seeds = range(1, arguments.seeds + 1)
        reports = list(pool.map(lambda seed: place(nextpnr, device, work, seed), seeds))
    reached = [round(fmax(report), 1) for report in reports]
    dsp = count(cells, "MULT18X18D", "SB_MAC16")
    best = max(reached)
    if dsp and device.dsp_limit:
        best = min(best, device.dsp_limit)

    result = {
        "fmax_mhz": best,
        "lut4": sum(LUTS.get(cell, 0) * n for cell, n in cells.items()),
        "ff": count(cells, "TRELLIS_FF", "SB_DFF"),
        "dsp": dsp,
        "bram": count(cells, "DP16KD", "SB_RAM40"),
        "seeds": len(reached),
        "fmax_mhz_by_seed": reached,
        "parameters": {key: number(value) for key, value in parameters.items()} | settings,
        "tools": [version(yosys), version(nextpnr)],
    }
    path = pathlib.Path("build/synth") / f"{name}.json"
    path.write_text(json.dumps(result, indent=2) + "\n")
    print(f"{name}: {best} MHz (best of {len(reached)}), {result['lut4']} LUT4, {result['ff']} FF, "
          f"{dsp} DSP, {result['bram']} RAM; {path}")
    if best < arguments.at_least:
        sys.exit(f"synth: {best} MHz is less than {arguments.at_least:g} MHz")


if __name__ == "__main__":
    main()
