# SPDX-License-Identifier: Apache-2.0
"""A plugin of pytest, which finds it where curvecore is installed: a fork of the RTL, or a design
of one's own, is held to the kernel by Verilator.

    def test_draws_the_part(curvecore_run):
        report = curvecore_run("part.ngc", dut="my_core.v", set={"Order": 2, "CoefBits": 18})
        assert report["time_kept"]["clocks_used"] < 20

    pytest --curvecore-rtl my/rtl           # for tests that name neither dut nor rtl
    pytest --curvecore-dut my_core.v
"""

from __future__ import annotations

import os
import pathlib
import subprocess
from typing import Any, Callable

import pytest

from curvecore import _program
from curvecore._program import Option

Run = Callable[..., "dict[str, Any]"]


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("curvecore")
    group.addoption("--curvecore-rtl", metavar="FOLDER",
                    help="RTL of tests that name none: a changed copy of rtl/")
    group.addoption("--curvecore-dut", metavar="FILE.v", action="append",
                    help="design with a core's ports, for them; once for each of its files")


@pytest.fixture
def curvecore_run(tmp_path: pathlib.Path, request: pytest.FixtureRequest) -> Run:
    """Runs FILE with the options of `curvecore run`: rtl="FOLDER", dut="FILE.v" or a list of files.

    The test fails where a check does not hold, and says which: the first sample that differs with
    its line of the program and its axes. Returns report.json as a dict; report.html lies beside it
    in a folder of tmp_path. Raises curvecore.InputError where the program refuses.
    """
    def run(file: str | os.PathLike, **options: Option) -> dict[str, Any]:
        if not {"rtl", "dut", "on"} & options.keys():
            options["rtl"] = request.config.getoption("curvecore_rtl")
            options["dut"] = request.config.getoption("curvecore_dut")
        folder = tmp_path / f"run{len(list(tmp_path.glob('run*')))}"
        done = subprocess.run(
            [_program.program(), "run", file, *_program.arguments(options), "-q", "-o", folder],
            capture_output=True, text=True, check=False)
        if done.returncode == 1:
            report = folder / "report.html"
            said = f"{report}\n" if report.exists() else ""
            pytest.fail(f"{done.stderr}{said}", pytrace=False)
        if done.returncode != 0:
            raise _program.refusal(done)
        return _program.read_json(folder / "report.json")

    return run
