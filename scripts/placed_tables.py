# SPDX-License-Identifier: Apache-2.0
"""Tables of placed and routed cores."""

import csv
import json

from result_table import ROOT, cells, measured, sources, table


def finished(path):
    """The rows of a sweep's results that did not fail."""
    file = measured(path)
    if not file:
        return []
    with open(file, newline="") as stream:
        return [row for row in csv.DictReader(stream) if not row["failed"]]


def placed(sweep):
    """Table of the results of `scripts/synth.sh --sweep scripts/sweeps/SWEEP.csv`."""
    return finished(f"synth/{sweep}.csv")


def synthesis():
    rows = [
        (
            f"{r['core']}-{r['build']}",
            r["device"] + (f", speed {r['speed']}" if r["speed"] else ""),
            f"{r['Order']} / {r['CoefBits']} / {r['PositionBits']}.{r['GuardBits']}",
            "series" if int(r["Mode"]) == 0 else "polynomial",
            r["Networks"] if r["build"] == "parallel" else "-",
            r["SampleInterval"] if r["build"] == "parallel" else "20 to 50",
            f"{float(r['fmax_mhz']):.0f}",
            r["lut4"],
            r["ff"],
            r["dsp"],
            r["bram"],
            r["seeds"],
            sources()[0],
        )
        for r in placed("readme")
    ]
    if not rows:
        return None
    head = ["core-build", "device", "Order / CoefBits / position", "sampler", "Networks"]
    head += ["clocks per sample", "MHz", "LUT4", "FF", "DSP", "BRAM", "seeds", "tree"]
    return table(head, rows)


def networks():
    rows = [
        (
            r["core"],
            r["device"] + (f", speed {r['speed']}" if r["speed"] else ""),
            f"{r['Order']} / {r['CoefBits']}",
            r["Anchor"] or "-",
            f"{float(r['fmax_mhz']):.0f}",
            *(r[fact] for fact in ("lut4", "ff", "dsp", "bram", "seeds")),
        )
        for r in placed("networks")
    ]
    head = ["core", "device", "Order / CoefBits", "Anchor", "MHz", "LUT4", "FF", "DSP", "BRAM"]
    return table([*head, "seeds"], rows) if rows else None


def boards():
    """Each board of sysc/cost/placed_boards.json."""
    rows = [
        (
            f"`{r['board']}`",
            r["part"],
            ("parallel", "serial", "engine")[r["parameters"]["Build"]],
            f"{r['clock_mhz']:g}",
            f"{r['fmax_mhz']:.0f}",
            *(r[fact] for fact in ("lut4", "ff", "dsp", "bram", "axes")),
            f"{r['samples_s']:,}",
            f"{r['steps_s'] / 1e6:.4g} M",
            r["tree"],
        )
        for r in json.loads((ROOT / "sysc/cost/placed_boards.json").read_text())
    ]
    head = ["board", "part", "build", "clock, MHz", "placed, MHz", "LUT4", "FF", "DSP", "BRAM"]
    return table([*head, "axes", "samples/s", "steps/s and axis", "tree"], rows)


def hls():
    """Two rows for each kernel: the RTL, and the pipeline of an HLS compiler."""
    found = finished("hls/hls.csv")
    if not found:
        return None

    def row(r, form, what, clocks):
        bits = f" / {r['PositionBits']}.{r['GuardBits']}" if r["PositionBits"] else ""
        mhz = r[f"{form}_fmax_mhz"]
        return (r["core"], what, f"{r['Order']} / {r['CoefBits']}{bits}", r["device"], clocks,
                f"{float(mhz):.0f}" if mhz else "too large" if r[f"{form}_refused"] else "-",
                *(r[f"{form}_{fact}"] for fact in ("lut4", "ff", "dsp")), r["seeds"])

    rows = []
    for r in found:
        steps = f", steps {r['steps']}" if r["steps"] else ""
        rows += [row(r, "rtl", "RTL", r["rtl_clocks"]),
                 row(r, "hls", f"HLS, stages {r['stages']}{steps}", 1)]
    head = ["kernel", "form", "Order / CoefBits / position", "device", "clocks per call"]
    return table([*head, "MHz", "LUT4", "FF", "DSP", "seeds"], list(dict.fromkeys(rows)))


def sizes():
    """Some rows of the table of sizes."""
    head, rows = cells("synthesis")
    wanted = (
        ("spherical-parallel", "ecp5-85, speed 6", "1", "1"),
        ("spherical-parallel", "ecp5-25, speed 6", "1", "4"),
        ("spherical-parallel", "ecp5-25, speed 6", "0", "4"),
        ("spline-parallel", "ecp5-25, speed 6", "1", "4"),
        ("curve-serial", "ecp5-25, speed 6", "-", "20 to 50"),
        ("curve-serial", "up5k", "-", "20 to 50"),
    )
    columns = [head.index(name)
               for name in ("core-build", "device", "Networks", "clocks per sample")]
    found = [next(row for row in rows if tuple(row[c] for c in columns) == key) for key in wanted]
    shown = [*columns, *(head.index(name) for name in ("MHz", "LUT4", "FF", "DSP", "BRAM"))]
    return table([head[c] for c in shown], [[row[c] for c in shown] for row in found])


def pairs(sweep, name):
    """A table of a sweep's rows two by two: one core, then another that does as well."""
    found = placed(sweep)
    if not found:
        return None

    def against(before, after, what):
        saved = 1 - int(after[what]) / int(before[what])
        return f"{before[what]} -> {after[what]} ({-100 * saved:+.0f} %)"

    rows = [
        (
            name(a, b),
            a["device"],
            *(against(a, b, what) for what in ("dsp", "lut4", "ff")),
            f"{float(a['fmax_mhz']):.0f} -> {float(b['fmax_mhz']):.0f}",
            a["seeds"],
        )
        for a, b in zip(found[::2], found[1::2])
    ]
    return table(["core", "device", "DSP", "LUT4", "FF", "MHz", "seeds"], rows)


def parameter_guard_placed():
    return pairs(
        "parameter_guard",
        lambda a, b: f"Order {a['Order']}, CoefBits {a['CoefBits']}.{a['GuardBits']} ->"
        f" {b['CoefBits']}.{b['GuardBits']}, ParameterGuard {b['ParameterGuard']}",
    )


def cost_model():
    data = json.loads((ROOT / "sysc/cost/cost_model.json").read_text())
    names = {"lut4": "LUTs", "ff": "flip-flops", "period_ns": "clock period"}
    rows = [
        (
            m["build"],
            ", ".join(m["families"]),
            names[m["quantity"]],
            m["runs"],
            f"{100 * m['fitted']:.1f} %",
            m["held_out"],
            f"{100 * m['error']:.1f} %",
            f"{100 * m['worst']:.1f} %",
        )
        for m in data["models"]
    ]
    head = ["build", "families", "estimate", "runs fitted", "rms", "runs held out", "rms", "worst"]
    return table(head, rows)
