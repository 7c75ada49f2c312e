# SPDX-License-Identifier: Apache-2.0
"""Pages of the curves of ref/curves: what the program says of a table, an example as the kernel
draws it, and the table."""

import csv
import html
import json
import re
import subprocess
import tempfile

from tree import ROOT

WIDTH, HEIGHT, EDGE = 640, 360, 16  # px


def asked(program, *arguments):
    """Text that the program prints; its refusal is an error of the site."""
    return subprocess.run([program, "curve", *arguments], capture_output=True, text=True,
                          check=True, cwd=ROOT).stdout


def drawn(program, name, example, kept):
    """Arguments of `curve run` for an example, the path that it draws, x and y, and the figures of
    its errors. Planning takes seconds: what was drawn is kept, for this table and these words."""
    rows = [word for row in example["rows"] for word in ("--row", row)]
    command = [name, *rows, "--length", example["length"], "--feed", "3m/min", "--unit", "100nm",
               "--on", "kernel", "--sample-period", "1ms"]
    key = command + [(ROOT / f"ref/curves/{name}.net").read_text()]
    file = kept / f"{name}.json"
    if file.exists() and (found := json.loads(file.read_text()))["key"] == key:
        return command, found["points"], found["errors"]
    with tempfile.TemporaryDirectory() as folder:
        asked(program, "run", *command, "-q", "-o", folder)
        with open(f"{folder}/samples.csv", encoding="ascii") as samples:
            table = list(csv.DictReader(line for line in samples if not line.startswith("#")))
        with open(f"{folder}/report.json", encoding="utf-8") as report:
            errors = json.load(report)["kinds"][name]
    points = [(int(row["x"]), int(row["y"])) for row in table]
    kept.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps({"key": key, "points": points, "errors": errors}))
    return command, points, errors


def picture(points, title):
    """The path as an SVG, of equal scales."""
    (left, right), (low, high) = [(min(axis), max(axis)) for axis in zip(*points)]
    scale = min((WIDTH - 2 * EDGE) / max(right - left, 1), (HEIGHT - 2 * EDGE) / max(high - low, 1))
    wide, tall = (right - left) * scale + 2 * EDGE, (high - low) * scale + 2 * EDGE
    path = " ".join(f"{EDGE + (x - left) * scale:.1f},{tall - EDGE - (y - low) * scale:.1f}"
                    for x, y in points)
    return (f'<svg class="curve" viewBox="0 0 {wide:.0f} {tall:.0f}" width="{wide:.0f}" role="img" '
            f'aria-label="{html.escape(title, quote=True)}"><polyline points="{path}"/></svg>')


def curve_page(docs, program, name, example):
    page = f"curves/{name}.md"
    path = f"ref/curves/{name}.net"
    table = (ROOT / path).read_text().split("\n", 1)[1]
    title = re.search(rf"^curve {name} (.*)$", table, re.M)[1]
    remarks = re.match(r"(?:# .*\n)*", table)[0].replace("# ", "")
    text = [f"# {name}", f"{title}.", f"```text\n{remarks.rstrip()}\n```" if remarks else ""]
    if example:
        command, points, kind = drawn(program, name, example, docs.out.parent / "curves")
        text += [picture(points, f"{title}, {example['length']} of it"),
                 "Drawn by the bit-true kernel of this tree:",
                 "```sh\nbuild/curvecore curve run " + " ".join(command) + f" -o {name}\n```",
                 "Its worst error before positions are rounded is {:.3g} units of 100 nm, the "
                 "derived bound {:.3g}.".format(kind["unrounded_max_lsb"], kind["bound_lsb"])]
    text += ["## Rows", "What its rows are, as words of the engine, and which orders of each are "
             "needed:", f"```text\n{asked(program, 'check', path).rstrip()}\n```",
             "## Table", f"```text\n{table.rstrip()}\n```"]
    docs.write(page, "\n\n".join(part for part in text if part))
    return page


def curve_pages(docs, program, examples):
    names = sorted(found[1] for file in docs.files  # a network alone has no page
                   if (found := re.fullmatch(r"ref/curves/(\w+)\.net", file)))
    return [curve_page(docs, program, name, examples.get(name)) for name in names]
