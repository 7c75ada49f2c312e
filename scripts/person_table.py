# SPDX-License-Identifier: Apache-2.0
"""A person at the machine: each figure that is asked for beside the one that is measured, from what
scripts/person.sh and the pages of other scripts leave."""

import json

from result_table import ROOT, cells, load, table

HOLDS = {"100 %": 0.3, "99 %": 0.3, "90 %": 0.3, "80 %": 0.3, "60 %": 0.38}  # s, asked
WORDS = {"surface": ("surface in chords of 0.2 mm", 20), "circles": ("ten circles of 30 mm", 4)}
PLANS = {"0.2": 4.5, "0.02": 3.5}  # times less CPU, asked, by the chords' length in mm
SLOWED = 1.01  # times as long as with wide queues: more is slowed
FAMILIES = {"ecp5": (1750, 20000), "ice40": (2400, 7000), "gowin": (None, None)}  # LUT4, 1/s
HEAD = ["what", "asked", "measured", "reached", "where", "measured by"]


def at_most(what, most, value, unit, where, by, digits=3):
    """A row whose figure is not to exceed another."""
    return (what, f"<= {most:g}{unit}", f"{value:.{digits}f}{unit}",
            "yes" if value <= most else "no", where, by)


def at_least(what, least, value, where, by, more=""):
    """A row whose figure is a factor that is to be as large as another."""
    return (what, f">= {least:g} times", f"{value:.2f} times{more}",
            "yes" if value >= least else "no", where, by)


def worst(columns, rows, name):
    """The largest figure of a column, and its row's name."""
    place = columns.index(name)
    return max((float(row[place]), row[0]) for row in rows)


def holds(tables, boards):
    one = tables["tables"]["hold_rates"]
    by, words = "`hold_tables`", "words of a plan"
    for rate, most in HOLDS.items():
        value, name = worst(one["header"], one["rows"], rate)
        yield at_most(f"hold at {rate}, worst of {len(one['rows'])} programs: {name}", most, value,
                      " s", words, by)
    way, name = worst(one["header"], one["rows"], "way, mm")
    yield at_most(f"its way from 500 mm/s: {name}", 70, way, " mm", words, by, 1)
    value, name = worst(one["header"], one["rows"], "resume")
    yield at_most(f"resume to full rate, time lost: {name}", 0.35, value, " s", words, by)
    feed = f"{boards['feed_mm_s']:g} mm/s"
    for build, found in boards["builds"].items():
        where, by = f"pins of the virtual board, {build}", "`person_runs`"
        asked = (("hold_s", f"hold at {feed}", 0.3), ("resume_s", f"resume to {feed}", 0.35),
                 ("raised_s", "override 100 to 150 %: it begins", 1),
                 ("raised_whole_s", "override 100 to 150 %: it is there", 1),
                 ("lowered_s", "override 150 to 40 %: it begins", 1),
                 ("lowered_whole_s", "override 150 to 40 %: it is there", 1))
        for name, what, most in asked:
            yield at_most(what, most, found[name], " s", where, by)


def overrides(random):
    one = random["tables"]["overrides"]
    value, name = worst(one["header"], one["rows"], "worst share")
    moments = sum(int(row[one["header"].index("moments")]) for row in one["rows"])
    yield at_most(f"share of a limit over any window, overrides at {moments:,} random moments: "
                  f"{name}", 1, value, "", "words of live plans", "`override_tables`")


def words(plans):
    by = "`person_plans`"
    for name, (what, most) in WORDS.items():
        found = plans["words"][name]
        yield at_most(f"words of a {what}" if name == "surface" else f"words of {what}", most,
                      found["words"] / found["path_mm"], " a mm", "built-in machine", by, 1)
    yield at_most("words of a line", 8, plans["words_of_a_line"], "", "each build", by, 0)
    for name, board in plans["boards"].items():
        own, wide = board["own"], board["wide"]
        ratio = own["duration_s"] / wide["duration_s"]
        feeds = " of ".join(f"{0.06 * one['path_mm'] / one['duration_s']:.2f}"
                            for one in (own, wide))
        yield ("feed of the surface with the board's queues", "not slowed", f"{feeds} m/min",
               "yes" if ratio <= SLOWED else "no", f"`{name}`", by)


def axes(slow, jerks):
    for found in slow["rows"]:
        yield at_most(f"one slow axis, {found['path']}: time over the least", 1.03, found["ratio"],
                      "", "words of a plan", "`time_over_optimum`")
    one = jerks["tables"]["axis_jerk"]
    value, name = worst(one["header"], one["rows"], "worst share")
    yield at_most(f"axis jerk 1/10,000 of the path's: share of a limit, {name}", 1, value, "",
                  "words of a plan", "`axis_tables`")


def planning(plans):
    by = "`plan_cost`"
    for chord, least in PLANS.items():
        cost, what = plans["us_a_chord"][chord], f"planning chords of {chord} mm"
        if "before" in cost:
            yield at_least(f"{what}, CPU of 70c751d over today's", least,
                           cost["before"] / cost["now"], "one thread", by,
                           f" ({cost['before']:.1f} over {cost['now']:.1f} us a chord)")
        else:
            yield (what, f">= {least:g} times less CPU", f"{cost['now']:.1f} us a chord",
                   "70c751d not measured", "one thread", by)
    head, rows = cells("planner_threads")
    gain = {row[0]: float(row[head.index("times as fast as one")]) for row in rows}
    where, by = "chords of 0.2 mm", "[planner_threads](planner_threads.md)"
    yield at_least("planning with 2 threads, as fast as with one", 1.7, gain["2"], where, by)
    yield ("planning with 4 threads, the same", "-", f"{gain['4']:.2f} times", "-", where, by)


def boards_placed():
    for board in json.loads((ROOT / "sysc/cost/placed_boards.json").read_text()):
        parameters = board["parameters"]
        luts, samples = FAMILIES[board["family"]] if parameters["Build"] == 2 else (None, None)
        asked = [f"<= {luts:,} LUT4"] if luts else []
        asked += [f">= {samples:,} samples/s"] if samples else []
        held = (not luts or board["lut4"] <= luts) and (not samples or
                                                        board["samples_s"] >= samples)
        lacks = [name for name in ("Outputs", "Shaper") if parameters[name] == 0]
        yield ("whole board" + (f" without {' and '.join(lacks)}" if lacks else ""),
               ", ".join(asked) or "-",
               f"{board['lut4']:,} LUT4, {board['bram']} RAM, {board['fmax_mhz']:.0f} MHz, "
               f"{board['samples_s']:,} samples/s",
               ("yes" if held and not lacks else "no") if asked else "-",
               f"`{board['board']}`, placed", f"`synth.sh --board`, tree {board['tree']}")


def person():
    data = [load(f"figures/{name}.json") for name in
            ("hold_tables", "person_boards", "override_tables", "person_plans", "slow_axis",
             "axis_tables")]
    if None in data:
        return None
    tables, boards, random, plans, slow, jerks = data
    rows = [*holds(tables, boards), *overrides(random), *words(plans), *axes(slow, jerks),
            *planning(plans), *boards_placed()]
    reached = [row[3] for row in rows]
    return (f"{reached.count('yes')} of {len(rows) - reached.count('-')} rows are reached, "
            f"{reached.count('no')} are not:\n\n{table(HEAD, rows)}")
