# SPDX-License-Identifier: Apache-2.0
# The cores inside `curvecore run`; it makes any other on demand (sysc/cache/core_cache.hpp).
# Parameters that are not named have their defaults (ref/format/parameters.def).
set(COMPILED_CORES "parallel" "parallel Splines=1")
