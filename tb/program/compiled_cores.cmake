# SPDX-License-Identifier: Apache-2.0
# The cores inside `curvecore run`: the one table.  Each line is a Verilated motion_interpolator.
# `plan` and `words` need none and serve every legal configuration.
#    build     Order CoefBits PositionBits GuardBits AuxAxes Splines Mode SampleInterval TurnBits
#    ParameterGuard
set(COMPILED_CORES
    "parallel 6 36 32 10 0 0 0 1 0 0"
    "parallel 6 36 32 10 0 1 0 1 0 0"
    "parallel 6 36 32 10 3 1 0 1 0 0"
    "parallel 6 36 32 10 6 0 0 1 0 0"
    "parallel 4 36 32 10 0 0 0 1 0 0"
    "parallel 8 36 32 10 0 0 0 1 0 0"
    "parallel 6 27 32 10 0 0 0 1 0 0"
    "parallel 3 27 32 10 0 0 0 1 8 0"
    "parallel 6 36 32 10 0 0 1 1 0 0"
    "parallel 6 36 32 10 0 1 1 1 0 0"
    "parallel 4 28 32 10 0 1 1 1 0 4"
    "parallel 6 36 32 10 0 0 0 4 0 0"
    "serial   6 36 32 10 0 0 0 1 0 0"
    "serial   6 36 32 10 0 1 0 1 0 0"
    "serial   6 36 32 10 3 1 0 1 0 0"
    "serial   6 36 32 10 6 0 0 1 0 0"
    "serial   8 36 32 10 0 0 0 1 0 0"
    "serial   6 36 32 10 0 1 1 1 0 0")
