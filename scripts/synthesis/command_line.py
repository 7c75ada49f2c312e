# SPDX-License-Identifier: Apache-2.0
"""Common parts of the command lines of scripts/synth.py and scripts/hls.py."""

import argparse

from synthesis.refused import Refused


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise Refused(message)


def settings(items):
    """Reads `--set Name=Value`: values by name."""
    for item in items:
        if "=" not in item:
            raise Refused(f"--set {item}: must be Name=Value")
    return dict(item.split("=", 1) for item in items)


def number(name, text, low, high):
    if not str(text).isdecimal() or not low <= int(text) <= high:
        raise Refused(f"{name} '{text}' must be in [{low}, {high}]")
    return int(text)


def number_of_seeds(name, text, fewest=1):
    return number(name, text, fewest, 100)
