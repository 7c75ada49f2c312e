#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Reads a program with LinuxCNC's own interpreter and prints its canonical moves as JSON lines.

    interpret.py PROGRAM --scratch FOLDER [--ini FILE] [--tools FILE] [--seconds N] [--moves N]

README.md describes the lines. The last one is of kind `end` or `error`; without it the interpreter
has crashed or was stopped by its limits. The scratch folder takes LinuxCNC's own files.
"""

import argparse
import ctypes
import hashlib
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys

PACKAGES = "linuxcnc-uspace linuxcnc-uspace-dev g++"
HEADERS = "/usr/include/linuxcnc"
BEGINS = "(curvecore begins)"  # canon_recorder.cpp waits for it
USUAL_TOOLS = range(1, 100)
MOST_TOOLS = 900  # LinuxCNC has room for 1000


class Refused(Exception):
    """An error: no interpreter, or an invalid program."""

    def __init__(self, text, line=0):
        super().__init__(text)
        self.line = line


class Tool(ctypes.Structure):
    """CANON_TOOL_TABLE of LinuxCNC."""
    _fields_ = [("number", ctypes.c_int), ("pocket", ctypes.c_int),
                ("offset", ctypes.c_double * 9), ("diameter", ctypes.c_double),
                ("front", ctypes.c_double), ("back", ctypes.c_double),
                ("orientation", ctypes.c_int)]


class Ini:
    """The machine's .ini, or an empty one."""

    def __init__(self, file):
        self.folder = pathlib.Path(file or ".").resolve().parent
        self.file = file
        if file:
            import linuxcnc
            self.values = linuxcnc.ini(file)

    def find(self, section, name, default=None):
        return (self.values.find(section, name) if self.file else None) or default

    def path(self, section, name):
        text = self.find(section, name)
        return self.folder / os.path.expanduser(text) if text else None

    def metric(self):
        return self.find("TRAJ", "LINEAR_UNITS", "mm").lower() in ("mm", "metric")

    def axis_mask(self):
        axes = self.find("TRAJ", "COORDINATES", "XYZABCUVW").upper()
        return sum(1 << i for i, letter in enumerate("XYZABCUVW") if letter in axes)


class Tools:
    """The machine's tools, in the memory where LinuxCNC's library looks for them."""

    def __init__(self, ini, scratch, table=None):
        os.environ["HOME"] = str(scratch)  # where the library keeps that memory
        library = ctypes.CDLL("libtooldata.so.0")
        self.get_entry = library._Z12tooldata_getP16CANON_TOOL_TABLEi
        library._Z17tool_mmap_creatorPK13EMC_TOOL_STATi(
            ctypes.create_string_buffer(1 << 12), 0)
        library._Z13tooldata_initb(False)
        table = table or ini.path("EMCIO", "TOOL_TABLE")
        if table:
            if library._Z13tooldata_loadPKcPPc(str(table).encode(), None) != 0:
                raise Refused(f"the tool table {table} cannot be read")
        self.in_spindle = 0  # slot

    def entry(self, slot):
        tool = Tool()
        if slot < 0 or self.get_entry(ctypes.byref(tool), slot) != 0:
            return Tool(number=-1)
        return tool

    def tuple_of(self, slot):
        """Returns a tool as the module `gcode` takes it; slot 0 is the tool in the spindle."""
        tool = self.entry(self.in_spindle if slot == 0 else slot)
        if slot == 0 and self.in_spindle == 0:
            tool = Tool(number=-1)
        return (tool.number, *tool.offset, tool.diameter, tool.front, tool.back, tool.orientation)


def tools_of_length_0(program, scratch):
    """A tool table of the tools that a program names by a number, and the usual ones."""
    text = pathlib.Path(program).read_bytes().decode("latin-1").upper()
    named = {int(number) for number in re.findall(r"[TH]\s*(\d{1,5})", text)} - {0}
    table = scratch / "tools.tbl"
    numbers = sorted(named)[:MOST_TOOLS]
    numbers += [number for number in USUAL_TOOLS if number not in named]
    table.write_text("".join(f"T{number} P{number} Z0\n" for number in numbers))
    return table


def with_its_end(program, scratch):
    """A copy of a program with an M2 at its end, unused if the program has its own."""
    folder = scratch / "program"
    folder.mkdir(exist_ok=True)
    copy = folder / pathlib.Path(program).name
    copy.write_bytes(pathlib.Path(program).read_bytes() + b"\nM2\n")
    return copy


class Machine:
    """Answers to LinuxCNC's module `gcode`; its motion goes through canon_recorder.cpp."""

    def __init__(self, ini, tools, parameters, knows_tools):
        self.ini = ini
        self.tools = tools
        self.parameter_file = str(parameters)
        self.knows_tools = knows_tools
        self.left_out = []

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return lambda *_: None

    def get_axis_mask(self):
        return self.ini.axis_mask()

    def get_external_length_units(self):
        return 1.0 if self.ini.metric() else 1 / 25.4

    def get_external_angular_units(self):
        return 1.0

    def get_block_delete(self):
        return False

    def check_abort(self):
        return False

    def get_tool(self, slot):
        return self.tools.tuple_of(slot)

    def change_tool(self, slot):
        self.tools.in_spindle = slot
        if not self.knows_tools:
            self.left_out.append("tools have a length of 0: --tools FILE.tbl or a TOOL_TABLE of "
                                 "--machine's .ini says it")

    def user_defined_function(self, code, *_):
        self.left_out.append(f"M{100 + code} is left out")


def settings_of(ini, program, scratch):
    """Gives LinuxCNC its .ini; returns a file of parameters, which it may write to."""
    file = ini.file
    if not file:
        file = scratch / "interpreter.ini"
        file.write_text(f"[RS274NGC]\nSUBROUTINE_PATH = {pathlib.Path(program).resolve().parent}\n")
    os.environ["INI_FILE_NAME"] = str(pathlib.Path(file).resolve())
    parameters = scratch / "parameters.var"
    own = ini.path("RS274NGC", "PARAMETER_FILE")
    if own and own.exists():
        shutil.copyfile(own, parameters)
    else:
        parameters.touch()
    return parameters


def line_now():
    """Line of the program; the module `gcode` sometimes returns one too many."""
    import interpreter  # LinuxCNC's, there once a program has begun
    return interpreter.this.sequence_number


def check(result):
    """The interpreter's error, if there is one, with its line."""
    import gcode
    if result <= gcode.MIN_ERROR:
        return
    raise Refused(gcode.strerror(result), line_now())


def recorder():
    """Returns canon_recorder.cpp, compiled on first use."""
    here = pathlib.Path(__file__).resolve().parent
    source = here / "canon_recorder.cpp"
    canon = pathlib.Path(HEADERS) / "canon.hh"
    if not canon.exists():
        raise Refused(f"LinuxCNC's headers are missing: apt-get install {PACKAGES}")
    read = b"".join(file.read_bytes() for file in (source, here / "canon_lines.h", canon))
    digest = hashlib.sha256(read).hexdigest()[:16]
    cache = os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache"
    made = pathlib.Path(cache) / "curvecore" / f"canon_recorder-{digest}.so"
    if not made.exists():
        made.parent.mkdir(parents=True, exist_ok=True)
        own = made.with_suffix(f".{os.getpid()}")
        try:
            done = subprocess.run(["g++", "-std=c++17", "-O1", "-shared", "-fPIC", f"-I{HEADERS}",
                                   source, "-o", own, "-ldl"], capture_output=True, text=True)
        except FileNotFoundError:
            raise Refused(f"g++ is missing: apt-get install {PACKAGES}") from None
        if done.returncode != 0:
            raise Refused(f"canon_recorder.cpp does not compile: {done.stderr.strip()[:400]}")
        own.rename(made)
    return ctypes.CDLL(str(made), mode=ctypes.RTLD_GLOBAL)


def interpret(given, lines):
    """Interprets a program, and returns the actions that were left out."""
    try:
        import linuxcnc  # noqa: F401: it brings the libraries
    except ImportError:
        raise Refused(f"LinuxCNC is not installed: apt-get install --no-install-recommends "
                      f"{PACKAGES}") from None
    recording = recorder()
    import gcode
    ini = Ini(given.ini)
    scratch = pathlib.Path(given.scratch)
    table = given.tools or ini.path("EMCIO", "TOOL_TABLE")
    tools = Tools(ini, scratch, table or tools_of_length_0(given.program, scratch))
    machine = Machine(ini, tools, settings_of(ini, given.program, scratch), table is not None)
    line = ctypes.CFUNCTYPE(ctypes.c_int)(line_now)
    recording.record(gcode.__file__.encode(), lines, ctypes.c_long(given.moves), line)
    startup = ini.find("RS274NGC", "RS274NGC_STARTUP_CODE", "")
    program = str(with_its_end(given.program, scratch))
    result, _ = gcode.parse(program, machine, f"G2{1 if ini.metric() else 0}",
                            f"{startup} {BEGINS}")
    recording.flush_record()
    check(result)
    return machine.left_out


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("--scratch", required=True, help="folder for LinuxCNC's own files")
    parser.add_argument("--ini", help="the machine's")
    parser.add_argument("--tools", help="tool table, instead of that of the .ini")
    parser.add_argument("--seconds", type=int, default=120, help="of computing at most")
    parser.add_argument("--moves", type=int, default=5000000, help="to print at most")
    given = parser.parse_args()
    resource.setrlimit(resource.RLIMIT_CPU, (given.seconds, given.seconds + 1))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    lines = os.dup(sys.stdout.fileno())  # programs print, too: to nowhere
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    try:
        left_out = interpret(given, lines)
        last = [{"kind": "warning", "line": 0, "text": text} for text in sorted(set(left_out))]
        last.append({"kind": "end"})
    except Refused as refused:
        last = [{"kind": "error", "line": refused.line, "text": str(refused)}]
    for line in last:
        os.write(lines, (json.dumps(line) + "\n").encode())
    os._exit(0)  # libraries of LinuxCNC do not always end well


if __name__ == "__main__":
    main()
