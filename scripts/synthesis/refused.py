# SPDX-License-Identifier: Apache-2.0
"""What cannot be done, said to the user."""


class Refused(Exception):
    """A wish or a design that cannot be met; the text is the whole message."""
