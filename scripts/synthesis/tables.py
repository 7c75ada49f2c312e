# SPDX-License-Identifier: Apache-2.0
"""The tables that C++ and Python share: a row is NAME(cell, ...), which C++ reads as a macro."""

import csv
import dataclasses
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def rows(file, macro):
    """The cells of every row of a table, as text; a text between quotes without them."""
    text = re.sub(r"^(//|#).*", "", (ROOT / file).read_text(), flags=re.M)
    found = re.findall(rf'^{macro}\(((?:[^"()]|"[^"]*")*)\)', text, flags=re.M)
    return [next(csv.reader([re.sub(r"\s*\n\s*", "", row)], skipinitialspace=True))
            for row in found]


@dataclasses.dataclass(frozen=True)
class Parameter:
    """A row of ref/format/parameters.def."""

    name: str
    low: int
    high: int
    default: int
    values: str
    builds: str
    needs: str
    sentence: str

    def range(self):
        if self.values == "kPowerOfTwo":
            return ", ".join(str(2**n) for n in range(self.high.bit_length()) if 2**n >= self.low)
        return f"{self.low}, {self.high}" if self.high == 1 else f"{self.low}..{self.high}"

    def works_with(self):
        build = ["parallel build"] if self.builds == "kParallelAlone" else []
        return ", ".join(build + [f"`{need.replace('=', '` ')}" for need in self.needs.split()])


def parameters():
    """The parameters of a core, by name."""
    found = [Parameter(name, int(low), int(high), int(default), values, builds, needs, sentence)
             for _, name, low, high, default, values, builds, needs, _, sentence
             in rows("ref/format/parameters.def", "PARAMETER")]
    return {one.name: one for one in found}
