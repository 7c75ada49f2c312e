# SPDX-License-Identifier: Apache-2.0
"""Tables of errors, rates and coverage: campaigns, benches, the demo."""

import json
import pathlib
import re

from result_table import BUILD, RESULTS, ROOT, cells, load, table


COLUMNS = {
    "number": lambda r: f"{r['curves']:,}",
    "samples": lambda r: f"{r['samples']:,}",
    "worst error, rounded": lambda r: f"{r['worst_rounded']:.3f}",
    "before rounding": lambda r: f"{r['worst_unrounded']:.4f}",
    "derived bound": lambda r: f"{r['bound']:.4f}",
    "bound / worst": lambda r: f"{r['bound'] / r['worst_unrounded']:.1f}",
    "off the curve": lambda r: f"{r['worst_contour']:.4f}",
    "path between samples": lambda r: f"{r['worst_speed']:.4f}",
    "end points": lambda r: r["worst_landing"],
}


def campaign(name, what, *without):
    """Rows, one for each family of curves that a campaign drew."""
    data = load(f"figures/{name}.json")
    if data is None:
        return None
    head = [column for column in COLUMNS if column not in without]
    rows = [(r["family"], *(COLUMNS[column](r) for column in head)) for r in data["families"]]
    return table([what, *head], rows)


def accuracy():
    return campaign("accuracy", "curves", "off the curve", "path between samples")


def splines():
    return campaign("splines", "cubics", "samples")


def rates(file, head):
    bench = load(file)
    if bench is None:
        return None
    return table(head, [(r["what"], r["measured"]) for r in bench["rows"]])


def throughput():
    return rates("bench.json", ["what", "measured"])


def system_rates():
    return rates("figures/system_rates.json", ["what runs", "times of real time"])


def coverage():
    data = load("figures/coverage.json")
    if data is None:
        return None

    def share(row, kind):
        run, number = row[kind + "_run"], row[kind]
        return f"{run:,} of {number:,} ({run / number:.1%})"

    return table(["folder", "lines", "branches"],
                 [(f"`{r['folder']}`", share(r, "line"), share(r, "branch")) for r in data])


def equality():
    data = load("figures/equality.json")
    if data is None:
        return None
    return (
        f"RTL against kernel in {data['configurations']} configurations of both builds, with"
        f" random stalls: {data['samples']:,} samples, {data['differ']} words differ."
    )


def campaign_parts():
    """Rows, one for each part in the order of its help; what was not run since stays as it was."""
    head = ["part", "what held", "CPU minutes of the run that ended it", "tree"]
    kept = {}
    if (RESULTS / "campaign.md").exists():
        kept = {row[0]: row for row in cells("campaign")[1]}
    rows = []
    for part in re.findall(r"^#   ([a-z]+) +[a-z0-9N]", (ROOT / "scripts/campaign.sh").read_text(),
                           re.M):
        stamp = BUILD / f"campaign/{part}.json"
        if stamp.exists():
            one = json.loads(stamp.read_text())
            minutes = f"{one['cpu_seconds'] / 60:.1f}"
            held = re.sub(r"(?<![.\d])\d{4,}\b", lambda number: f"{int(number[0]):,}",
                          "; ".join(one["results"]))
            rows.append((part, held, minutes, one["tree"]))
        else:
            rows.append(kept.get(part, (part, "not run", "", "")))
    return table(head, rows)


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


def errors():
    """The worst rows of the two tables of accuracy."""
    rows = []
    for kind, name, word in (("arcs", "accuracy", "arcs"), ("helices", "accuracy", "helices"),
                             ("lines", "accuracy", "lines"), ("splines", "splines", "")):
        head, found = cells(name)
        found = [row for row in found if row[0].startswith(word)]
        worst = [max(row[head.index(column)] for row in found)
                 for column in ("worst error, rounded", "before rounding", "derived bound")]
        number = sum(int(row[head.index("number")].replace(",", "")) for row in found)
        rows.append((kind, f"{number:,}", *worst))
    return table(["drawn", "curves", "worst error, nm", "before rounding", "derived bound"], rows)
