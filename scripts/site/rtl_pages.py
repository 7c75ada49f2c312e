# SPDX-License-Identifier: Apache-2.0
"""Pages of cores and of the modules that they are made of, from the headers of rtl/: contract,
timing, parameters, ports, and sizes from the page of what was placed."""

import html
import itertools
import re

import waves
from tree import ROOT

PARAMETER = re.compile(
    r"^ *parameter (?:int )?(?P<name>\w+) *= *(?P<value>[^,/]*?),? *(?:// *(?P<note>.*))?$")
PORT = re.compile(r"^ *(?P<way>input|output)(?: wire)? logic(?P<sign> signed)?"
                  r" *(?:\[ *(?P<high>.*?):0\])? *(?P<name>\w+),? *(?:// *(?P<note>.*))?$")


class Header:
    """The head of a module's file: its comment, parameters and groups of ports."""

    def __init__(self, path):
        self.path = path
        lines = (ROOT / path).read_text().split("\n")[1:]
        self.comment = []
        while lines and lines[0].startswith("//"):
            self.comment.append(lines.pop(0)[2:].removeprefix(" "))
        text = "\n".join(lines)
        found = re.search(r"^module (\w+)(?: #\(\n(.*?)\n\))? \(\n(.*?)\n\);", text, re.M | re.S)
        self.name = found[1]
        self.parameters = [match.groupdict() for line in (found[2] or "").split("\n")
                           if (match := PARAMETER.match(line))]
        self.groups = []  # heading, ports
        for line in found[3].split("\n"):
            if match := PORT.match(line):
                if not self.groups:
                    self.groups.append(("", []))
                self.groups[-1][1].append(match.groupdict())
            elif line.strip().startswith("//"):
                self.groups.append((line.strip()[2:].strip(), []))

    def purpose(self):
        """The comment's first sentences, up to an empty line or a drawing."""
        lines = itertools.takewhile(lambda line: line and line[0] != " ", self.comment)
        return " ".join(lines)


def escaped(text):
    """Text for a cell of a table."""
    return html.escape(text or "").replace("|", "\\|").replace("[", "&#91;").replace("*", "\\*") \
        .replace("_", "\\_")


def contract(header):
    """The comment of a header, its timing tables as pictures where they can be."""
    lines = header.comment
    out, rest = [], []

    def flush():
        while rest and not rest[0].strip():
            rest.pop(0)
        if rest:
            out.append("```text\n" + "\n".join(rest).rstrip() + "\n```")
        rest.clear()

    starts = {}
    for table in waves.tables(lines):
        for n in range(len(lines) - len(table) + 1):
            if lines[n:n + len(table)] == table:
                starts[n] = (len(table), waves.svg(table))
    n = 0
    while n < len(lines):
        count, picture = starts.get(n, (0, None))
        if picture is None:
            rest.append(lines[n])
            n += 1
        else:
            flush()
            out.append(f'<div class="scroll">{picture}</div>')
            n += count
    flush()
    return "\n\n".join(out)


def parameters(header):
    if not header.parameters:
        return ""
    rows = "\n".join(f"| `{row['name']}` | {escaped(row['value'])} | {escaped(row['note'])} |"
                     for row in header.parameters)
    return f"| parameter | default | range and meaning |\n|---|---|---|\n{rows}"


def width(port):
    high = (port["high"] or "").strip()
    if not high:
        return "1"
    if re.fullmatch(r"\d+", high):
        return str(int(high) + 1)
    return high.removesuffix("-1") if high.endswith("-1") else f"{high} + 1"


def ports(header):
    out = ["| port | direction | bits | |\n|---|---|---|---|"]
    for heading, rows in header.groups:
        if heading:
            out.append(f"| **{escaped(heading)}** | | | |")
        for row in rows:
            sign = ", signed" if row["sign"] else ""
            out.append(f"| `{row['name']}` | {'in' if row['way'] == 'input' else 'out'} | "
                       f"{escaped(width(row))}{sign} | {escaped(row['note'])} |")
    return "\n".join(out)


def sizes(core):
    """Rows of the page of placed cores that are this one's: its name there is core-build."""
    names = {"curve_interpolator_serial": "curve-serial"}
    stem = names.get(core, core.removesuffix("_interpolator") + "-")
    lines = (ROOT / "scripts/results/synthesis.md").read_text().split("\n")
    table = [line for line in lines if line.startswith("|")]
    own = [line for line in table[2:] if line.startswith(f"| {stem}")]
    if core == "curve_interpolator":
        own = [line for line in own if not line.startswith("| curve-serial")]
    if core == "spherical_interpolator" or core == "curve_interpolator_serial":
        own += [line for line in table[2:] if core.endswith("serial")
                and line.startswith("| spherical-serial")]
    if core == "spherical_interpolator":
        own = [line for line in own if not line.startswith("| spherical-serial")]
    return "\n".join(table[:2] + own) if own else ""


def core_page(docs, path):
    header = Header(path)
    page = f"cores/{header.name}.md"
    source = docs.place(path)
    text = [f"# {header.name}", escaped(header.purpose()), f"Source: [{path}](../{source})",
            "## Contract", contract(header)]
    if header.parameters:
        text += ["## Parameters", parameters(header)]
    text += ["## Ports", ports(header)]
    if rows := sizes(header.name):
        text += ["## Sizes", docs.linked("Placed and routed; [all cores, and how they were "
                                         "measured](scripts/results/synthesis.md).", "", page),
                 rows]
    docs.write(page, "\n\n".join(text))
    return page


def modules_page(docs, folder):
    """All modules of a folder of rtl, each with its contract and parameters."""
    page = f"modules/{folder}.md"
    text = [f"# rtl/{folder}"]
    for path in sorted(docs.files):
        if path.startswith(f"rtl/{folder}/") and path.count("/") == 2 and path.endswith(".sv") \
                and not path.endswith("_pkg.sv"):
            header = Header(path)
            text += [f"## {header.name}", contract(header), parameters(header),
                     f"Source: [{path}](../{docs.place(path)})"]
    docs.write(page, "\n\n".join(part for part in text if part))
    return page
