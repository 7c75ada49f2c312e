# SPDX-License-Identifier: Apache-2.0
"""core.json, as `curvecore choose -o` writes it (sysc/core/core_file.hpp)."""

import dataclasses
import json
from pathlib import Path

from synthesis.configuration import FORMS
from synthesis.cores import TOPS, parameters, top_of
from synthesis.refused import Refused


@dataclasses.dataclass
class CoreFile:
    name: str
    build: str
    device: str
    settings: dict


def core_file(file):
    """Returns the core of a file: its parameters that are not the defaults of its top, except the
    multipliers, which are the device's."""
    try:
        core = json.loads(Path(file).read_text())
        top, fixed = top_of(core["core"], core["build"])
        defaults = parameters(top) | fixed
        settings = {name: str(value) for name, value in core["parameters"].items()
                    if name not in FORMS and str(value) != defaults.get(name, str(value))}
        return CoreFile(core["core"], core["build"], core["device"], settings)
    except OSError as error:
        raise Refused(f"{file}: {error.strerror}") from None
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise Refused(f"{file}: is no core of curvecore choose: {error!r}") from None
