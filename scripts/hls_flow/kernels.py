# SPDX-License-Identifier: Apache-2.0
"""The kernels that go through HLS, and their settings."""

import dataclasses
import pathlib
import re
import subprocess

from synthesis.command_line import number
from synthesis.cores import ROOT, check_parameters, parameters
from synthesis.refused import Refused
from synthesis.tables import parameters as table

# Parameters of the RTL alone: a clock's share of the work, a device's multipliers.
RTL_ALONE = ("SampleInterval", "Networks", "MultiplierForm")


@dataclasses.dataclass(frozen=True)
class Kernel:
    """A core whose kernel hls/top has a top of."""

    name: str
    steps: int | None  # integration steps of a call; None: one
    stages: int  # default stages of the pipeline
    header: pathlib.Path | None = None  # of a kernel that is made of a table

    @property
    def module(self):
        """The RTL of the same kernel; of a table, that with the same parameters."""
        return "spherical_interpolator" if self.header else f"{self.name}_interpolator"

    @property
    def top(self):
        """The name of the files of its top and bench."""
        return "curve" if self.header else self.name


KERNELS = {kernel.name: kernel for kernel in (
    Kernel("spherical", 0, 20),
    Kernel("spline", 1, 60),
    Kernel("sine_cosine", None, 20),
    Kernel("hyperbola", 0, 20),
)}


TABLES = sorted(path.stem for path in (ROOT / "ref/curves").glob("*.net"))
PROGRAM = ROOT / "build/curvecore"


def named(core):
    """The kernel of a core, of a shipped table, or of a table of one's own: FILE.net."""
    if core in KERNELS:
        return KERNELS[core]
    if core in TABLES:
        return Kernel(core, 0, 20, ROOT / "hls/curves" / f"{core}.hpp")
    if not core.endswith(".net"):
        raise Refused(f"unknown core '{core}': one of {', '.join([*KERNELS, *TABLES])}, or"
                      " FILE.net")
    if not PROGRAM.exists():
        raise Refused(f"{core}: its kernel is made by {PROGRAM.relative_to(ROOT)}, which is not"
                      " there: run scripts/demo.sh")
    made = subprocess.run([PROGRAM, "curve", "kernel", core], capture_output=True, text=True)
    if made.returncode:
        raise Refused(made.stderr.strip().removeprefix("curvecore: error: "))
    if "SegmentWords" not in made.stdout:
        raise Refused(f"{core}: a network alone, which draws nothing")
    file = ROOT / "build/hls/curves" / f"{pathlib.Path(core).stem}.hpp"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(made.stdout)
    return Kernel(file.stem, 0, 20, file)


def parameters_of(kernel):
    """Names and defaults."""
    return {name: value for name, value in parameters(kernel.module).items()
            if name not in RTL_ALONE}


@dataclasses.dataclass(frozen=True)
class Wanted:
    """A request: a kernel, its parameters, the form of its pipeline."""

    kernel: Kernel
    given: dict  # parameters as the user set them
    steps: int | None
    stages: int

    @property
    def name(self):
        values = [f"{name}{value}" for name, value in sorted(self.given.items())]
        values += [f"steps{self.steps}"] if self.steps != self.kernel.steps else []
        values += [f"stages{self.stages}"] if self.stages != self.kernel.stages else []
        return "-".join([self.kernel.name, *values])

    @property
    def parameters(self):
        """Parameters of the kernel, with their values."""
        known = parameters_of(self.kernel) | self.given
        return {name: int(value) for name, value in known.items()}

    def definitions(self):
        """Options of C++: macros of every parameter and the number of steps, the kernel of a
        table."""
        values = {one.name: one.default for one in table().values()} | self.parameters
        values["Steps"] = self.steps or 0
        header = self.kernel.header
        if header:
            values["Kernel"] = re.search(r"^class (\w+) ", header.read_text(), re.M)[1]
            values["Top"] = f"{self.kernel.name}_hls"
        macros = [f"-DCFG_{name}={value}" for name, value in values.items()]
        return macros + (["-include", str(header)] if header else [])


def wanted(core, given, steps=None, stages=None):
    """Checks all that can be known before a tool runs; raises Refused."""
    kernel = named(core)
    for name in given:
        if name in RTL_ALONE:
            raise Refused(f"{name} is the RTL's alone: the pipeline takes a call at every clock")
    check_parameters(kernel.module, given)
    if steps and kernel.steps is None:
        raise Refused(f"--steps: a call of {core} is one step")
    steps = number("--steps", steps, 0, 8) if steps else kernel.steps
    stages = number("--stages", stages, 1, 200) if stages else kernel.stages
    return Wanted(kernel, given, steps, stages)
