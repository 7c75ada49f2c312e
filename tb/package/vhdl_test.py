#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""vhdl_test.py GHDL CORE ...: the component of each core's file is taken by GHDL, in a design that
gives every port of the SystemVerilog, as slang reads it, a signal of its width; and one of another
width is not."""
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tb/lint"))
from slang import parsed, sources  # noqa: E402

CORES = {"spherical_interpolator": {"Order": 2, "CoefBits": 18, "AuxAxes": 1},
         "spline_interpolator": {"Order": 2, "CoefBits": 18},
         "curve_interpolator": {"Order": 2, "CoefBits": 18},
         "curve_interpolator_serial": {"Order": 2, "CoefBits": 18},
         "motion_interpolator": {"AuxAxes": 2}, "motion_system": {"AuxAxes": 3}, "motion_board": {},
         "sine_cosine_interpolator": {}, "hyperbola_interpolator": {}}


def widths(top, parameters):
    """Returns the ports of the sources with their bits."""
    slang, _ = parsed(top, parameters, sources())
    body = slang.createCompilation().getRoot().topInstances[0].body
    return {port.name: port.type.bitWidth for port in body.portList}


def kind(bits):
    return "std_logic" if bits == 1 else f"std_logic_vector({bits - 1} downto 0)"


def design(top, ports):
    signals = "".join(f"  signal {port} : {kind(bits)};\n" for port, bits in ports.items())
    given = ", ".join(f"{port} => {port}" for port in ports)
    return (f"library ieee;\nuse ieee.std_logic_1164.all;\n"
            f"entity used is end entity;\narchitecture a of used is\n{signals}begin\n"
            f"  core : component work.{top}_component.{top} port map ({given});\n"
            f"end architecture;\n")


def takes(ghdl, folder, top, ports):
    (folder / "used.vhd").write_text(design(top, ports))
    done = [subprocess.run([ghdl, *command, f"--workdir={folder}", *file], cwd=folder, text=True,
                           capture_output=True)
            for command, file in ((["-a"], [f"{top}.vhd"]), (["-a"], ["used.vhd"]),
                                  (["--elab-run"], ["used", "--stop-time=1ns"]))]
    return all(one.returncode == 0 for one in done), "".join(one.stderr for one in done)


def main(ghdl, *cores):
    failed = 0
    for top in cores:
        parameters = CORES[top]
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            subprocess.run([ROOT / "scripts/flat.sh", top, "--vhdl", "-o", folder / f"{top}.v",
                            *(f"{name}={value}" for name, value in parameters.items())],
                           check=True)
            ports = widths(top, parameters)
            good, said = takes(ghdl, folder, top, ports)
            wide = next(port for port, bits in ports.items() if bits > 1)
            bad, _ = takes(ghdl, folder, top, ports | {wide: ports[wide] + 1})
            missing = dict(list(ports.items())[1:])
            less, _ = takes(ghdl, folder, top, missing)
            print(f"{top}: {len(ports)} ports", "" if good else said)
            failed += not good or bad or less
    print(f"{len(cores) - failed} of {len(cores)} components")
    return failed


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
