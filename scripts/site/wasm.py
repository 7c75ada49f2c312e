#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compiles the program's own planner and kernel to WebAssembly, by emcc and ninja: one file of
JavaScript that has the WebAssembly inside.

    wasm.py --build FOLDER     FOLDER/curvecore.js
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Libraries of headers, by the folders of theirs: nothing else of the machine's is to be seen.
LIBRARIES = ("boost", "eigen3/Eigen", "eigen3/unsupported", "fmt", "nlohmann", "CLI")
ROOMS = ("cli", "formats", "core", "kernel", "words", "job", "board", "curves", "cost", "watch",
         "report", "commands/options", "wasm")
SINGLE = ("sysc/commands/terminal/help.cpp", "sysc/commands/terminal/nearest.cpp")
APART = (ROOT / "sysc/curves", ROOT / "rtl/engine/compiler")  # names of theirs are in two files
COMPILE = ("-std=c++17 -O2 -fexceptions -ffp-contract=off -DFMT_HEADER_ONLY"
           " -DEIGEN_DONT_VECTORIZE")
LINK = ("-O2 -fexceptions -sSINGLE_FILE=1 -sMODULARIZE=1 -sEXPORT_NAME=curvecoreModule"
        " -sENVIRONMENT=web,worker,node -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=1GB"
        " -sABORTING_MALLOC=0 -sTOTAL_STACK=1MB -sFORCE_FILESYSTEM=1"
        " -sEXPORTED_RUNTIME_METHODS=cwrap,FS,UTF8ToString"
        " -sEXPORTED_FUNCTIONS=_curvecore_draw,_curvecore_report")


def version():
    return re.search(r"VERSION ([\d.]+) LANG", (ROOT / "CMakeLists.txt").read_text())[1]


def write(file, text):
    """Writes a file, unless it is so already: what depends on it is not made again then."""
    if not file.exists() or file.read_text() != text:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)


def made_headers(folder):
    """Files and pages as strings, as CMake makes them for the program."""
    def fill(template, **values):
        text = (ROOT / template).read_text()
        for name, value in values.items():
            text = text.replace(f"@{name}@", value)
        write(folder / template.removesuffix(".in"), text)

    for data in ("cost_model", "placed_boards"):
        text = (ROOT / f"sysc/cost/{data}.json").read_text()
        fill(f"sysc/cost/{data}_data.hpp.in", **{data: text})
    style = (ROOT / "sysc/report/page.css").read_text()
    page = (ROOT / "sysc/report/report.html").read_text().replace("@page_style@", style)
    fill("sysc/report/report_template.hpp.in", page=page)


def headers(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for library in LIBRARIES:
        link = folder / pathlib.Path(library).name
        if not link.is_symlink():
            link.symlink_to(pathlib.Path("/usr/include") / library)


def units(folder):
    """The sources of a folder joined to one, as CMake joins them: most of the time goes into what
    they all include."""
    rooms = sorted({file.parent for file in (ROOT / "ref").rglob("*.cpp")})
    rooms += [ROOT / "rtl/engine/assembler", ROOT / "rtl/engine/compiler"]
    rooms += [ROOT / "sysc" / room for room in ROOMS]
    for room in rooms:
        name = str(room.relative_to(ROOT)).replace("/", "_")
        sources = sorted(room.glob("*.cpp"))
        if room in APART:
            yield from sources
            continue
        unit = folder / f"{name}.cpp"
        write(unit, "".join(f'#include "{source}"\n' for source in sources))
        yield unit
    yield from (ROOT / source for source in SINGLE)


def ninja_text(build, files):
    ccache = "ccache " if shutil.which("ccache") else ""
    flags = (f"{COMPILE} -DCURVECORE_PROGRAM_VERSION='\"{version()}\"' "
             f"-DCURVECORE_SOURCE='\"/\"' -I{ROOT} -I{build}/made -isystem {build}/include "
             f"-include {ROOT}/sysc/wasm/standard_library.hpp")
    text = (f"rule cc\n  command = {ccache}em++ {flags} -MMD -MF $out.d -c $in -o $out\n"
            "  depfile = $out.d\n  deps = gcc\n  description = $in\n"
            f"rule link\n  command = em++ {LINK} $in -o $out\n  description = $out\n")
    objects = []
    for file in files:
        objects.append(f"objects/{file.stem}.o")
        text += f"build {objects[-1]}: cc {file}\n"
    return text + f"build curvecore.js: link {' '.join(objects)}\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("-j", type=int, default=os.cpu_count(), help="compilers at once")
    asked = parser.parse_args()
    build = asked.build.resolve()
    headers(build / "include")
    made_headers(build / "made")
    write(build / "build.ninja", ninja_text(build, list(units(build / "units"))))
    # Debian's modules of Node, where another Node than Debian's does not look.
    modules = {"NODE_PATH": "/usr/share/nodejs"}
    return subprocess.run(["ninja", "-C", build, "-j", str(asked.j)], check=False,
                          env={**os.environ, **modules}).returncode


if __name__ == "__main__":
    sys.exit(main())
