# SPDX-License-Identifier: Apache-2.0
"""The table of a core's parameters, of hls/README.md."""

from result_table import table
from synthesis.tables import parameters


def parameter_rows():
    return table(["parameter", "range", "default", "other values work with", "meaning"],
                 [[f"`{one.name}`", one.range(), one.default, one.works_with(), one.sentence]
                  for one in parameters().values()])
