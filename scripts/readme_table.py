# SPDX-License-Identifier: Apache-2.0
"""What every table of README.md is made with."""

import json
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"


def load(path):
    file = BUILD / path
    return json.loads(file.read_text()) if file.exists() else None


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines)


def short(value):
    return f"{value:.3g}"
