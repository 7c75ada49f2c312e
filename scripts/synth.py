# SPDX-License-Identifier: Apache-2.0
"""Place and route of a core, or of a table of configurations; bitstreams of boards.

    scripts/synth.sh --core curve --build serial --device up5k    one, by default of 3 seeds
    scripts/synth.sh --core answer/core.json                      one that curvecore choose found
    scripts/synth.sh --sweep scripts/sweeps/readme.csv            a table, started again: the rest
    scripts/synth.sh --board colorlight_i5                        motion_board with its pins
    scripts/synth.sh --project arty_a7                            the same for Vivado or Quartus

One prints a row and writes build/synth/<core>-<build>-<device>.json, with the speed grade and the
parameters in its name where these are not the default; a table becomes build/synth/<table>.csv.
Each placement is kept in build/synth/store and not repeated as long as sources and tools stay.

The core gets a harness that feeds its inputs from one shift register and reads its outputs through
another, so that it needs few pins; LUTs, flip-flops, DSP and RAM blocks are counted in the core
alone.  The frequency is the best of several seeds, over all paths, the harness' included.

A board becomes build/synth/boards/NAME: its bitstream, the files that it was made of, board.json.
The first seed that keeps the board's clock is taken.  --record notes its figures in
sysc/cost/placed_boards.json, where `curvecore choose --board` and the pages read them.

A project for Vivado or Quartus is set up in build/synth/projects/NAME, with copies of its files.
These tools are not run here: nobody has tried the project in them, nor on the board.

Exit status: 0, 1 where something cannot be placed or is too slow, 2 where the input is wrong.
"""

import argparse
import json
import os
import signal
import sys
from pathlib import Path

from synthesis import bitstream, boards, placed_boards, vendor_project
from synthesis.command_line import Parser, number_of_seeds, settings
from synthesis.configuration import configuration
from synthesis.core_file import CoreFile, core_file
from synthesis.cores import BUILDS, CORES, ROOT
from synthesis.devices import DEVICES
from synthesis.placement import best
from synthesis.refused import Refused
from synthesis.result import cells_of, sentence
from synthesis.sweep import Sweep
from synthesis.tools import write_whole


def arguments():
    parser = Parser(prog="synth.sh", description=__doc__,
                    formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--core", metavar="CORE",
                        help="spherical unless given, " + ", ".join(CORES)
                        + ", or a file (.json) of curvecore choose")
    parser.add_argument("--build", metavar="BUILD", help=", ".join(BUILDS))
    parser.add_argument("--device", metavar="DEVICE", help=", ".join(DEVICES))
    parser.add_argument("--speed", metavar="GRADE",
                        help="6, 7, 8 of ECP5; 7, 8, 9 of Nexus; the slowest unless given")
    parser.add_argument("--set", action="append", default=[], metavar="Name=Value",
                        help="a parameter of the core")
    parser.add_argument("--seeds", default="3", metavar="N", help="the best of N (3)")
    parser.add_argument("--at-least", type=float, default=0, metavar="MHZ",
                        help="fail below this frequency")
    parser.add_argument("--top", metavar="MODULE", help="another module instead of a core")
    parser.add_argument("--board", metavar="BOARD",
                        help=", ".join(boards.names()) + ", or a file (.json) like theirs")
    parser.add_argument("--pins-alone", action="store_true",
                        help="of a board: whether its pins are there, without the motion")
    parser.add_argument("--record", metavar="FILE", nargs="?", const=placed_boards.FILE,
                        help="of a board of scripts/boards: note what it took, for choose unless"
                        " another file (.json) is given")
    parser.add_argument("--project", metavar="BOARD",
                        help="set up for the vendor's tools: "
                        + ", ".join(vendor_project.names()) + ", or a file (.json) like theirs")
    parser.add_argument("--sweep", metavar="FILE", help="a table of configurations (.csv)")
    parser.add_argument("--jobs", type=int, default=2, metavar="N",
                        help="of a sweep: at a time (2)")
    parser.add_argument("--profile", metavar="DIR",
                        help="of a sweep: Snakemake's; scripts/synthesis/slurm for Slurm")
    parser.add_argument("--minutes", type=float, default=180, metavar="N",
                        help="give up a placement after so long (180)")
    parser.add_argument("--output", metavar="DIR", default=ROOT / "build" / "synth",
                        help="folder of results (build/synth)")
    return parser.parse_args()


def one(given, output):
    """Returns the exit status."""
    seeds = number_of_seeds("seeds", given.seeds)
    name = given.core or "spherical"
    core = (core_file(name) if name.endswith(".json")
            else CoreFile(name, "parallel", "ecp5-25", {}))
    wanted = configuration(core.name, given.build or core.build, given.device or core.device,
                         given.speed, core.settings | settings(given.set), given.top)
    if given.at_least and not wanted.family.nextpnr:
        raise Refused(f"--at-least {given.at_least:g}: {wanted.device} is not placed here, so that"
                      " its clock is not known: leave it out")
    try:
        found = best(wanted, seeds, output / "store", given.minutes)
    except Refused as error:
        print(f"synth: {wanted.name}: {error}", file=sys.stderr)
        return 1
    path = output / f"{wanted.name}.json"
    write_whole(path, json.dumps(found, indent=2) + "\n")
    print(f"{wanted.name}: {sentence(found)}; {os.path.relpath(path)}")
    if DEVICES[wanted.device].remark:
        print(f"{wanted.device}: {DEVICES[wanted.device].remark}")
    if given.at_least and found["fmax_mhz"] < given.at_least:
        print(f"synth: {found['fmax_mhz']} MHz is less than {given.at_least:g} MHz",
              file=sys.stderr)
        return 1
    return 0


def board(given, output):
    """Returns the exit status."""
    others = ("core", "build", "device", "speed", "top", "at_least", "sweep")
    if any(getattr(given, other) for other in others):
        raise Refused("--board has all of it in its table: leave out "
                      + ", ".join(f"--{other}".replace("_", "-") for other in others))
    if given.record and (given.set or given.pins_alone or given.board not in boards.names()):
        raise Refused("--record is of a board of scripts/boards as it is: leave out --set and"
                      " --pins-alone")
    wanted = boards.board_named(given.board, settings(given.set))
    folder = output / "boards" / (wanted.name + ("-pins" if given.pins_alone else ""))
    try:
        found = bitstream.make(wanted, folder, number_of_seeds("seeds", given.seeds),
                               given.minutes, given.pins_alone)
    except Refused as error:
        print(f"synth: {wanted.name}: {error}", file=sys.stderr)
        return 1
    if given.record:
        placed_boards.record(wanted, found, Path(given.record))
    if given.pins_alone:
        print(f"{wanted.name}: {len(list(wanted.ports()))} pins are there")
        return 0
    print(f"{wanted.name}: {found['fmax_mhz']} MHz of {found['clock_mhz']:g}, {cells_of(found)},"
          f" {found['axes']} axes, {found['samples_s']} samples/s, {found['steps_s']} steps/s;"
          f" {os.path.relpath(folder / found['bitstream'])}")
    if wanted.loader:
        print(f"to load it: openFPGALoader -b {wanted.loader}"
              f" {os.path.relpath(folder / found['bitstream'])}")
    return 0


def project(given, output):
    """Returns the exit status."""
    others = ("core", "build", "device", "speed", "top", "at_least", "sweep", "board", "record",
              "pins_alone")
    if any(getattr(given, other) for other in others):
        raise Refused("--project has all of it in its table: --set and --output alone go with it")
    wanted = vendor_project.board_named(given.project, settings(given.set))
    folder = output / "projects" / wanted.name
    tool = vendor_project.make(wanted, folder)
    print(f"{wanted.name}: {wanted.part} at {wanted.clock_hz / 1e6:g} MHz, set up, not run; with"
          f" {tool}: make -C {os.path.relpath(folder)}")
    return 0


def main():
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        given = arguments()
        output = Path(given.output).resolve()
        if given.project:
            return project(given, output)
        if given.board:
            return board(given, output)
        if given.pins_alone:
            raise Refused("--pins-alone is of a --board")
        if given.record:
            raise Refused("--record is of a --board")
        if given.sweep:
            if given.set or given.top or given.speed or given.at_least:
                raise Refused("--sweep takes its configurations from the table: leave out --set,"
                              " --top, --speed and --at-least")
            if given.jobs < 1:
                raise Refused(f"--jobs {given.jobs}: must be at least 1")
            if given.profile and not (Path(given.profile) / "config.yaml").exists():
                raise Refused(f"--profile {given.profile}: there is no config.yaml in it")
            sweep = Sweep(given.sweep, output, number_of_seeds("seeds", given.seeds))
            return sweep.run(given.jobs, given.profile, given.minutes)
        return one(given, output)
    except Refused as error:
        text = str(error)
        print(text if ": error: " in text else f"synth: {text}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"synth: {error.filename}: {error.strerror}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("synth: interrupted; what is finished is kept, the same command goes on",
              file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main())
