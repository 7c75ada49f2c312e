# SPDX-License-Identifier: Apache-2.0
"""A table of configurations through Snakemake; shows results as they come.

Results stay in the store, whatever ends the sweep; a restart does the missing ones.
"""

import ctypes
import importlib.util
import itertools
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

from synthesis.configuration import digest
from synthesis.devices import HERE
from synthesis.plan import reason_file, targets, write_plan
from synthesis.refused import Refused
from synthesis.result import result, sentence
from synthesis.sweep_table import failure, read_table, write_results
from synthesis.tools import alone

PR_SET_PDEATHSIG = 1


def end_with_parent():
    """Linux: Snakemake starts no further job once this process is killed."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


class Sweep:
    def __init__(self, file, output, seeds):
        self.file = file
        self.rows = read_table(file, seeds)
        self.table = output / f"{Path(file).stem}.csv"
        self.part = self.table.with_suffix(".part.csv")
        self.store = output / "store"
        self.folder = output / "sweeps" / f"{Path(file).stem}-{digest(str(Path(file).resolve()))}"
        self.results, self.reasons = {}, {}
        self.runnable, self.paths, self.why = [], {}, {}
        for row in self.rows:
            name = row.wanted.name
            try:
                netlist, placements = targets(row, self.store)
                self.runnable.append(row)
                self.paths[name] = [self.store / f"{target}.json" for target in placements]
                self.why[name] = [reason_file(self.store, target)
                                  for target in (netlist, *placements)]
            except Refused as error:
                self.reasons[name] = str(error)

    def run(self, jobs, profile, minutes):
        """Returns the exit status: 0 when everything was placed."""
        if importlib.util.find_spec("snakemake") is None:
            raise Refused("tool missing: snakemake is not installed: run scripts/setup.sh")
        self.store.mkdir(parents=True, exist_ok=True)
        self.folder.mkdir(parents=True, exist_ok=True)
        try:
            with alone(self.folder / "lock", wait=False):
                for file in itertools.chain(*self.why.values()):
                    file.unlink(missing_ok=True)
                for report in itertools.chain(*self.paths.values()):
                    if not report.exists():
                        report.with_suffix(".done").unlink(missing_ok=True)
                self.collect()
                if len(self.results) < len(self.runnable):
                    self.snakemake(jobs, profile, minutes)
        except BlockingIOError:
            raise Refused(f"{self.file} is being swept by another process") from None
        return self.finish()

    def snakemake(self, jobs, profile, minutes):
        plan = self.folder / "plan.json"
        write_plan(plan, self.runnable, self.store, minutes)
        where = ["--profile", str(Path(profile).resolve())] if profile else ["--cores", str(jobs)]
        command = [sys.executable, "-m", "snakemake", "--snakefile", str(HERE / "Snakefile"),
                   "--directory", str(self.store), "--config", f"plan={plan.resolve()}",
                   "--keep-going", "--rerun-triggers", "mtime", "--ignore-incomplete", "--nolock",
                   "--scheduler", "greedy", *where]
        with open(self.folder / "snakemake.log", "w") as log:
            process = subprocess.Popen(command, stdout=log, stderr=log, start_new_session=True,
                                       preexec_fn=end_with_parent)
            try:
                while process.poll() is None:
                    time.sleep(0.1)
                    self.collect()
            finally:
                if process.poll() is None:
                    os.killpg(process.pid, signal.SIGKILL)
                    process.wait()
                self.collect()

    def collect(self):
        """Takes new results from the store, prints them and writes the table of finished rows."""
        for row in self.runnable:
            name = row.wanted.name
            if name not in self.results:
                found = result(row.wanted, self.paths[name])
                if found:
                    self.results[name] = found
                    print(f"[{len(self.results)}/{len(self.rows)}] {name}: {sentence(found)}",
                          flush=True)
                    write_results(self.part, self.rows, self.results, self.reasons)

    def finish(self):
        for row in self.runnable:
            if row.wanted.name not in self.results:
                found = [file.read_text().strip() for file in self.why[row.wanted.name]
                         if file.exists()]
                self.reasons[row.wanted.name] = found[0] if found else (
                    f"not done, see {self.folder / 'snakemake.log'}")
        write_results(self.table, self.rows, self.results, self.reasons)
        self.part.unlink(missing_ok=True)
        for row in self.rows:
            if row.wanted.name in self.reasons:
                print(failure(self.file, row, self.reasons[row.wanted.name]), file=sys.stderr)
        print(f"{len(self.results)} of {len(self.rows)} placed, {len(self.reasons)} failed;"
              f" {self.table}")
        return 1 if self.reasons else 0
