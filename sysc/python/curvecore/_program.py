# SPDX-License-Identifier: Apache-2.0
"""The program behind the package: where it is, its options, its answers."""

from __future__ import annotations

import json
import os
import pathlib
import re
import subprocess
import tempfile
from typing import Any, Callable, Mapping, Sequence, Union

import numpy

FOLDER = pathlib.Path(__file__).resolve().parent

# A value of an option: a flag is True, what may be given several times is a list, and set, row and
# let are dicts.
Option = Union[str, int, float, os.PathLike, Sequence[Any], Mapping[str, Any], None]


class InputError(ValueError):
    """A file or an option was refused.

    file    that of the text "FILE:LINE: error: reason", or None
    line    that of the text, or None
    reason  the text behind it
    """

    file: str | None
    line: int | None
    reason: str

    def __init__(self, text: str) -> None:
        super().__init__(text)
        found = re.match(r"(.*?)(?::(\d+))?: error: (.*)", text, re.S)
        self.file = found[1] if found else None
        self.line = int(found[2]) if found and found[2] else None
        self.reason = found[3] if found else text


def program() -> pathlib.Path:
    """Path of the program curvecore."""
    return pathlib.Path(os.environ.get("CURVECORE_PROGRAM", FOLDER / "bin/curvecore"))


def shipped() -> pathlib.Path:
    """The folder with rtl/: that of an installed package, or the tree."""
    installed = FOLDER / "share/curvecore"
    return installed if installed.exists() else FOLDER.parents[2]  # of sysc/python/curvecore


_ELSEWHERE = {
    "help": "curvecore COMMAND --help prints it",
    "help_all": "curvecore COMMAND --help-all prints it",
    "output": "the answer is returned, and no folder is written",
}


def arguments(options: Mapping[str, Option]) -> list[str]:
    """Options as the command line has them."""
    made = []
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        if name in _ELSEWHERE:
            raise InputError(f"{option}: {_ELSEWHERE[name]}")
        if name == "set":
            made += _parameters(value)
        elif isinstance(value, (bool, numpy.bool_)):
            made += [option] if value else []
        elif isinstance(value, (list, tuple)):
            for one in value:
                made += [option, text_of(one)]
        elif value is not None:
            made += [option, text_of(value)]
    return made


def text_of(value: Any) -> str:
    return os.fspath(value) if hasattr(value, "__fspath__") else str(value)


def _parameters(values: Any) -> list[str]:
    if not isinstance(values, dict):
        raise InputError(f"set={values!r}: a dict is expected, such as {{'Order': 4}}")
    made = []
    for name, value in values.items():
        text = ",".join(map(str, value)) if isinstance(value, (list, tuple)) else value
        made += ["--set", f"{name}={text}"]
    return made


def answers(command: Sequence[Any], readers: Mapping[str, Callable[[pathlib.Path], Any]]) -> list:
    """Runs a command that writes a folder, and hands each file of it to the reader of its name.
    Returns what these make of them. Raises InputError where the command wrote none."""
    with tempfile.TemporaryDirectory() as folder:
        to = pathlib.Path(folder) / "answer"
        done = _run([*command, "-q", "-o", to])
        if not all((to / name).exists() for name in readers):
            raise refusal(done)
        return [read(to / name) for name, read in readers.items()]


def printed(command: Sequence[Any]) -> str:
    """Runs a command, and returns what it prints. Raises InputError where it fails."""
    done = _run(command)
    if done.returncode != 0:
        raise refusal(done)
    return done.stdout


def read_json(file: pathlib.Path) -> Any:
    return json.loads(file.read_text())


def _run(command: Sequence[Any]) -> subprocess.CompletedProcess[str]:
    # No curvecore.toml: what the functions are given is all that there is.
    return subprocess.run([program(), command[0], "--config=none", *command[1:]],
                          capture_output=True, text=True, check=False)


def refusal(done: subprocess.CompletedProcess[str]) -> InputError:
    """The error of a command that failed, by what it says on stderr."""
    return InputError(done.stderr.strip().removeprefix("curvecore: error: "))
