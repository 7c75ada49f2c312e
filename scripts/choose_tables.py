# SPDX-License-Identifier: Apache-2.0
"""Tables of the answers of `choose` and `compare`."""

from result_table import load, measured, table


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
    head += [*(["parameter guard"] if fine else []), "unit", "proven error", "host words/s"]
    head += ["needs MHz", "LUT4", "FF", "DSP", "RAM", "MHz"]
    head += ["a bit less ruled out"]
    error = data["choice"]["estimate"]["relative_error"]
    text = table(head, rows) + (
        f"\n\nLUT4, FF and MHz are estimates, off by {error['lut4']:.0%}, {error['ff']:.0%} and"
        f" {error['fmax_mhz']:.0%} (root mean square; {data['cost_model']}); DSP and RAM are exact."
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


def choose_impossible():
    file = measured("figures/choose/impossible.txt")
    return "```\n" + file.read_text().strip() + "\n```" if file else None


def parameter_guard():
    data = load("figures/parameter_guard/compare.json")
    if data is None:
        return None
    guards = sorted({row["parameter_guard"] for row in data["rows"]})
    cell = {(row["coef_bits"], row["parameter_guard"]): row for row in data["rows"]}
    widths = sorted({width for width, _ in cell})
    rows = [[width, *(f"{cell[width, g]['segments']:,}" for g in guards)] for width in widths]
    return table(["CoefBits", *(f"segments, ParameterGuard {g}" for g in guards)], rows)
