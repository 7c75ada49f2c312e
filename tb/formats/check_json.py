#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds JSON files that curvecore wrote to the schemas of sysc/formats.

    check_json.py FILE..     exit status 1: one does not fit; the message names file, key and reason
"""

import functools
import json
import sys
from pathlib import Path

import fastjsonschema

SCHEMAS = Path(__file__).resolve().parents[2] / "sysc/formats"


@functools.lru_cache(maxsize=None)
def schema(name):
    return json.loads((SCHEMAS / f"{name}.schema.json").read_text())


@functools.lru_cache(maxsize=None)
def validator(name):
    return fastjsonschema.compile(schema(name), handlers={"": lambda file: schema(
        file.split(".")[0])})  # one schema names another's file


def name_of(file, data):
    """The schema of a file: its name's, but of the report of `stream`."""
    return "stream" if Path(file).name == "report.json" and "link" in data else Path(file).stem


def flaw(name, data):
    """Reason why the data does not fit the schema; empty: it fits."""
    try:
        validator(name)(data)
        return ""
    except fastjsonschema.JsonSchemaValueException as error:
        return error.message


def check(file):
    """Reason why a file does not fit its schema, with the path; empty: it fits."""
    data = json.loads(Path(file).read_text())
    name = name_of(file, data)
    found = flaw(name, data)
    return f"{file}: {found} (sysc/formats/{name}.schema.json)" if found else ""


def main():
    flaws = [found for found in map(check, sys.argv[1:]) if found]
    print("\n".join(flaws), file=sys.stderr)
    return 1 if flaws else 0


if __name__ == "__main__":
    sys.exit(main())
