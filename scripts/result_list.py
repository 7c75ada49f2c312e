# SPDX-License-Identifier: Apache-2.0
"""The pages of scripts/results: what each is called, what it shows, and what measures it."""

import functools

from accuracy_tables import (accuracy, campaign_parts, coverage, demo, equality, splines,
                             system_rates, throughput)
from choose_tables import choose, choose_impossible, parameter_guard
from claim_tables import (bench_table, claims, drawn, minimal_orders, oracle, others,
                          paper_table)
from linuxcnc_table import linuxcnc
from person_table import person
from placed_tables import cost_model, hls, networks, parameter_guard_placed, synthesis
from result_table import Table

BENCH = "scripts/bench.sh"
CAMPAIGN = "scripts/campaign.sh"
SWEEP = "scripts/synth.sh --sweep scripts/sweeps/"


def exact(title, make, note=""):
    """A page that is the same on every machine, so --check compares what this tree's runs left."""
    return Table(title, make, "scripts/pages.sh", note, exact=True)


def bench(title, file, name, note=""):
    return exact(title, functools.partial(bench_table, file, name), note)


TABLES = {
    "accuracy": Table(
        "Errors of lines, arcs and helices", accuracy, CAMPAIGN,
        "Error per axis in length units of 1 nm: the kernel, which the RTL equals bit for bit, "
        "against the exact curve."),
    "splines": Table(
        "Errors of splines", splines, CAMPAIGN,
        "Error per axis in length units of 1 nm, at the same path length, with `Mode` 1; before "
        "the final rounding, except in the first column. \"Path between samples\" is the error "
        "of the distance between two samples, beyond one millionth of it."),
    "equality": Table("RTL and kernel are equal", equality, CAMPAIGN),
    "campaign": Table(
        "The campaign, part by part", campaign_parts, CAMPAIGN,
        "The last run of each part that held, with as many samples as its row says, and the tree "
        "that it tried. `scripts/campaign.sh --help` says what a part is."),
    "coverage": Table(
        "Coverage", coverage, "scripts/coverage.sh",
        "Lines and branches that the tests of models, units and commands run; branches that only "
        "exceptions take are left out. The RTL counts a line or branch once, whatever the "
        "instance and configuration."),
    "throughput": Table(
        "Rates of kernel and simulation", throughput, BENCH,
        "The kernel is compiled with -O2; GCC 12 makes it four times slower with -O3."),
    "system_rates": Table("Rates of the system and of the virtual board", system_rates,
                          "scripts/system_rates.py"),
    "demo": exact("The demo part", demo),
    "synthesis": Table(
        "Sizes of the cores", synthesis, SWEEP + "readme.csv",
        "Each row is the best of its seeds. The last column names the tree that was placed; rows "
        "of different trees do not compare to the last percent."),
    "networks": Table("Sizes of networks as cores of their own", networks,
                      SWEEP + "networks.csv"),
    "hls": Table(
        "Kernels by hand and through HLS", hls,
        "scripts/hls.sh --sweep scripts/sweeps/hls.csv",
        "ECP5, speed grade 6. Where MHz is missing, only cells were counted: the pipeline does "
        "not fit, or the row is compared with one that does not. A call of the pipelines of arcs "
        "and splines computes the whole step again; the RTL computes it once, beside the "
        "samples. The RTL includes the lander, queues and handshakes."),
    "parameter_guard": exact(
        "ParameterGuard: segments", parameter_guard,
        "Segments of the built-in splines (`curvecore compare` with `Order` 4 and `Mode` 1)."),
    "parameter_guard_placed": Table("ParameterGuard: placed cores", parameter_guard_placed,
                                    SWEEP + "parameter_guard.csv"),
    "choose_up5k": Table("Smallest core for 1 um, R <= 300 mm, 10 m/min on a UP5K",
                         functools.partial(choose, "up5k"), BENCH),
    "choose_ecp5": exact("Smallest core for 1 nm, R <= 1 m, 60 m/min on an ECP5-25",
                         functools.partial(choose, "ecp5")),
    "choose_splines": exact(
        "Smallest parallel core for 1 nm, splines of up to 10 mm, 1 m/min on an ECP5-25",
        functools.partial(choose, "splines"), "The estimates leave `ParameterGuard` out."),
    "choose_impossible": exact("What an impossible requirement gets", choose_impossible),
    "cost_model": Table("Errors of the cost model", cost_model, "scripts/fit_cost_model.py",
                        measured=False),
    "claims": exact(
        "The papers' claims, measured", claims,
        "[Chikurov] integrates once per controller tick of 10 ms; [Obukhov] searches the "
        "parameter of a tick along the arc. The sources are in "
        "[ref/series](../../ref/series/README.md#sources)."),
    "paper_table": exact(
        "Circles: error by order", paper_table,
        "Error per step, and after one full circle of 50 mm diameter, in mm, with a tick of 10 "
        "ms. Runge-Kutta is the row of order 4."),
    "minimal_orders": exact(
        "Circles: least order", minimal_orders,
        "The least order at 60 m/min that keeps a tolerance after one tick / a full circle / "
        "1000 circles of 50 mm diameter. The paper's \"4 < P < 12\" is right for ticks of 10 ms; "
        "ticks of 1 ms need 2 to 7. The order does nothing for the chord between ticks (0.5 mm "
        "at 60 m/min)."),
    "spline_tick": bench(
        "Splines: error by method", "spline_tables", "spline_tick",
        "By the sixteen integrators, on curves from gentle to a hairpin of 10 um radius. \"Blows "
        "up\" is an error beyond all bounds."),
    "spline_period": bench("Splines: the period needed", "spline_tables", "spline_period"),
    "forms": bench("Splines, arcs and chords", "form_tables", "forms"),
    "search_stops": bench("The search per tick: false stops", "search_tables", "search_stops"),
    "search_ticks": bench("The search per tick: iterations and errors", "search_tables",
                          "search_ticks"),
    "search_words": bench(
        "The search per tick in words", "search_tables", "search_words",
        "An iteration costs 40 products: two speeds with their roots, and a panel of Simpson's "
        "rule."),
    "cam_pieces": bench("Cams: Archimedean pieces", "cam_tables", "cam_pieces"),
    "cam_surfaces": bench("Cams: surfaces", "cam_tables", "cam_surfaces",
                          "A sample cam in closed form, 100 mm long, with radii of 30 to 54 mm."),
    "cam_input": bench("Cams: input", "cam_tables", "cam_input"),
    "planner_effort": Table("What planning costs", functools.partial(
        bench_table, "planner", "planner_effort"), BENCH),
    "planner_threads": Table("Planning by several threads", functools.partial(
        bench_table, "planner", "planner_threads"), BENCH),
    "holds": bench("Longest holds", "hold_tables", "holds"),
    "person": Table(
        "A person at the machine: asked and measured", person, "scripts/person.sh",
        "\"Words of a plan\" are what every build draws, bit for bit; the RTL of each is held to "
        "them by tests. At the pins the wire and the host are in the times, at the built-in "
        "machine's limits. Rows of `placed` boards are placements, of the tree that is named."),
    "oracle": Table(
        "Cycle times over the shortest possible", oracle, "scripts/oracle.sh",
        "[`tb/oracle`](../../tb/oracle) finds the shortest time by collocation and an "
        "interior-point method. \"The same shares\" leave the same rest for holds, \"whole "
        "limits\" leave nothing."),
    "drawn": Table("Cycle times along smoothed paths", drawn, "scripts/oracle.sh"),
    "linuxcnc": Table(
        "Cycle times beside LinuxCNC", linuxcnc, "scripts/linuxcnc.sh",
        "LinuxCNC 2.9 in simulation runs the same programs with 500 mm/s and 5 m/s^2 on every "
        "axis and along the path. LinuxCNC has no limit of jerk; curvecore has 1e5 mm/s^3 and "
        "1e9, which limits nothing, and takes 95 % of the limits: the rest is for holds. \"s\" "
        "is the time in which an axis moves; \"a/A\" is the worst mean acceleration of an axis "
        "over 1, 5 and 20 ms, over the limit; \"off\" is the distance between the path and the "
        "programmed one, both ways. Where the program, or a part of it, names no P (-), "
        "curvecore keeps 10 um and LinuxCNC anything; `polar` has P2540 for its rapids. The "
        "tables are divided by whether LinuxCNC's own samples, one a ms, keep A and P (to 1 um; "
        "10 um where none is named). a/A is above 1 where the exact path passes joints within "
        "the machine's joint time."),
    "others": exact(
        "Others' methods on the same curves", others,
        "Chords as grblHAL and Klipper cut arcs; [Chikurov]'s Runge-Kutta once in the paper's 10 "
        "ms and once in LinuxCNC's 1 ms; cubics in time by forward differences with as much data "
        "as curvecore gets. These are in exact arithmetic at 10,000 samples a second. curvecore "
        "has its own words at 1 nm, whose last rounding is most of its ripple. A chord counts "
        "128 bits, a cubic 416, a segment of curvecore 816, a piece of its feed profile 240, a "
        "word of a stop branch 48. \"At one speed\" there is one piece, as little as the other "
        "methods get. \"From rest to rest\" has the profile of the built-in machine, as `--holds "
        "bounds` sends it. Stop branches buy a hold of 0.2 s anywhere."),
}
