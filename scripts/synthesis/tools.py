# SPDX-License-Identifier: Apache-2.0
"""External programs, and files that are either whole or not there."""

import contextlib
import fcntl
import functools
import os
import pathlib
import re
import shutil
import subprocess

from synthesis.refused import Refused


def tool(name):
    for candidate in ("yowasp-" + name, name):
        if shutil.which(candidate):
            return candidate
    raise Refused(f"tool missing: neither yowasp-{name} nor {name} is installed:"
                  " run scripts/setup.sh")


@functools.lru_cache(maxsize=None)
def version(command):
    words = subprocess.run([command, "--version"], capture_output=True, text=True)
    found = re.search(r"(Yosys |nextpnr-)\d[\w.+-]*", words.stdout + words.stderr)
    return f"{command}: {found[0] if found else 'version unknown'}"


RUNNING = set()


def end_all():
    """Terminates the programs that run() waits for in other threads."""
    for process in list(RUNNING):
        process.kill()


def run(command, log, explain, minutes=None, cwd=None):
    """Runs a program, its output in the file `log`; `explain(lines)` gives a failure's reason."""
    with open(log, "w") as stream:
        process = subprocess.Popen(command, stdout=stream, stderr=subprocess.STDOUT, cwd=cwd)
        RUNNING.add(process)
        try:
            status = process.wait(timeout=minutes and 60 * minutes)
        except subprocess.TimeoutExpired:
            raise Refused(f"{command[0]} had no answer in {minutes:g} minutes, see {log}") from None
        finally:
            process.kill()
            process.wait()
            RUNNING.discard(process)
    if status < 0:
        raise Refused(f"{command[0]} was ended by signal {-status}, see {log}")
    if status != 0:
        lines = pathlib.Path(log).read_text(errors="replace").splitlines()
        raise Refused(f"{explain(lines)}, see {log}")


def error_of(lines):
    """Returns the first ERROR (nextpnr counts its errors at the end), or the most telling line."""
    said = ([line for line in lines if "ERROR:" in line]
            or [line for line in lines if "error" in line.lower()][-1:]
            or lines[-1:] or ["no output"])
    return re.sub(r"^ERROR: *", "", said[0].strip()).rstrip(".")


def write_whole(path, text):
    """Writes a file atomically: no reader ever sees half of it."""
    path = pathlib.Path(path)
    part = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        part.write_text(text)
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)


@contextlib.contextmanager
def alone(path, wait=True):
    """Holds the lock file `path`; ended with the process.  Not `wait`: BlockingIOError."""
    with open(path, "w") as stream:
        fcntl.flock(stream, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
        yield


@contextlib.contextmanager
def work_folder(path):
    """An empty folder, removed at the end; remains of a killed run are removed at the beginning."""
    shutil.rmtree(path, ignore_errors=True)
    path.mkdir(parents=True)
    try:
        yield path
    finally:
        shutil.rmtree(path, ignore_errors=True)
