# SPDX-License-Identifier: Apache-2.0
"""The program curvecore, as it stands: `curvecore run part.ngc`, or python3 -m curvecore."""

import os
import sys

from curvecore import program


def main() -> None:
    os.execv(program(), [str(program()), *sys.argv[1:]])


if __name__ == "__main__":
    main()
