# SPDX-License-Identifier: Apache-2.0
"""Parts planned, drawn by the bit-true kernel of the cores, and compared, as numpy arrays.

    import curvecore
    part = curvecore.plan("part.ngc", set={"Order": 4, "CoefBits": 24}, machine="mill.ini")
    drawn = part.draw()
    drawn.position_mm               # what the RTL puts out, sample by sample

Options are those of the program: `curvecore plan --help` says what each takes.  --sample-period 1ms
is sample_period="1ms", a flag is True, what may be given several times is a list, and --set
Name=Value is set={"Name": value}.
"""

from __future__ import annotations

import dataclasses
import os
import pathlib
from typing import Any

import numpy

from curvecore._program import FOLDER, InputError, Option, program
from curvecore import _native, _program

__all__ = ["Drawn", "InputError", "Plan", "Positions", "Segments", "choose", "compare", "curve",
           "plan", "program", "rtl_files"]

InputError.__module__ = __name__  # as users import it

if (FOLDER / "share/curvecore").exists():
    _native.ship_from(str(FOLDER / "share/curvecore"))


@dataclasses.dataclass(frozen=True)
class Segments:
    """The segments of a plan, one number or name of each: arrays of one length."""

    line: numpy.ndarray  # of the program
    kind: list[str]  # "line", "arc", "helix", "spline" or a table's name
    length_mm: numpy.ndarray
    bound_units: numpy.ndarray  # derived bound of the error on any axis, before rounding
    feed_end_mm_s: numpy.ndarray

    def __len__(self) -> int:
        return len(self.line)


@dataclasses.dataclass(frozen=True)
class Positions:
    """A start, and the samples of a core that follow, one a period.

    position  (samples, axes) int64, whole length units
    """

    position: numpy.ndarray
    unit_mm: float
    sample_period_s: float

    @property
    def position_mm(self) -> numpy.ndarray:
        """(samples, axes) float64"""
        return self.position * self.unit_mm

    @property
    def time_s(self) -> numpy.ndarray:
        """(samples,) float64, from the start on"""
        return numpy.arange(len(self.position)) * self.sample_period_s


@dataclasses.dataclass(frozen=True)
class Drawn(Positions):
    """Positions as the kernel draws them.

    fine  (samples, axes) int64, the same before its rounding, in 2^-GuardBits length units
    """

    fine: numpy.ndarray


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

    axes: int
    parameters: dict[str, int]
    settings: dict[str, int]
    unit_mm: float
    sample_period_s: float
    duration_s: float
    path_mm: float
    bound_units: float
    warnings: list[str]

    def __init__(self, file: str | os.PathLike, options: dict[str, Option]) -> None:
        self._part = _native.PlannedPart([os.fspath(file), *_program.arguments(options)])

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self._part, name)

    def __repr__(self) -> str:
        return (f"<curvecore.Plan: {self.path_mm:.3f} mm in {self.duration_s:.3f} s, errors below"
                f" {self.bound_units:.4f} units of {self.unit_mm:g} mm>")

    @property
    def segments(self) -> Segments:
        """Segments"""
        return Segments(**self._part.segments())

    @property
    def segment_words(self) -> numpy.ndarray:
        """(n,) uint64: words of 48 bits for the queue of segments"""
        return self._part.segment_words()

    @property
    def profile_words(self) -> numpy.ndarray:
        """(n,) uint64: words of 48 bits for the queue of the feed profile"""
        return self._part.profile_words()

    def draw(self) -> Drawn:
        """Draws it with the kernel, which the RTL equals bit for bit."""
        position, fine = self._part.draw()
        return Drawn(position, self.unit_mm, self.sample_period_s, fine)


def plan(file: str | os.PathLike, **options: Option) -> Plan:
    """Plans FILE, G-code or points, with the options of `curvecore plan`.

    Raises InputError where the program refuses.
    """
    return Plan(file, options)


def compare(file: str | os.PathLike, **options: Option) -> dict[str, Any]:
    """Draws FILE in several configurations: set={"CoefBits": "24:36:4", "Order": [4, 6]}.

    Returns compare.json of `curvecore compare` as a dict. Raises InputError.
    """
    return _program.answers(["compare", file, *_program.arguments(options)],
                            {"compare.json": _program.read_json})[0]


def choose(**options: Option) -> dict[str, Any]:
    """The smallest core that is proven to keep error="1um" with radius=, length=, feed=, device=.

    Returns choose.json of `curvecore choose` as a dict: "possible" says whether there is one.
    Raises InputError.
    """
    return _program.answers(["choose", *_program.arguments(options)],
                            {"choose.json": _program.read_json})[0]


def rtl_files() -> list[pathlib.Path]:
    """Paths of the cores' SystemVerilog sources, packages first, as curvecore.f lists them."""
    folder = _program.shipped() / "rtl"
    return [folder / line for line in (folder / "curvecore.f").read_text().split()]


from curvecore import curve  # noqa: E402: it returns Positions
