# SPDX-License-Identifier: Apache-2.0
"""JSON that a user gives: what is wrong with it is said with file and place."""

import json
from pathlib import Path

from synthesis.refused import Refused


def read_json(file):
    """The object in a file.  Raises Refused."""
    try:
        found = json.loads(Path(file).read_text(encoding="utf-8"))
    except OSError as error:
        raise Refused(f"{file}: {error.strerror}") from None
    except UnicodeDecodeError:
        raise Refused(f"{file}: error: not a text in UTF-8") from None
    except json.JSONDecodeError as error:
        raise Refused(f"{file}:{error.lineno}: error: column {error.colno}: is no JSON here:"
                      f" {error.msg}") from None
    if not isinstance(found, dict):
        raise Refused(f"{file}:1: error: an object is wanted: {{..}}")
    return found


def check_keys(table, needed, others, what):
    """Refuses an object that lacks a key, or has one that nobody reads."""
    for key in needed:
        if table.get(key) is None:
            raise Refused(f"'{key}' is missing")
    for key in table:
        if key not in (*needed, *others):
            raise Refused(f"'{key}': {what} has {', '.join((*needed, *others))}")
