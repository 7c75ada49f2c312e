#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes README.md's tables and values from what tests, benchmarks and place and route printed.

    scripts/readme_tables.py           fill in what was measured (build/figures, bench, synth)
    scripts/readme_tables.py --check   fail if README.md has a place that no file here fills

A table stands between `<!-- begin: NAME -->` and `<!-- end: NAME -->`; what was not
measured keeps the text it has.
"""

import argparse
import functools
import pathlib
import re
import sys

from placed_tables import cost_model, order_words_placed, parameter_guard_placed, synthesis
from readme_table import BUILD, ROOT, load, short, table

def accuracy():
    data = load("figures/accuracy.json")
    if data is None:
        return None
    rows = [
        (
            r["family"],
            f"{r['curves']:,}",
            f"{r['samples']:,}",
            f"{r['worst_rounded']:.3f}",
            f"{r['worst_unrounded']:.4f}",
            f"{r['bound']:.4f}",
            f"{r['bound'] / r['worst_unrounded']:.1f}",
            r["worst_landing"],
        )
        for r in data["families"]
    ]
    head = [
        "curves",
        "number",
        "samples",
        "worst error, rounded",
        "before rounding",
        "derived bound",
        "bound / worst",
        "end points",
    ]
    return (
        "Error per axis in length units (1 nm), kernel (= RTL, bit for bit) against the exact"
        " curve:\n\n"
        + table(head, rows)
    )


def splines():
    data = load("figures/splines.json")
    if data is None:
        return None
    rows = [
        (
            r["family"],
            f"{r['curves']:,}",
            f"{r['worst_rounded']:.3f}",
            f"{r['worst_unrounded']:.4f}",
            f"{r['bound']:.4f}",
            f"{r['bound'] / r['worst_unrounded']:.1f}",
            f"{r['worst_contour']:.4f}",
            f"{r['worst_speed']:.4f}",
            r["worst_landing"],
        )
        for r in data["families"]
    ]
    head = [
        "cubics",
        "number",
        "worst error, rounded",
        "before rounding",
        "derived bound",
        "bound / worst",
        "off the curve",
        "path between samples",
        "end points",
    ]
    return (
        "Spline kernel against the exact curve at the same path length, in length units (1 nm),"
        " before rounding where not said otherwise; the path between two samples is off by at most"
        " so much beyond 1e-6 of it:\n\n"
        + table(head, rows)
    )


def throughput():
    bench = load("bench.json")
    if bench is None:
        return None
    return table(["what", "measured"], [(r["what"], r["measured"]) for r in bench["rows"]])


def equality():
    data = load("figures/equality.json")
    if data is None:
        return None
    return (
        f"RTL against kernel in {data['configurations']} configurations of both builds, with"
        f" random stalls: {data['samples']:,} samples, {data['differ']} words differ."
    )


def spline_table(name):
    data = load("figures/spline_tables.json")
    if data is None:
        return None
    one = data["tables"][name]
    return one["claim"] + ":\n\n" + table(one["header"], one["rows"])


def paper_table():
    data = load("figures/paper_table.json")
    if data is None:
        return None
    feeds = sorted({r["feed_m_min"] for r in data["rows"]})
    orders = sorted({r["order"] for r in data["rows"]})
    cell = {
        (r["order"], r["feed_m_min"]): f"{short(r['step_mm'])} / {short(r['circle_mm'])}"
        for r in data["rows"]
    }
    head = ["order"] + [f"{feed:g} m/min: step / circle" for feed in feeds]
    return table(head, [[order] + [cell[order, feed] for feed in feeds] for order in orders])


def others():
    data = load("figures/others.json")
    if data is None:
        return None
    head = ["curve", "method", "bits/mm", "off the curve, mm", "speed ripple, %"]
    rows = [
        (
            r["curve"],
            r["method"],
            f"{r['bits_per_mm']:.0f}",
            short(r["off_mm"]),
            short(100 * r["ripple"]),
            short(r["jump_mm_s"]),
        )
        for r in data["rows"]
    ]
    return table([*head, "jumps of velocity, mm/s"], rows)


def demo():
    report = load("demo/report.json")
    if report is None:
        return None
    rows = [
        (
            kind,
            f"{r['samples']:,}",
            f"{r['unrounded_max_lsb']:.4f}",
            f"{r['bound_lsb']:.4f}",
            f"{r['speed_max_error_lsb']:.4f}",
        )
        for kind, r in report["kinds"].items()
    ]
    text = (
        f"What the demo prints for `{pathlib.Path(report['input']).name}` ({report['moves']} moves,"
        f" {report['segments']} segments, {report['samples']:,} samples, unit 1 nm): worst error"
        f" {max(report['error']['max_lsb'].values()):.3f} units on any axis, words that differ"
        f" between RTL and kernel {report['rtl_equals_kernel']}, exact stops off by"
        f" {report['landing_lsb']} units; worst of each kind of segment:\n\n"
    )
    head = ["kind", "samples", "error before rounding", "derived bound", "path between samples"]
    return text + table(head, rows)


def length(mm):
    for size, unit in ((1e3, "m"), (1, "mm"), (1e-3, "um"), (1e-6, "nm")):
        if mm >= size * (1 - 5e-5):
            return f"{mm / size:.4g} {unit}"
    return f"{mm / 1e-6:.4g} nm"


def choose(name):
    data = load(f"figures/choose/{name}/choose.json")
    if data is None:
        return None
    answers = [data["choice"], *data["runners_up"]]
    fine = any(r["parameters"]["ParameterGuard"] for r in answers)
    rows = []
    for r in answers:
        p, e = r["parameters"], r["estimate"]
        free = ("nothing", "least there is")
        bound = [f"{k} by {v}" for k, v in r["binds"].items() if v not in free]
        rows.append(
            (
                f"{r['core']} {r['build']}",
                p["Order"],
                p["CoefBits"],
                p["GuardBits"],
                p["PositionBits"],
                p["SampleInterval"] if r["build"] == "parallel" else "",
                *[p[name] for name in (["ParameterGuard"] if fine else [])],
                p["TurnBits"] if r["build"] == "parallel" else "",
                length(r["unit_mm"]),
                length(r["error_mm"]),
                f"{r['host_words_per_s']:,.0f}",
                f"{r['clock_needed_hz'] / 1e6:.1f}",
                f"{e['lut4']:.0f}",
                f"{e['ff']:.0f}",
                e["dsp"],
                e["bram"],
                f"{e['fmax_mhz']:.0f}",
                ", ".join(bound) or "-",
            )
        )
    head = ["core", "order", "coef", "guard", "position", "interval"]
    head += [*(["parameter guard"] if fine else []), "turn", "unit"]
    head += ["proven error", "host words/s", "needs MHz", "LUT4", "FF", "DSP", "RAM", "MHz"]
    head += ["a bit less ruled out"]
    error = data["choice"]["estimate"]["relative_error"]
    text = table(head, rows) + (
        f"\n\n{data['seconds']:.1f} s of machine time. LUT4, FF and MHz are estimates, off by"
        f" {error['lut4']:.0%}, {error['ff']:.0%} and {error['fmax_mhz']:.0%} (root mean square;"
        f" {data['cost_model']}); DSP and RAM are exact."
    )
    if "confirmed" in data:
        c, e = data["confirmed"], data["choice"]["estimate"]
        text += (
            f" `--confirm` of the first row: {c['lut4']:.0f} LUT4"
            f" ({c['lut4'] / e['lut4'] - 1:+.1%}), {c['ff']:.0f} FF"
            f" ({c['ff'] / e['ff'] - 1:+.1%}), {c['dsp']} DSP, {c['bram']} RAM,"
            f" {c['fmax_mhz']:.1f} MHz ({c['fmax_mhz'] / e['fmax_mhz'] - 1:+.1%}),"
            f" best of {c['seeds']} seeds."
        )
    return text


def parameter_guard():
    data = load("figures/parameter_guard/compare.json")
    if data is None:
        return None
    guards = sorted({row["parameter_guard"] for row in data["rows"]})
    cell = {(row["coef_bits"], row["parameter_guard"]): row for row in data["rows"]}
    widths = sorted({width for width, _ in cell})
    rows = [[width, *(f"{cell[width, g]['segments']:,}" for g in guards)] for width in widths]
    return table(["CoefBits", *(f"segments, ParameterGuard {g}" for g in guards)], rows)


def choose_impossible():
    file = BUILD / "figures/choose/impossible.txt"
    return "```\n" + file.read_text().strip() + "\n```" if file.exists() else None


def order_words():
    data = load("figures/order_words.json")
    if data is None:
        return None

    def core(words):
        turn = f", TurnBits {words['turn_bits']}" if words["turn_bits"] else ""
        return f"Order {words['order']}, CoefBits {words['coef_bits']}{turn}"

    rows = [
        (
            r["wish"],
            r["least_order"],
            core(r["alike"]),
            r["alike"]["blocks"],
            r["alike"]["bits"],
            core(r["own"]),
            r["own"]["widths"],
            r["own"]["blocks"],
            r["own"]["bits"],
        )
        for r in data["rows"]
    ]
    head = ["wish", "orders from", "all alike", "18 x 18 blocks", "multiplier bits"]
    head += ["a width for each", "sum x tau, by order", "18 x 18 blocks", "multiplier bits"]
    return table(head, rows)


TABLES = {
    "choose_up5k": functools.partial(choose, "up5k"),
    "choose_ecp5": functools.partial(choose, "ecp5"),
    "choose_splines": functools.partial(choose, "splines"),
    "parameter_guard": parameter_guard,
    "choose_impossible": choose_impossible,
    "order_words": order_words,
    "order_words_placed": order_words_placed,
    "parameter_guard_placed": parameter_guard_placed,
    "accuracy": accuracy,
    "splines": splines,
    "throughput": throughput,
    "synthesis": synthesis,
    "paper_table": paper_table,
    "demo": demo,
    "equality": equality,
    "cost_model": cost_model,
    "others": others,
}
for name in ("tick", "period", "order", "vertex", "drift"):
    TABLES[f"spline_{name}"] = functools.partial(spline_table, f"spline_{name}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="only check the places in README.md")
    arguments = parser.parse_args()
    readme = ROOT / "README.md"
    text = readme.read_text()
    names = re.findall(r"<!-- begin: (\w+) -->", text)
    unknown = [name for name in names if name not in TABLES]
    empty = [
        name for name in names if re.search(rf"<!-- begin: {name} -->\s*<!-- end: {name} -->", text)
    ]
    if arguments.check:
        if unknown or empty:
            sys.exit(f"README.md: unknown tables {unknown}, empty tables {empty}")
        return
    for name in names:
        body = TABLES[name]()
        if body is not None:
            pattern = rf"(<!-- begin: {name} -->\n).*?(<!-- end: {name} -->)"
            text = re.sub(
                pattern, lambda m: m.group(1) + body + "\n" + m.group(2), text, flags=re.S
            )
        print(f"{name}: {'written' if body is not None else 'not measured, kept'}")
    readme.write_text(text)


if __name__ == "__main__":
    main()
