# SPDX-License-Identifier: Apache-2.0
"""README tables of the papers' claims and of others' methods."""

from readme_table import load, short, table


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


def claims():
    """[Chikurov]'s claims on circles and splines, with what the two tables' programs measured."""
    circles = load("figures/paper_table.json")
    splines = load("figures/spline_tables.json")
    if circles is None or splines is None:
        return None
    turn = {(r["order"], r["feed_m_min"]): short(r["circle_mm"]) + " mm" for r in circles["rows"]}

    def cell(name, row, column):
        one = splines["tables"][name]
        found = next(r for r in one["rows"] if all(a == b for a, b in zip(row, r)))
        return found[one["header"].index(column)]

    def tick(spline):
        return cell("spline_tick", (spline, "1.5"), "Runge-Kutta, 16 variables")

    def period(radius, method):
        return cell("spline_period", (radius, "20"), method) + " ms"

    rows = (
        (
            "circles below 1.5 m/min: at most 1 um, accumulated",
            f"{turn[4, 1.5]} after a turn, D = 50 mm",
            "true above D = 1.2 mm",
        ),
        (
            "circles at 6 m/min and more: beyond the tolerance",
            f"{turn[4, 6]} after a turn, D = 50 mm",
            "false at D = 50 mm; true below D = 7.4 mm, where 2 pi R theta^4/5! passes 1 um",
        ),
        (
            "circles at 60 m/min, D = 50 mm: about 30 um",
            f"{turn[4, 60]} after a turn",
            "true",
        ),
        (
            "splines: much more than circles",
            f"gentle 2D {tick('gentle 2D')} mm, hairpin of 1 mm {tick('hairpin 1')} mm",
            "false for gentle splines, true for sharp ones",
        ),
        (
            "splines: unstable at 1.5 to 2 m/min where the curvature changes sharply",
            f"hairpin of 1 mm {tick('hairpin 1')} mm, of 0.3 mm {tick('hairpin 0.3')},"
            f" of 0.1 mm {tick('hairpin 0.1')}",
            "true from a radius of 0.3 mm down",
        ),
        (
            "splines: a period below 0.05 ms is needed",
            f"1.5 / 2 m/min, radius 0.03 mm: {period('0.03', 'Runge-Kutta, 16 variables')};"
            f" 0.01 mm: {period('0.01', 'Runge-Kutta, 16 variables')}",
            "true at a radius of 0.01 mm; the paper names neither radius nor tolerance, 1 um is"
            " our choice",
        ),
        (
            "so methods of an order above 4 are needed",
            f"radius 0.03 mm: {period('0.03', 'Taylor 12, propagated')} with order 12,"
            f" {period('0.03', 'Runge-Kutta, u alone')} with Runge-Kutta on u alone",
            "half true: order 12 lengthens the period 1.6 to 5 times, carrying u alone"
            " 3 to 60 times",
        ),
    )
    return table(["claim", "measured, Runge-Kutta unless said", "verdict"], rows)
