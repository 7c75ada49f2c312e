# SPDX-License-Identifier: Apache-2.0
"""Tables of the papers' claims and of others' methods."""

from result_table import excerpt, load, short, table

ABSOLUTE = "10^6 ticks, from the start, mm"
SUMMED = "from the tick before, mm"
SPIRALS, CUBICS = "spirals alone are off, um", "cubics are off, um"
HARMONIC = "40 + 8 cos 3 theta"
JOINTS, POINTS = "curvature at the joints, 1/mm", "at the control points, 1/mm"
PEAK = "greatest curvature, 1/mm"


def bench_table(file, name):
    """A table as its program wrote it."""
    data = load(f"figures/{file}.json")
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


def minimal_orders():
    data = load("figures/paper_table.json")
    if data is None:
        return None
    rows = data["minimal_orders"]
    ticks = sorted({r["tick_ms"] for r in rows}, reverse=True)
    tolerances = sorted({r["tolerance_mm"] for r in rows}, reverse=True)
    cell = {(r["tolerance_mm"], r["tick_ms"]): f"{r['step']} / {r['circle']} / {r['circles']}"
            for r in rows}
    return table(["tolerance, mm"] + [f"tick of {tick:g} ms" for tick in ticks],
                 [[f"{one:g}"] + [cell[one, tick] for tick in ticks] for one in tolerances])


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
            "infinite" if r["ripple"] is None else short(100 * r["ripple"]),
            short(r["jump_mm_s"]),
        )
        for r in data["rows"]
    ]
    return table([*head, "jumps of velocity, mm/s"], rows)


def others_rows():
    """A hairpin by five methods."""
    curve = "spline, hairpin r = 0.3 mm, 1.5 m/min"
    return excerpt("others", (1, 2, 3, 4, 5), [(curve, method) for method in (
        "chords, 0.002 mm off", "Runge-Kutta each 10 ms", "Runge-Kutta each ms",
        "forward differences, cubic", "curvecore, from rest to rest")])


def drawn():
    """Programs in G64 P: the drawn path, and its duration."""
    data = load("figures/drawn.json")
    if data is None:
        return None
    rows = []
    for r in data["rows"]:
        rows.append([r["program"], f"{r['share']:.3f}", f"{r['moves']} -> {r['drawn_moves']}",
                     f"{r['drawn_words_without_branches'] / r['words_without_branches']:.3f}",
                     f"{r['drawn_words'] / r['words']:.3f}", f"{r['exact_s']:.3f}",
                     f"{r['drawn_s']:.3f}", f"{r['oracle_shares_s']:.3f}",
                     f"{r['drawn_s'] / r['oracle_shares_s']:.3f}", f"{r['oracle_s']:.3f}",
                     f"{r['drawn_s'] / r['oracle_s']:.3f}"])
    head = ["program", "off / P", "moves", "words of segments and pieces / exact",
            "with stop branches", "exact path, s", "drawn, s", "oracle, the same shares",
            "drawn / oracle", "oracle, whole limits", "drawn / oracle"]
    text = ("Along the path that is drawn, at 500 mm/s; below 1 the oracle found a local optimum "
            "that is worse:")
    return f"{text}\n\n{table(head, rows)}"


def oracle():
    """Durations over those of the time oracle."""
    data = load("figures/oracle.json")
    if data is None:
        return None
    head = ["path", "mm/s", "rules", "optimum", "oracle, the same shares", "optimum / oracle",
            "oracle, whole limits", "rules / oracle", "optimum / oracle"]
    rows = []
    for r in data["rows"]:
        times = [r[name] for name in ("rules_s", "optimum_s", "oracle_shares_s", "oracle_s")]
        rules, optimum, shares, whole = times
        rows.append([r["path"], f"{r['feed_mm_s']:g}", f"{rules:.4f}", f"{optimum:.4f}",
                     f"{shares:.4f}", f"{optimum / shares:.3f}", f"{whole:.4f}",
                     f"{rules / whole:.3f}", f"{optimum / whole:.3f}"])
    off = f"{data['off_on_lines']:.0e}"
    return (f"Seconds. On lines the oracle is within {off} of Ruckig's time, which is exact there:"
            f"\n\n{table(head, rows)}")


def claims():
    """The papers' claims, with the measurements of the tables' programs."""
    circles = load("figures/paper_table.json")
    splines = load("figures/spline_tables.json")
    searches = load("figures/search_tables.json")
    cams = load("figures/cam_tables.json")
    forms = load("figures/form_tables.json")
    idle = load("figures/idle_tables.json")
    if None in (circles, splines, searches, cams, forms, idle):
        return None
    turn = {(r["order"], r["feed_m_min"]): short(r["circle_mm"]) + " mm" for r in circles["rows"]}

    def cell(name, row, column):
        one = splines["tables"][name]
        found = next(r for r in one["rows"] if all(a == b for a, b in zip(row, r)))
        return found[one["header"].index(column)]

    def tick(spline):
        return cell("spline_tick", (spline, "1.5"), "Runge-Kutta, 16 variables")

    def look(tables, name, row, column):
        one = tables["tables"][name]
        found = next(r for r in one["rows"] if r[0] == row)
        return found[one["header"].index(column)]

    def search(name, row, column):
        return look(searches, name, row, column)

    def cam(name, row, column):
        return look(cams, name, row, column)

    def form(name, column="6 m/min"):
        return look(forms, "forms", name, column)

    def fit(name, column):
        return look(idle, "idle_fits", name, column)

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

    def jump(name, second):
        """Row of an idle move by its second cell."""
        one = idle["tables"][name]
        return next(dict(zip(one["header"], r)) for r in one["rows"] if r[1] == second)

    turn_over, speed_up = jump("idle_across", "6.91"), jump("idle_along", "64")
    rows = [("[Chikurov]", *row) for row in rows] + [
        (
            "[Chikurov]",
            "any curve in space can be approximated by arcs",
            f"a gentle curve within 1 um: {form('gentle, arcs within 1 um', 'moves')} tangent arcs,"
            f" {form('gentle, chords within 1 um', 'moves')} chords,"
            f" {form('gentle, splines', 'moves')} splines",
            "true: as the cube root of the tolerance, chords as the square root",
        ),
        (
            "[Obukhov]",
            "lines and arcs make programs slower than splines",
            f"a wave at 6 m/min: splines {form('wave, splines')} s; within 1 um arcs"
            f" {form('wave, arcs within 1 um')} s, chords {form('wave, chords within 1 um')} s;"
            f" chords within 0.1 mm {form('wave, chords within 0.1 mm')} s",
            "true where curvature changes much; fine chords of gentler curves are as fast, as"
            " limits count over the machine's joint time",
        ),
        (
            "[Obukhov]",
            "Simpson's rule and Runge's estimate give the arc length to a tolerance",
            f"false stops on random cubics: {search('search_stops', '1 um', 'from n = 2')} at worst"
            f" from 2 intervals, {search('search_stops', '1 um', 'from n = 32')} from 32",
            "false from few intervals",
        ),
        (
            "[Obukhov]",
            "2 to 3 iterations a tick are enough",
            f"1.5 m/min: gentle 2D {search('search_ticks', 'gentle 2D', '1.5 m/min')}, hairpin 0.03"
            f" {search('search_ticks', 'hairpin 0.03', '1.5 m/min')}; 60 m/min: corner"
            f" {search('search_ticks', 'corner', '60 m/min')}; mean (most)",
            "true at the papers' feeds, with the stop test mended",
        ),
        (
            "[Obukhov]",
            "lengths must count from the frame's start, or errors add up over millions of ticks",
            f"10^6 ticks, hairpin 0.1: {search('search_ticks', 'hairpin 0.1', SUMMED)} mm,"
            f" from the start {search('search_ticks', 'hairpin 0.1', ABSOLUTE)} mm",
            "true: dozens of times the tolerance of 1e-06 mm",
        ),
        (
            "[Petrakov]",
            "more blocks cost no time, thanks to look-ahead",
            f"a U-turn of {form('U-turn, chords within 0.1 mm', 'moves')},"
            f" {form('U-turn, chords within 10 um', 'moves')},"
            f" {form('U-turn, chords within 1 um', 'moves')} chords and lines at 6 m/min:"
            f" {form('U-turn, chords within 0.1 mm')}, {form('U-turn, chords within 10 um')},"
            f" {form('U-turn, chords within 1 um')} s",
            "true: they save time",
        ),
        (
            "[Tamm]",
            "10 to 15 times less input",
            f"tables by cubics both ways, against linear ones of the same error:"
            f" {cam('cam_input', '20 x 10', 'times as many')} times at"
            f" {cam('cam_input', '20 x 10', 'error, um')} um,"
            f" {cam('cam_input', '28 x 16', 'times as many')} at"
            f" {cam('cam_input', '28 x 16', 'error, um')} um",
            "true below some 40 um, without the paper's own switching, which jumps by"
            f" {cam('cam_surfaces', 'tamm, parabola', '5 mm').split(' / ')[1]} um",
        ),
        (
            "[Tamm]",
            "radii every 7 to 8 degrees or more want two stages",
            f"at 7.5 degrees spirals alone are {cam('cam_stages', '7.5', SPIRALS)} um off, cubics"
            f" between the radii {cam('cam_stages', '7.5', CUBICS)} um; at 3 degrees"
            f" {cam('cam_stages', '3', SPIRALS)} and {cam('cam_stages', '3', CUBICS)}",
            "true; for an error of 10 um from 3 degrees on",
        ),
        (
            "[Tamm]",
            "concave parts want a step several times smaller",
            "pieces of 10 um, mean, concave and convex: 40 + 8 cos 3 theta"
            f" {cam('cam_concave', HARMONIC, 'concave')} and"
            f" {cam('cam_concave', HARMONIC, 'convex')} degrees; circle off its centre"
            f" {cam('cam_concave', 'circle, 5 mm off its centre', 'convex')}",
            f"false on one section: {cam('cam_concave', HARMONIC, 'times shorter')} times; true"
            " beside parts that are nearly circles",
        ),
        (
            "[Tamm]",
            "the path is computed without help by hand",
            "`curvecore cam`: one command from the table to drawn positions",
            "true",
        ),
        (
            "[Tamm]",
            "computing and machining take many times less",
            f"delta 5 um: {cam('cam_time', '5', 'pieces')} pieces, machined at 6 m/min in"
            f" {cam('cam_time', '5', 'machined at 6 m/min in, s')} s, computing"
            f" takes {cam('cam_time', '5', 'computing, of machining')} of that; pieces of one"
            f" length are {cam('cam_time', '5', 'times as many')} times as many",
            "computing: cannot be measured against his machine; machining: false at one speed over"
            " the surface, whose path is as long; a controller reads fewer blocks",
        ),
        (
            "[Petrakov]",
            "acceleration jumps by 0.04 g at 1.5 m/min",
            f"across: {turn_over['1.5 m/min']} g where one cubic turns over 5 mm, tangents 6.91 mm;"
            f" along: {speed_up['at constant acceleration']} g where the speed is reached in 64 ms",
            f"true for such moves; across it grows with the square: {turn_over['6 m/min']} g at"
            " 6 m/min; he does not say which it is",
        ),
        (
            "[Petrakov]",
            "cubic splines are enough for a smooth acceleration",
            "U-turn over 5 mm through three points, jumps of curvature at joints and points, 1/mm:"
            f" his cubic {fit('cubic', JOINTS)} and {fit('cubic', POINTS)},"
            f" C2 {fit('c2', JOINTS)} and {fit('c2', POINTS)},"
            f" quintic {fit('quintic', JOINTS)} and {fit('quintic', POINTS)}",
            "false for his cubics; true for C2 cubics that spend two points on the joints: jumps"
            f" {fit('c2, points for least jerk', JOINTS)} and"
            f" {fit('c2, points for least jerk', POINTS)}, peak"
            f" {fit('c2, points for least jerk', PEAK)} instead of the quintic's"
            f" {fit('quintic', PEAK)}",
        ),
    ]
    return table(["paper", "claim", "measured, Runge-Kutta unless said", "verdict"], rows)
