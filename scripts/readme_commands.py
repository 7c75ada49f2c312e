#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the commands of every README.md, in order: each line of a block marked sh.

    scripts/readme_commands.py [--program FILE]   the short ones, in a folder of their own
    scripts/readme_commands.py --try              of these, those of README.md's "Try it"
    scripts/readme_commands.py --fresh            README.md's, all of them, in a fresh clone of HEAD
    scripts/readme_commands.py --list             says which are short, and why others are not

`part.ngc` is a copy of the demo part.  The first command that fails ends it.
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

from result_table import PAGES, ROOT

# Commands that only --fresh, CI or a person runs: how they begin, and why.
LONG = {
    "scripts/demo.sh": "builds the program first",
    "scripts/test.sh": "runs this test",
    "scripts/campaign.sh": "three hours",
    "scripts/buses.sh": "an hour",
    "scripts/oracle.sh": "some minutes",
    "scripts/linuxcnc.sh": "a quarter of an hour, and a package",
    "scripts/coverage.sh": "half an hour",
    "scripts/real_parts.sh": "fetches a package; a test of its own",
    "scripts/synth.sh": "minutes to hours of place and route; tests of its own",
    "scripts/hls.sh": "a minute or more; tests of its own",
    "sudo ": "installs a package",
    "openFPGALoader ": "wants a board",
    "fusesoc ": "a test of its own",
    "build/curvecore run part.ngc --interpreter linuxcnc": "wants that package; tests of its own",
    "cmake ": "builds the libraries; system.Package tests do it",
}


def commands(page, section=""):
    text = page.read_text()
    if section:
        text = text.partition(section)[2].partition("\n## ")[0]
    for block in re.findall(r"^ *```sh\n(.*?)^ *```$", text, re.S | re.M):
        for line in block.split("\n"):
            command = re.sub(r"\s+#\s.*", "", line).strip()
            if command and not command.startswith("#"):
                yield command


def reason(command):
    return next((why for begin, why in LONG.items() if command.startswith(begin)), None)


def run(command, folder, open_files=()):
    print(f"$ {command}", flush=True)
    start = time.monotonic()
    done = subprocess.run(["bash", "-c", command], cwd=folder, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, pass_fds=open_files)
    print("\n".join(done.stdout.split("\n")[-12:]), f"[{time.monotonic() - start:.1f} s]\n",
          flush=True)
    if done.returncode:
        sys.exit(f"{command}: exit status {done.returncode}")


def short(program, typed):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for entry in ROOT.iterdir():
            if entry.name not in ("build", ".git"):
                (folder / entry.name).symlink_to(entry)
        (folder / "build").mkdir()
        (folder / "build/curvecore").symlink_to(program.resolve())
        shutil.copy(ROOT / "tb/data/demo.ngc", folder / "part.ngc")
        ran = set()
        ended, open_end = os.pipe()  # kept open by what a command leaves in the background
        for command in typed:
            if reason(command) is None and command not in ran:
                run(command, folder, (open_end,))
                ran.add(command)
        os.close(open_end)
        os.read(ended, 1)  # boards write what they drew before they end
        print(f"{len(ran)} commands")
        if not ran:
            sys.exit("there are none")


def fresh():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name) / "curvecore"
        subprocess.run(["git", "clone", "--quiet", ROOT, folder], check=True)
        shutil.copy(folder / "tb/data/demo.ngc", folder / "part.ngc")
        for command in commands(ROOT / "README.md"):
            run(command, folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/curvecore")
    parser.add_argument("--try", action="store_true", dest="first", help="README.md's Try it")
    parser.add_argument("--fresh", action="store_true", help="README.md's in a fresh clone")
    parser.add_argument("--list", action="store_true", help="list the commands only")
    arguments = parser.parse_args()
    if arguments.list:
        for page in PAGES:
            for command in commands(page):
                print(f"{page.relative_to(ROOT)}: {command}: {reason(command) or 'short'}")
    elif arguments.fresh:
        fresh()
    elif arguments.first:
        short(arguments.program, commands(ROOT / "README.md", "\n## Try it\n"))
    else:
        short(arguments.program, [command for page in PAGES for command in commands(page)])


if __name__ == "__main__":
    main()
