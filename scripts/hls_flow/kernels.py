# SPDX-License-Identifier: Apache-2.0
"""The kernels that go through HLS, and their settings."""

import dataclasses

from synthesis.command_line import number
from synthesis.cores import check_parameters, parameters
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

    @property
    def module(self):
        """The RTL of the same kernel."""
        return f"{self.name}_interpolator"


KERNELS = {kernel.name: kernel for kernel in (
    Kernel("spherical", 0, 20),
    Kernel("spline", 1, 60),
    Kernel("sine_cosine", None, 20),
    Kernel("hyperbola", 0, 20),
)}


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
        """Macros of C++: every parameter of the table, and the number of steps."""
        values = {one.name: one.default for one in table().values()} | self.parameters
        values["Steps"] = self.steps or 0
        return [f"-DCFG_{name}={value}" for name, value in values.items()]


def wanted(core, given, steps=None, stages=None):
    """Checks all that can be known before a tool runs; raises Refused."""
    if core not in KERNELS:
        raise Refused(f"unknown core '{core}': one of {', '.join(KERNELS)}")
    kernel = KERNELS[core]
    for name in given:
        if name in RTL_ALONE:
            raise Refused(f"{name} is the RTL's alone: the pipeline takes a call at every clock")
    check_parameters(kernel.module, given)
    if steps and kernel.steps is None:
        raise Refused(f"--steps: a call of {core} is one step")
    steps = number("--steps", steps, 0, 8) if steps else kernel.steps
    stages = number("--stages", stages, 1, 200) if stages else kernel.stages
    return Wanted(kernel, given, steps, stages)
