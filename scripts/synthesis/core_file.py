# SPDX-License-Identifier: Apache-2.0
"""core.json, as `curvecore choose -o` writes it (sysc/core/core_file.hpp)."""

import dataclasses

from synthesis.configuration import FORMS
from synthesis.cores import TOPS, parameters, top_of
from synthesis.json_file import read_json
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
    core = read_json(file)
    try:
        top, fixed = top_of(core["core"], core["build"])
        defaults = parameters(top) | fixed
        settings = {name: str(value) for name, value in core["parameters"].items()
                    if name not in FORMS and str(value) != defaults.get(name, str(value))}
        return CoreFile(core["core"], core["build"], core["device"], settings)
    except KeyError as error:
        raise Refused(f"{file}: is no core of curvecore choose: {error} is missing") from None
    except (ValueError, TypeError, AttributeError) as error:
        raise Refused(f"{file}: is no core of curvecore choose: {error}") from None
