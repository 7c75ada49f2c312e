#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fits the cost model to runs of scripts/synth.sh: writes sysc/cost/cost_model.json.

    scripts/fit_cost_model.py [RUNS.csv]          default: scripts/cost_runs.csv

RUNS.csv is what `scripts/synth.sh --sweep scripts/sweeps/cost_model.csv` writes.  Runs whose note
is `holdout` are not fitted but predicted, and their error is the model's.  Where a build has fewer
than three of them, each run is predicted from the fit to all others instead.  A family whose runs
are off by more than that has an error of its own.

LUTs, flip-flops and the clock period are sums of features (FEATURES) times coefficients, fitted per
build by least squares of the relative error.  Runs of Yosys' cells alone, which were not placed,
have a fit of their own, and no clock period.  A little ridge, not on the families' own constants,
keeps coefficients at zero that the runs cannot tell, and a feature that would make a core smaller
as it grows is left out.
"""

import argparse
import csv
import json
import math
import pathlib
import sys

import numpy

from synthesis.devices import DEVICES

ROOT = pathlib.Path(__file__).resolve().parent.parent
PARAMETERS = ("Order", "CoefBits", "PositionBits", "GuardBits", "AuxAxes", "Mode", "SampleInterval")
COUNTS = {"lut4": "lut4", "ff": "ff", "period_ns": "fmax_mhz"}  # quantity: column
RIDGE = {"lut4": 1e-4, "ff": 1e-4, "period_ns": 1e-2}
# `*` multiplies; `family` stands for each family in the runs in turn, which is 1 in its rows.
FEATURES = {
    ("serial", "lut4"): ("coef_bits", "fine_bits", "splines", "splines*coef_bits", "order", "soft"),
    ("serial", "ff"): ("family*coef_bits", "fine_bits", "axes*fine_bits", "splines",
                       "splines*coef_bits"),
    ("serial", "period_ns"): ("family*coef_bits", "family*splines", "wide_block"),
    ("parallel", "lut4"): ("wide*coef_bits", "arcs*coef_bits", "narrow*coef_bits", "splines",
                           "axes*fine_bits", "axes*fine_bits*samples"),
    ("parallel", "ff"): ("wide*coef_bits", "arcs*coef_bits", "narrow*coef_bits", "splines",
                         "axes*fine_bits", "arcs*order"),
    ("parallel", "period_ns"): ("family*coef_bits", "family*splines"),
}


def stages(passes, interval):
    return -(-passes // interval)


def wide_multipliers(run):
    """Equals count_multipliers in sysc/cost/cost_structure.cpp."""
    if run["build"] == "serial":
        return 1
    interval, order = run["SampleInterval"], run["Order"]
    if run["Mode"] == 0:
        count = 3 * stages(order, interval)
    else:
        count = 0
        if run["core"] != "spline":
            count += 1 + stages(order // 2, interval) + stages((order - 1) // 2, interval)
            count += 3 * {1: 3, 2: 2}.get(interval, 1)
        if run["core"] != "spherical":
            count += stages(order, interval) + 3 * stages(3, interval)
    return count + run["AuxAxes"]


def narrow_multipliers(run):
    """Equals count_multipliers in sysc/cost/cost_structure.cpp."""
    if run["build"] == "serial" or run["core"] == "spherical":
        return 0
    return 8 + (3 if run["Mode"] == 0 else 0)


def soft_bits(run):
    """Equals its namesake in sysc/cost/cost_structure.cpp."""
    width, low = run["CoefBits"], run["CoefBits"] - 18
    if run["family"] == "hx8k":
        return width * width
    if run["family"] == "gw2a-18" and low <= 3:
        return low * low if low == 3 else width * width - 18 * 18
    return 0


def wide_block(run):
    """Equals its namesake in sysc/cost/cost_structure.cpp."""
    return int(run["family"] == "lifcl-40" and run["CoefBits"] == 36)


def base(run):
    return {
        run["family"]: 1,
        "order": run["Order"],
        "coef_bits": run["CoefBits"],
        "fine_bits": run["PositionBits"] + run["GuardBits"],
        "axes": 3 + run["AuxAxes"],
        "samples": 1 / run["SampleInterval"],  # a clock
        "arcs": int(run["core"] != "spline"),
        "splines": int(run["core"] != "spherical"),
        "wide": wide_multipliers(run),
        "narrow": narrow_multipliers(run),
        "soft": soft_bits(run),
        "wide_block": wide_block(run),
    }


def value(feature, names):
    return math.prod(names.get(name, 0) for name in feature.split("*"))


def fit(runs, features, wanted, ridge):
    """Coefficients, none of a width below 0, that minimise the sum of squared relative errors."""
    features = list(features)
    used = features
    while True:
        found = dict(zip(used, least_squares(runs, used, wanted, ridge)))
        lowest = min((c, f) for f, c in found.items())
        if lowest[0] >= 0:
            return [found.get(f, 0.0) for f in features]
        used = [f for f in used if f != lowest[1]]


def least_squares(runs, features, wanted, ridge):
    scaled = [
        [value(f, base(run)) / y for f in features] for run, y in zip(runs, map(wanted, runs))
    ]
    count = range(len(features))
    gram = [[sum(row[i] * row[j] for row in scaled) for j in count] for i in count]
    right = [sum(row[i] for row in scaled) for i in count]
    for i in count:
        constant = features[i] in {run["family"] for run in runs}
        gram[i][i] += (1e-9 if constant else ridge) * max(gram[i][i], 1e-30)
    return numpy.linalg.solve(gram, right).tolist()  # the ridge makes it regular


def predict(coefficients, features, run):
    return sum(c * value(f, base(run)) for c, f in zip(coefficients, features))


def quantity_of(name):
    column = COUNTS[name]
    return (lambda run: 1000 / run[column]) if name == "period_ns" else lambda run: run[column]


def placed(run):
    return run["fmax_mhz"] is not None


def source(runs):
    held = sum(r["holdout"] for r in runs)
    how = "placed and routed" if placed(runs[0]) else "cells of Yosys, not placed"
    return f"fitted to {len(runs) - held} runs, {how}; {held} held out"


def rms(errors):
    return math.sqrt(sum(e * e for e in errors) / len(errors))


def model(build, name, runs):
    wanted = quantity_of(name)
    runs = [r for r in runs if r["build"] == build]
    fitted = [r for r in runs if not r["holdout"]]
    held = [r for r in runs if r["holdout"]]
    if not fitted:
        return None
    families = sorted({r["family"] for r in fitted})
    features = list(families)
    for feature in FEATURES[build, name]:
        own = [feature.replace("family", family) for family in families]
        features += own if "family" in feature else [feature]
    coefficients = fit(fitted, features, wanted, RIDGE[name])

    def error(run, by):
        return predict(by, features, run) / wanted(run) - 1

    if len(held) >= 3:
        errors, kind = [error(r, coefficients) for r in held], "holdout"
    else:
        errors, kind = [], "each left out"
        for one in fitted:
            others = [r for r in fitted if r is not one]
            if one["family"] in {r["family"] for r in others}:
                errors.append(error(one, fit(others, features, wanted, RIDGE[name])))
    if not errors:
        errors = [0.2]  # a single run: a guess
    return {
        "build": build,
        "quantity": name,
        "terms": [[f, float(f"{c:.6g}")] for f, c in zip(features, coefficients)],
        "error": round(rms(errors), 4),
        "worst": round(max(map(abs, errors)), 4),
        "families": {f: round(rms([error(r, coefficients) for r in runs if r["family"] == f]), 4)
                     for f in families},
        "fitted": round(rms([error(r, coefficients) for r in fitted]), 4),
        "checked": kind,
        "runs": len(fitted),
        "held_out": len(held),
    }


def read(path):
    runs = []
    with open(path, newline="") as stream:
        for line, row in enumerate(csv.DictReader(stream), 2):
            try:
                if row["failed"]:
                    continue
                run = {name: int(row[name]) for name in (*PARAMETERS, "lut4", "ff", "dsp", "bram")}
                run["fmax_mhz"] = float(row["fmax_mhz"]) if row["fmax_mhz"] else None
                device = DEVICES[row["device"]]
                run["family"] = device.cost_family
            except (KeyError, TypeError, ValueError) as error:
                sys.exit(f"{path}:{line}: error: not a run: {error}")
            run |= {"core": row["core"], "build": row["build"], "device": row["device"]}
            run["holdout"] = row["note"] == "holdout"
            if row["speed"] in ("", *map(str, device.speeds[:1])):
                runs.append(run)
    if not runs:
        sys.exit(f"{path}: error: no runs")
    return runs


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("runs", nargs="?", default=ROOT / "scripts/cost_runs.csv", metavar="CSV")
    parser.add_argument("-o", "--output", default=ROOT / "sysc/cost/cost_model.json")
    arguments = parser.parse_args()
    runs = read(arguments.runs)
    kinds = [[r for r in runs if placed(r)], [r for r in runs if not placed(r)]]
    models = [model(build, name, kind) for kind in kinds for build in ("serial", "parallel")
              for name in COUNTS if kind and (placed(kind[0]) or name != "period_ns")]
    models = [m for m in models if m]
    sources = {r["family"]: source(kind) for kind in kinds for r in kind}
    checks = []
    for one in runs:  # predictions that tb/model/program/cost_model_test.cpp must repeat
        predictions = {}
        for m in models:
            if m["build"] == one["build"] and one["family"] in m["families"]:
                features, coefficients = zip(*m["terms"])
                predictions[m["quantity"]] = round(predict(coefficients, features, one), 6)
        checks.append(
            {k: one[k] for k in ("core", "build", "device", *PARAMETERS, "lut4", "ff", "dsp")}
            | {"bram": one["bram"], "predicted": predictions}
        )
    lines = [f'{{"sources": {json.dumps(sources)},', ' "models": [']
    lines.append(",\n".join("  " + json.dumps(m) for m in models))
    lines.append(' ],\n "runs": [')
    lines.append(",\n".join("  " + json.dumps(c) for c in checks))
    lines.append(" ]}")
    pathlib.Path(arguments.output).write_text("\n".join(lines) + "\n")
    for m in models:
        print(
            f"{m['build']:8} {m['quantity']:9} fitted {m['fitted']:6.1%}, {m['checked']} rms"
            f" {m['error']:6.1%}, worst {m['worst']:6.1%}; {m['runs']} runs"
        )


if __name__ == "__main__":
    main()
