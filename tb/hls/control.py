#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""control.py ROOT FILE FROM TO STATUS MESSAGE: scripts/hls.py in a copy of ROOT where FILE has TO
instead of FROM must end with STATUS, and say MESSAGE (a regular expression)."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

NEEDED = ("hls", "ref", "rtl", "scripts", "sysc/board", "sysc/cores", "sysc/cost", "tb/hls",
          "tb/support")
CONFIGURATION = ("Order=4", "CoefBits=18", "PositionBits=24", "GuardBits=4")

root, file, before, after, status, message = sys.argv[1:]
with tempfile.TemporaryDirectory() as name:
    copy = pathlib.Path(name)
    for folder in NEEDED:
        shutil.copytree(pathlib.Path(root) / folder, copy / folder)
    text = (copy / file).read_text()
    if text.count(before) != 1:
        sys.exit(f"{file} has {text.count(before)} times: {before}")
    (copy / file).write_text(text.replace(before, after))
    sets = [f"--set={one}" for one in CONFIGURATION]
    done = subprocess.run([sys.executable, copy / "scripts/hls.py", "--core", "spherical", *sets,
                           "--samples", "1000"], capture_output=True, text=True)
    print(done.stdout + done.stderr, end="")
    if done.returncode != int(status):
        sys.exit(f"status {done.returncode}, not {status}")
    if not re.search(message, done.stderr):
        sys.exit(f"does not say: {message}")
    if list((copy / "build/hls").glob("*.json")) + list((copy / "build/hls").glob("*.v")):
        sys.exit("there is a result")
