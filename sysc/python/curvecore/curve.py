# SPDX-License-Identifier: Apache-2.0
"""Curves that are tables: what a table costs and how far its words are off, the curve drawn, a
table from formulas; as `curvecore curve` has them.

    import curvecore
    checked = curvecore.curve.check("clothoid", row={"T": (1, 0, 0), "N": (0, 1, 0),
                                                     "kappa": (0.05,) * 3, "sigma": 0.001})
    checked.bound_units, checked.engine.step_clocks
    curvecore.curve.run("wave", x="20*t", y="8*sin(w*t)", let={"w": 2}, t=(0, 3)).position_mm

A table is a file NAME.net, or the name of one that is shipped.  row and let are dicts: a number, or
three of a row that has axes.
"""

from __future__ import annotations

import dataclasses
import os
import pathlib
from typing import Any, Mapping

import numpy

from curvecore import Positions, _program
from curvecore._program import Option


@dataclasses.dataclass(frozen=True)
class Row:
    """A row of a table.

    fraction_bits  of its words
    range          its magnitude at most
    orders         of its series
    largest        its magnitude in the segment that was asked for; None: none was, or it has no end
    """

    name: str
    fraction_bits: int
    range: float
    orders: int
    largest: float | None = None


@dataclasses.dataclass(frozen=True)
class Engine:
    """Needs of the engine for a curve: instructions, and clocks of a segment, step and sample."""

    instructions: int
    segment_clocks: int
    step_clocks: int
    sample_clocks: int


@dataclasses.dataclass(frozen=True)
class Checked:
    """A table that was checked for a core.

    table        its number, parameter Table of the RTL
    engine       None: it does not draw it, engine_refusal says why
    beyond       rows that leave their range in the segment
    bound_units  how far its words are off the curve on any axis at most, before the rounding,
                 length units; None: no segment was asked for, or nothing bounds it
    """

    name: str
    title: str
    table: int
    rows: list[Row]
    engine: Engine | None
    engine_refusal: str | None = None
    beyond: list[str] = dataclasses.field(default_factory=list)
    bound_units: float | None = None


@dataclasses.dataclass(frozen=True)
class Run(Positions):
    """A curve as it was drawn.

    report  report.json of the run, with its checks
    held    whether every check held
    """

    report: dict[str, Any]
    held: bool


def check(table: str | os.PathLike, row: Mapping[str, Any] | None = None,
          **options: Option) -> Checked:
    """Rows of a table, and what the engine needs for it; with row, the bound of a segment of
    steps= steps of 2^step_exponent length units. Raises InputError."""
    found, = _program.answers(["curve", "check", table, *_rows("row", row),
                               *_program.arguments(options)], {"curve.json": _program.read_json})
    found["rows"] = [Row(**one) for one in found["rows"]]
    if found["engine"] is not None:
        found["engine"] = Engine(**found["engine"])
    return Checked(**found)


def run(table: str | os.PathLike, row: Mapping[str, Any] | None = None,
        let: Mapping[str, float] | None = None, t: tuple[float, float] | None = None,
        start: tuple[float, float, float] | None = None, on: str = "kernel",
        **options: Option) -> Run:
    """Draws a curve, of length= and feed=, and compares every sample: of a table with the rows of
    its start, or of formulas x=, y= and z= by t from, to. on="rtl" draws by the RTL, made by
    Verilator. Raises InputError."""
    command = ["curve", "run", table, *_rows("row", row), *_rows("let", let), *_ends(t, start),
               "--on", on, "--no-segments", "--rows", _EVERY, *_program.arguments(options)]
    report, position = _program.answers(command, {"report.json": _program.read_json,
                                                  "samples.csv": _read_samples})
    held = all(one["held"] for one in report["checks"])
    return Run(position, report["unit_mm"], report["sample_period_s"], report, held)


def derive(file: str | os.PathLike, let: Mapping[str, float] | None = None,
           t: tuple[float, float] | None = None, **options: Option) -> str:
    """Writes the table NAME.net of formulas x=, y= and z= by t from, to. Returns the lines of a
    program that name the curve. Raises InputError."""
    return _program.printed(["curve", "derive", file, *_rows("let", let), *_ends(t, None),
                             *_program.arguments(options)])


_EVERY = "1000000000000"  # samples that samples.csv has at most


def _rows(option: str, rows: Mapping[str, Any] | None) -> list[str]:
    made = []
    for name, value in (rows or {}).items():
        made += [f"--{option}", f"{name}={_numbers(value)}"]
    return made


def _ends(t: Any, start: Any) -> list[str]:
    return [text for option, value in (("--t", t), ("--start", start)) if value is not None
            for text in (option, _numbers(value))]


def _numbers(value: Any) -> str:
    return ",".join(repr(float(one)) for one in numpy.atleast_1d(value))


def _read_samples(file: pathlib.Path) -> numpy.ndarray:
    samples = numpy.loadtxt(file, dtype=numpy.int64, delimiter=",", skiprows=6, ndmin=2)
    return samples[:, 3:]
