# SPDX-License-Identifier: Apache-2.0
"""The cores as their sources declare them: modules, parameters and their ranges, files."""

import functools
import pathlib
import re

from synthesis.refused import Refused

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TOPS = {  # module, parameters
    ("spherical", "parallel"): ("spherical_interpolator", {}),
    ("spline", "parallel"): ("spline_interpolator", {}),
    ("curve", "parallel"): ("curve_interpolator", {}),
    ("spherical", "serial"): ("curve_interpolator_serial", {}),
    ("curve", "serial"): ("curve_interpolator_serial", {"Splines": "1", "Mode": "1"}),
    ("sine_cosine", "parallel"): ("sine_cosine_interpolator", {}),
    ("hyperbola", "parallel"): ("hyperbola_interpolator", {}),
}
CORES = tuple(dict.fromkeys(core for core, _ in TOPS))
BUILDS = tuple(dict.fromkeys(build for _, build in TOPS))
FORMS = ("MultiplierForm", "Form")


@functools.lru_cache(maxsize=None)
def files():
    return {path.stem: path for path in sorted(ROOT.glob("rtl/**/*.sv"))}


@functools.lru_cache(maxsize=None)
def text_of(module):
    return re.sub(r"//[^\n]*", "", files()[module].read_text())


def top_of(core, build):
    for name, value, known in (("core", core, CORES), ("build", build, BUILDS)):
        if value not in known:
            raise Refused(f"unknown {name} '{value}': one of {', '.join(known)}")
    if (core, build) not in TOPS:
        raise Refused(f"there is no {build} build of {core}")
    return TOPS[core, build]


def sources(*tops):
    """Files of some modules and of all that they name, packages first.

    A word that is the name of a module counts as a use of it, so that the list may be longer
    than needed, never shorter.
    """
    for top in tops:
        if top not in files():
            raise Refused(f"unknown module '{top}'")
    found, new = set(), set(tops)
    while new:
        found |= new
        new = {word for module in new for word in re.findall(r"\w+", text_of(module))
               if word in files()} - found
    return sorted((files()[name] for name in found),
                  key=lambda path: (not path.stem.endswith("_pkg"), path))


@functools.lru_cache(maxsize=None)
def parameters(top):
    """Returns the parameters of a module that are numbers, and the text of their defaults."""
    if top not in files():
        raise Refused(f"unknown module '{top}'")
    found = re.findall(r"^ +parameter\s+(?:\w+\s+)*?(\w+)\s*=\s*([^\s\",][^\",\n]*)",
                       text_of(top), re.M)
    return {name: default.strip() for name, default in found}


@functools.lru_cache(maxsize=None)
def range_checks(top):
    """(condition, message) of the elaboration checks of a module, or of the one it wraps."""
    pattern = r"initial\s+if\s*\(([^;]*?)\)\s*\$fatal\(1,\s*\"([^\"]*)\"\)"
    found = re.findall(pattern, text_of(top))
    if not found:
        wrapped = re.search(r"^  (\w+) #\(", text_of(top), flags=re.M)
        found = re.findall(pattern, text_of(wrapped[1])) if wrapped else []
    return [(re.sub(r"\s+", " ", condition.replace("||", " or ").replace("&&", " and ")), message)
            for condition, message in found]


def check_parameters(top, settings):
    """Refuses names that the module has not and values outside its ranges."""
    known = parameters(top)
    for name, value in settings.items():
        if name not in known:
            raise Refused(f"{top} has no parameter {name}: one of {', '.join(known)}")
        if not re.fullmatch(r"-?\d+", value):
            raise Refused(f"{name} must be a whole number, not '{value}'")
    values = {name: int(value) for name, value in (known | settings).items()
              if re.fullmatch(r"-?\d+", value.strip())}
    for condition, message in range_checks(top):
        names = set(re.findall(r"[A-Za-z_]\w*", condition)) - {"or", "and"}
        if names <= values.keys() and eval(condition, {"__builtins__": {}}, dict(values)):
            given = ", ".join(f"{name} is {values[name]}" for name in sorted(names))
            raise Refused(f"{message} ({given})")
