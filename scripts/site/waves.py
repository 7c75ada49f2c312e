# SPDX-License-Identifier: Apache-2.0
"""Timing tables of a module's header as pictures: a line of `clock` or `cycle` and numbers, then a
line for each signal, its values beneath the clocks."""

import html
import re

HEAD = re.compile(r"^ *(clock|cycle)s?((?: +[\w.+]+)+) *$")
NAME, COLUMN, ROW = 190, 92, 30  # px


def tables(lines):
    """Yields the lines of each table: its head, and rows until an empty line."""
    n = 0
    while n < len(lines):
        head = HEAD.match(lines[n])
        if head and re.search(r" \d", head[2]):
            end = n + 1
            while end < len(lines) and lines[end].strip():
                end += 1
            if end > n + 1:
                yield lines[n:end]
            n = end
        else:
            n += 1


def cells(line, starts):
    """The name of a row, and its values by the column that they stand nearest to."""
    found = [(match.start(), match[0]) for match in re.finditer(r"\S+(?: \S+)*", line)]
    if not found or found[0][0] > starts[0] - 2:
        return "", {}
    values = {}
    for start, text in found[1:]:
        column = min(range(len(starts)), key=lambda c: abs(starts[c] - start))
        values[column] = f"{values[column]} {text}" if column in values else text
    return found[0][1], values


def cell_svg(x, y, width, text):
    low, high, middle = y + ROW - 6, y + 6, y + ROW / 2
    if text in ("0", "1"):
        level = high if text == "1" else low
        return (f'<path class="w" d="M{x} {level}H{x + COLUMN}"/>'
                f'<text x="{x + COLUMN / 2}" y="{middle + 4}">{text}</text>')
    box = (f'<path class="b" d="M{x} {middle}l5 {high - middle}H{x + width - 5}l5 '
           f'{middle - high}l-5 {low - middle}H{x + 5}z"/>')
    return box + f'<text x="{x + width / 2}" y="{middle + 4}">{html.escape(text)}</text>'


def svg(table):
    """The picture of a table; None: a row of it has no values, so that it says more than levels."""
    head = table[0]
    columns = [(match.start(), match[0]) for match in re.finditer(r"\S+", head)][1:]
    starts = [start for start, _ in columns]
    rows = [cells(line, starts) for line in table[1:]]
    if any(not name or not values for name, values in rows):
        return None
    need = max(len(text) * 7.2 + 14 - COLUMN * (len(starts) - column)
               for _, values in rows for column, text in values.items())
    wide = NAME + COLUMN * len(starts) + max(0, need) + 4
    tall = ROW * (len(rows) + 1) + 4
    label = "; ".join(f"{name}: " + ", ".join(
        f"{columns[c][1]} {text}" for c, text in sorted(values.items())) for name, values in rows)
    out = [f'<svg class="waves" viewBox="0 0 {wide:.0f} {tall}" width="{wide:.0f}" role="img" '
           f'aria-label="{html.escape("by " + head.split()[0] + ": " + label, quote=True)}">']
    for column, (_, name) in enumerate(columns):
        x = NAME + COLUMN * column
        out.append(f'<path class="g" d="M{x} {ROW - 4}V{tall}"/>'
                   f'<text x="{x + COLUMN / 2}" y="{ROW - 10}">{html.escape(name)}</text>')
    for row, (name, values) in enumerate(rows):
        y = ROW * (row + 1)
        out.append(f'<text class="n" x="0" y="{y + ROW / 2 + 4}">{html.escape(name)}</text>')
        order = sorted(values)
        for column, behind in zip(order, order[1:] + [len(starts)]):
            text = values[column]
            wanted = max(COLUMN, len(text) * 7.2 + 14)
            room = COLUMN * (behind - column) if behind < len(starts) else wanted
            out.append(cell_svg(NAME + COLUMN * column, y, min(wanted, max(room, COLUMN)), text))
    return "".join(out) + "</svg>"
