#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every Python package of scripts/versions.env that is installed finds what it requires in that
list too, or in PIP_LEFT_OUT: setup.sh installs the list alone, so what somebody installed by hand
would be missing on the next machine."""

import importlib.metadata
import pathlib
import re
import sys

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

VERSIONS = pathlib.Path(__file__).resolve().parent.parent.parent / "scripts/versions.env"


def listed(variable):
    """Name to version, of the words of one variable."""
    words = re.search(rf'^{variable}="\n(.*?)^"', VERSIONS.read_text(), re.M | re.S)[1].split()
    return {canonicalize_name(name): version
            for name, _, version in (word.partition("==") for word in words)}


def unmet(pinned, left_out):
    """Yields requirements of pinned packages that neither list has, or has in another version."""
    for name, version in pinned.items():
        package = importlib.metadata.distribution(name)
        if package.version != version:
            yield f"{name} {package.version} is installed, the list says {version}"
        for line in package.requires or ():
            wanted = Requirement(line)
            if wanted.marker and not wanted.marker.evaluate({"extra": ""}):
                continue
            if canonicalize_name(wanted.name) not in {**pinned, **left_out}:
                yield f"{name} requires {line}: neither in PIP_PACKAGES nor in PIP_LEFT_OUT"


def main():
    pinned, left_out = listed("PIP_PACKAGES"), listed("PIP_LEFT_OUT")
    faults = list(unmet(pinned, left_out))
    print(*faults, sep="\n")
    # The check sees a list that lacks one.
    lacking = {name: version for name, version in pinned.items() if name != "numpy"}
    return bool(faults) or not any("numpy" in fault for fault in unmet(lacking, left_out))


if __name__ == "__main__":
    sys.exit(main())
