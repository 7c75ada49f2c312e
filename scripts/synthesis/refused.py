# SPDX-License-Identifier: Apache-2.0
"""What cannot be done, said to the user."""


class Refused(Exception):
    """A configuration or a design that cannot be made; the text is the whole message."""


class TooLarge(Refused):
    """A design that has more cells than the device."""
