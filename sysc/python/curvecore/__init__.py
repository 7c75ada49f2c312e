# SPDX-License-Identifier: Apache-2.0
"""Parts planned, drawn by the bit-true kernel of the cores, and compared, as numpy arrays.

    import curvecore
    part = curvecore.plan("part.ngc", set={"Order": 4, "CoefBits": 24}, machine="mill.ini")
    drawn = part.draw()
    drawn.position_mm               # what the RTL puts out, sample by sample

Options are those of the program: `curvecore plan --help` says what each takes.  --error-limit 10nm
is error_limit="10nm", a flag is True, what may be given several times is a list, and --set
Name=Value is set={"Name": value}.
"""

import dataclasses
import json
import os
import pathlib
import re
import subprocess
import tempfile

import numpy

FOLDER = pathlib.Path(__file__).resolve().parent


class InputError(ValueError):
    """A file or an option was refused.

    file    that of the text "FILE:LINE: error: reason", or None
    line    that of the text, or None
    reason  the text behind it
    """

    def __init__(self, text):
        super().__init__(text)
        found = re.match(r"(.*?)(?::(\d+))?: error: (.*)", text, re.S)
        self.file = found[1] if found else None
        self.line = int(found[2]) if found and found[2] else None
        self.reason = found[3] if found else text


from curvecore import _native  # noqa: E402: it raises InputError

if (FOLDER / "share/curvecore").exists():
    _native.ship_from(str(FOLDER / "share/curvecore"))


@dataclasses.dataclass(frozen=True)
class Segments:
    """The segments of a plan, one number or name of each: arrays of one length."""

    line: numpy.ndarray  # of the program
    kind: list  # "line", "arc", "helix", "spline" or a table's name
    length_mm: numpy.ndarray
    bound_units: numpy.ndarray  # derived bound of the error on any axis, before rounding
    feed_end_mm_s: numpy.ndarray

    def __len__(self):
        return len(self.line)


@dataclasses.dataclass(frozen=True)
class Drawn:
    """The start of a part, and the samples of a core that follow, one a period.

    position  (samples, axes) int64, whole length units
    fine      (samples, axes) int64, the same before its rounding, in 2^-GuardBits length units
    """

    position: numpy.ndarray
    fine: numpy.ndarray
    unit_mm: float
    sample_period_s: float

    @property
    def position_mm(self):
        """(samples, axes) float64"""
        return self.position * self.unit_mm

    @property
    def time_s(self):
        """(samples,) float64, from the start on"""
        return numpy.arange(len(self.position)) * self.sample_period_s


class Plan:
    """A planned part.

    axes             X Y Z and the auxiliary ones
    parameters       {name: value} of the core that it is planned for
    settings         {name: value} of inputs of motion_interpolator, without their _i
    unit_mm          the length unit, mm
    sample_period_s  s
    duration_s       of the motion, s
    path_mm          length of the path, mm
    bound_units      worst derived bound of the error on any axis, before rounding, length units
    warnings         texts
    """

    def __init__(self, file, options):
        self._part = _native.PlannedPart([os.fspath(file), *_arguments(options)])

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self._part, name)

    def __repr__(self):
        return (f"<curvecore.Plan: {self.path_mm:.3f} mm in {self.duration_s:.3f} s, errors below"
                f" {self.bound_units:.4f} units of {self.unit_mm:g} mm>")

    @property
    def segments(self):
        """Segments"""
        return Segments(**self._part.segments())

    @property
    def segment_words(self):
        """(n,) uint64: words of 48 bits for the queue of segments"""
        return self._part.segment_words()

    @property
    def profile_words(self):
        """(n,) uint64: words of 48 bits for the queue of the feed profile"""
        return self._part.profile_words()

    def draw(self):
        """Draws it with the kernel, which the RTL equals bit for bit. Returns Drawn."""
        position, fine = self._part.draw()
        return Drawn(position, fine, self.unit_mm, self.sample_period_s)


def plan(file, **options):
    """Plans FILE, G-code or points, with the options of `curvecore plan`. Returns Plan.

    Raises InputError where the program refuses.
    """
    return Plan(file, options)


def compare(file, **options):
    """Draws FILE in several configurations: set={"CoefBits": "24:36:4", "Order": [4, 6]}.

    Returns compare.json of `curvecore compare` as a dict. Raises InputError.
    """
    return _answer("compare", file, options, "compare.json")


def choose(**options):
    """The smallest core that is proven to keep error="1um" with radius=, length=, feed=, device=.

    Returns choose.json of `curvecore choose` as a dict: "possible" says whether there is one.
    Raises InputError.
    """
    return _answer("choose", None, options, "choose.json")


def rtl_files():
    """Paths of the cores' SystemVerilog sources, packages first, as curvecore.f lists them."""
    folder = _shipped() / "rtl"
    return [folder / line for line in (folder / "curvecore.f").read_text().split()]


def program():
    """Path of the program curvecore."""
    return pathlib.Path(os.environ.get("CURVECORE_PROGRAM", FOLDER / "bin/curvecore"))


def _shipped():
    installed = FOLDER / "share/curvecore"
    return installed if installed.exists() else FOLDER.parents[2]  # of sysc/python/curvecore


_ELSEWHERE = {
    "help": "curvecore COMMAND --help prints it",
    "help_all": "curvecore COMMAND --help-all prints it",
    "output": "the answer is returned, and no folder is written",
}


def _arguments(options):
    arguments = []
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        if name in _ELSEWHERE:
            raise InputError(f"{option}: {_ELSEWHERE[name]}")
        if name == "set":
            arguments += _parameters(value)
        elif isinstance(value, (bool, numpy.bool_)):
            arguments += [option] if value else []
        elif isinstance(value, (list, tuple)):
            for one in value:
                arguments += [option, os.fspath(one) if hasattr(one, "__fspath__") else str(one)]
        elif value is not None:
            arguments += [option, os.fspath(value) if hasattr(value, "__fspath__") else str(value)]
    return arguments


def _parameters(values):
    if not isinstance(values, dict):
        raise InputError(f"set={values!r}: a dict is expected, such as {{'Order': 4}}")
    arguments = []
    for name, value in values.items():
        text = ",".join(map(str, value)) if isinstance(value, (list, tuple)) else value
        arguments += ["--set", f"{name}={text}"]
    return arguments


def _answer(command, file, options, name):
    with tempfile.TemporaryDirectory() as folder:
        to = pathlib.Path(folder) / "answer"
        files = [] if file is None else [os.fspath(file)]
        done = subprocess.run([program(), command, *files, *_arguments(options), "-q", "-o", to],
                              capture_output=True, text=True, check=False)
        if not (to / name).exists():
            raise InputError(done.stderr.strip().removeprefix("curvecore: error: "))
        return json.loads((to / name).read_text())
