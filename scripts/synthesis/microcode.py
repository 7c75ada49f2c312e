# SPDX-License-Identifier: Apache-2.0
"""The engine's programs of a module with Build 2, which Yosys reads: scripts/microcode.sh."""

from synthesis.cores import ROOT, files, parameters, text_of
from synthesis.tools import error_of, run

FILES = {"Program": "program.hex", "Data": "data.hex"}  # by the parameter that names them


def has_engine(top, settings):
    own = top in files() and "Program" in text_of(top)  # a module of rtl/, that may have one
    return own and (parameters(top) | settings).get("Build") == "2"


def sources(top, settings):
    """Returns the files of which the programs are made."""
    if not has_engine(top, settings):
        return []
    patterns = ("rtl/engine/programs/*.asm", "rtl/engine/**/*.cpp", "rtl/engine/**/*.hpp",
                "ref/curves/*.net", "ref/curves/*.cpp", "hls/instruction.hpp")
    return sorted(path for pattern in patterns for path in ROOT.glob(pattern))


def make(top, settings, folder, log):
    """Makes the programs in a folder; returns the settings with their names there."""
    if not has_engine(top, settings):
        return settings
    run([ROOT / "scripts" / "microcode.sh", folder, top,
         *(f"{name}={value}" for name, value in settings.items())], log, error_of)
    return settings | {name: f'"{file}"' for name, file in FILES.items()}
