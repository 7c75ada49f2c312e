// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "sysc/cores/compiled_core.hpp"

namespace curvecore::sysc {
namespace {

/// Rank of a core by parameters that --set leaves open, the simpler core first.
std::pair<int, int> open_parameters(const CompiledCore& core) {
    return {core.parameters.splines, core.parameters.aux_axes};
}

bool serves(const CompiledCore& core, const Options& options) {
    CoreParameters wanted = options.core;
    wanted.multiplier_form = core.parameters.multiplier_form;  // its products are the same
    if (!options.splines_set) wanted.splines = std::max(wanted.splines, core.parameters.splines);
    if (!options.aux_axes_set) {
        wanted.aux_axes = std::max(wanted.aux_axes, core.parameters.aux_axes);
    }
    return wanted == core.parameters;
}

}  // namespace

const CompiledCore* find_core(const Options& options) {
    const CompiledCore* best = nullptr;
    for (const CompiledCore& core : compiled_cores()) {
        if (!serves(core, options)) continue;
        if (best == nullptr || open_parameters(core) < open_parameters(*best)) best = &core;
    }
    return best;
}

}  // namespace curvecore::sysc
