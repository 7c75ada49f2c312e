# SPDX-License-Identifier: Apache-2.0
"""One job of a sweep, for the Snakefile: job.py PLAN netlists|placements TARGET, in the store.

TARGET.reason has the reason of a failure.
"""

import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from synthesis.netlist import synthesise  # noqa: E402
from synthesis.placement import place  # noqa: E402
from synthesis.plan import reason_file, configuration_from  # noqa: E402
from synthesis.refused import Refused  # noqa: E402
from synthesis.tools import write_whole  # noqa: E402


def do(plan, kind, target):
    job = plan[kind][target]
    wanted = configuration_from(job["configuration"])
    folder = Path.cwd() / target.split("/")[0]
    if wanted.netlist_name() != folder.name:
        raise Refused("the sources have changed since the sweep began: start it again")
    synthesise(wanted, folder)  # a placement finds it, unless another sweep has just removed it
    if kind == "placements":
        place(wanted, job["seed"], folder, plan["minutes"])


def main():
    plan = json.loads(Path(sys.argv[1]).read_text())
    kind, target = sys.argv[2:]
    try:
        do(plan, kind, target)
    except Refused as error:
        write_whole(reason_file(Path.cwd(), target), f"{error}\n")
        sys.exit(f"{target}: {error}")


main()
