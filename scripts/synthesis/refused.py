# SPDX-License-Identifier: Apache-2.0
"""Requests that are refused, with a message to the user."""


class Refused(Exception):
    """A configuration or a design that cannot be made; the text is the whole message."""


class TooLarge(Refused):
    """A design that has more cells than the device."""
